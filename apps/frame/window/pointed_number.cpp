#include "apps/frame/window/pointed_number.h"

#include <algorithm>
#include <array>

#include "apps/drawing/results/diagram.h"
#include "apps/frame/influence/asked_line.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/result/components.h"

namespace frame {

using femoop::MemberComponent;
using femoop::MovingEffect;

namespace {

constexpr double reach = 3.0; // [px] beside what is written

std::optional<MovingEffect> written_number(const Grips& grips, ui::Point at)
{
    const auto under = [&](const NumberMark& mark) { return mark.box.grown(reach).contains(at); };
    const auto found = std::ranges::find_if(grips.numbers, under);
    return found == grips.numbers.end() ? std::nullopt : std::optional(found->number);
}

/// What the panel under the pointer shows along members.
std::optional<MemberComponent> shown_component(const Subject::Plan& plan, ui::Point at, femoop::AnalysisKind kind)
{
    constexpr std::array diagrams{Show::M, Show::V, Show::N, Show::T, Show::Mz, Show::My, Show::Vy, Show::Vz};
    const auto panel = std::ranges::find_if(plan.panels, [&](const Panel& one) { return one.box.contains(at); });
    if (panel == plan.panels.end()) return std::nullopt;
    for (const Show item : diagrams) {
        const std::vector<MemberComponent> shown = components(item, kind);
        if (panel->show.contains(item) && !shown.empty()) return shown.back();
    }
    return panel->show.contains(Show::Deformed) ? std::optional(MemberComponent::v) : std::nullopt;
}

/// An envelope of trains has section forces and reactions.
std::optional<MovingEffect> number_of_envelope(const Session& session, const Subject::Plan& plan, ui::Point at,
                                               const Pick& under, const Aim& aim)
{
    const femoop::Model& model = session.model();
    const std::optional<femoop::NodeId> node = aim.support ? std::optional(aim.support->node) : under.node;
    if (node) {
        const auto number = foremost_effect(model, *node);
        return number && number->quantity == femoop::ExpectedQuantity::Reaction ? number : std::nullopt;
    }
    if (!under.cut) return std::nullopt;
    const auto shown = shown_component(plan, at, model.analysis);
    const MemberComponent component = shown && !femoop::is_displacement(*shown)
                                          ? *shown
                                          : *foremost_effect(model, *under.cut)->component;
    return number_at_section(*under.cut, component, femoop::geometry_of(model, model[under.cut->member]).length);
}

} // namespace

std::optional<MovingEffect> pointed_number(const Session& session, const NumbersOfPicture& picture, ui::Point at,
                                           const Pick& under, const Aim& aim)
{
    const femoop::Model& model = session.model();
    const bool has_numbers = session.shown_results() != nullptr && !session.hidden && !session.influence.is_on(model);
    if (!has_numbers) return std::nullopt;
    if (session.shows_train_envelope()) return number_of_envelope(session, picture.plan, at, under, aim);
    if (const auto written = written_number(picture.grips, at)) return written;
    if (under.node) return foremost_effect(model, *under.node);
    if (aim.support) return foremost_effect(model, aim.support->node);
    if (!under.cut) return std::nullopt;
    const auto component = shown_component(picture.plan, at, model.analysis);
    const double length = femoop::geometry_of(model, model[under.cut->member]).length;
    return number_at_section(*under.cut, component.value_or(*foremost_effect(model, *under.cut)->component), length);
}

} // namespace frame
