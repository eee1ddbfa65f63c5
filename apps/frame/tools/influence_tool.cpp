#include "apps/frame/tools/influence_tool.h"

#include <cmath>
#include <utility>

#include "apps/frame/influence/asked_envelope.h"
#include "apps/frame/tools/snap.h"
#include "femoop/geometry/member_geometry.h"

namespace frame {

std::optional<Change> InfluenceTool::press(const Work& work, const Aim& at)
{
    if (at.is_on_train) pull_ = pull_of(*work.influence, at);
    else ask(work, at);
    pressed_ = work.influence;
    before_ = *pressed_;
    return std::nullopt;
}

void InfluenceTool::ask(const Work& work, const Aim& at)
{
    const femoop::Model& model = work.document.model;
    if (at.node) work.influence->ask(model, *at.node);
    else if (at.support) work.influence->ask(model, at.support->node);
    else if (at.cut) {
        held_ = at.cut->member;
        const double length = femoop::geometry_of(model, model[*held_]).length;
        work.influence->ask(model, drawing::Cut{*held_, round_section(at.cut->x, length, at)});
    }
    if (work.train_envelope != nullptr) stand_governing(work);
}

// What is asked for in an envelope of trains has the train that governs there.
void InfluenceTool::stand_governing(const Work& work)
{
    const femoop::Model& model = work.document.model;
    const std::optional<femoop::MovingEffect> effect = work.influence->effect(model);
    if (!effect || effect->quantity == femoop::ExpectedQuantity::Displacement) return;
    work.influence->ask(model, *effect, work.train_envelope->governing(model, *effect));
}

bool InfluenceTool::escape()
{
    if (pressed_ == nullptr) return false;
    *std::exchange(pressed_, nullptr) = before_;
    held_.reset();
    pull_.reset();
    return true;
}

bool InfluenceTool::takes_hold(const Work&, const Aim& at) const { return at.is_on_train || at.points_at_section(); }

std::optional<InfluenceTool::Pull> InfluenceTool::pull_of(const AskedLine& line, const Aim& at)
{
    const drawing::StandingTrain* const train = line.standing();
    if (train == nullptr || !train->placing.position) return std::nullopt;
    return Pull{*train->placing.position - line.nearest_on_path(at.projection, at.on_sheet)};
}

// To the critical place where the leading axle comes near to it, else to round ones; Alt takes the place as it is.
void InfluenceTool::pull_train(AskedLine& line, const Pull& pull, const Aim& to)
{
    constexpr double fine = 2.0, reach = 6.0; // [px]
    const bool is_reversed = line.standing()->placing.reversed;
    double position = line.nearest_on_path(to.projection, to.on_sheet) + pull.ahead;
    const std::optional<AskedTrain::Place> worst = line.worst_place();
    if (!to.is_exact) {
        const double step = round_grid(fine * to.pixel);
        const bool is_near_worst = worst && worst->reversed == is_reversed &&
                                   std::abs(worst->position - position) <= reach * to.pixel;
        position = is_near_worst ? worst->position : step * std::round(position / step);
    }
    line.put_train({position, is_reversed});
}

std::optional<Change> InfluenceTool::move(const Work& work, const Aim& to)
{
    if (pull_ && work.influence->standing() != nullptr) {
        pull_train(*work.influence, *pull_, to);
        return std::nullopt;
    }
    if (const auto section = held_ ? section_under(work.document.model, *held_, to) : std::nullopt)
        work.influence->ask(work.document.model, *section);
    return std::nullopt;
}

std::optional<Change> InfluenceTool::release(const Work&, const Aim&)
{
    held_.reset();
    pull_.reset();
    pressed_ = nullptr;
    return std::nullopt;
}

} // namespace frame
