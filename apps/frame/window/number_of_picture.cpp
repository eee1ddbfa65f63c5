#include "apps/frame/window/number_of_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_cases.h"
#include "apps/frame/influence/asked_line.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/result/components.h"

namespace frame {

using femoop::MemberComponent;
using femoop::MovingEffect;

namespace {

constexpr double reach = 3.0; // [px] beside what is written

/// Of an envelope of cases it is a number of the case that makes it.
std::optional<PointedNumber> written_number(const Session& session, const Grips& grips, ui::Point at)
{
    const auto under = [&](const NumberMark& mark) { return mark.box.grown(reach).contains(at); };
    const auto found = std::ranges::find_if(grips.numbers, under);
    if (found == grips.numbers.end()) return std::nullopt;
    PointedNumber number{found->number};
    if (!found->end) return number;
    number.extreme = found->end->kind;
    if (!session.shows_train_envelope())
        number.of = drawing::envelope_cases(session.model(), session.view)[found->end->made_by];
    return number;
}

/// The ordinate at a place of the path.
std::optional<PointedNumber> ordinate_at(const Session& session, const std::optional<Cut>& cut, const Aim& aim)
{
    const drawing::InfluencePicture* const line = session.shown_line();
    if (line == nullptr || session.hidden || !cut || session.influence.standing() != nullptr) return std::nullopt;
    const double length = femoop::geometry_of(session.model(), session.model()[cut->member]).length;
    const std::vector<double> places = line->path.places_of(cut->member, round_section(cut->x, length, aim));
    if (places.empty()) return std::nullopt;
    return PointedNumber{.effect = line->line.effect,
                         .under = LoadOnLine{.place = {.position = places.front()}, .is_unit_load = true}};
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

std::optional<MovingEffect> number_under(const femoop::Model& model, const Subject::Plan& plan, ui::Point at,
                                         const Pick& under, const Aim& aim)
{
    if (under.node) return foremost_effect(model, *under.node);
    if (aim.support) return foremost_effect(model, aim.support->node);
    if (!under.cut) return std::nullopt;
    const auto component = shown_component(plan, at, model.analysis);
    const double length = femoop::geometry_of(model, model[under.cut->member]).length;
    return number_at_section(*under.cut, component.value_or(*foremost_effect(model, *under.cut)->component), length);
}

} // namespace

std::optional<PointedNumber> number_of_picture(const Session& session, const NumbersOfPicture& picture, ui::Point at,
                                               const Pick& under, const Aim& aim)
{
    const femoop::Model& model = session.model();
    if (session.influence.is_on(model)) return ordinate_at(session, under.cut, aim);
    if (session.shown_results() == nullptr || session.hidden) return std::nullopt;
    if (const auto written = written_number(session, picture.grips, at)) return written;
    const auto number = session.shows_train_envelope() ? number_of_envelope(session, picture.plan, at, under, aim)
                                                       : number_under(model, picture.plan, at, under, aim);
    return number ? std::optional(PointedNumber{*number}) : std::nullopt;
}

} // namespace frame
