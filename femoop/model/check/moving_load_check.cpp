#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/geometry/path_walk.h"
#include "femoop/model/check/check.h"
#include "femoop/model/check/checker.h"

namespace femoop {

void Checker::check_moving_loads()
{
    const MovingLoads& moving = model_.moving_loads;
    for (std::size_t i = 0; i < moving.paths.size(); ++i) {
        is_partial_ = flag(unreadable_.paths, i);
        check_path(moving.paths[i].members, {"paths", i, moving.paths[i].id});
    }
    for (std::size_t i = 0; i < moving.influence_lines.size(); ++i) {
        is_partial_ = flag(unreadable_.influence_lines, i);
        check_line(moving.influence_lines[i], {"influence_lines", i, moving.influence_lines[i].id});
    }
    check_trains();
}

bool Checker::check_path(const std::vector<MemberId>& members, const Entry& place)
{
    bool is_there = true;
    for (const MemberId member : members)
        is_there = require_entry(place, "members", member.index, model_.members.size()) && is_there &&
                   is_readable(member) && is_located(model_[member]);
    if (!is_there || (members.empty() && is_partial_)) return false;
    if (auto fault = why_no_path(model_, members, place.text())) {
        faults_.push_back(std::move(*fault));
        return false;
    }
    warn_of_bars(members, place);
    return true;
}

void Checker::warn_of_bars(const std::vector<MemberId>& members, const Entry& place)
{
    std::vector<std::string> bars;
    for (const MemberId member : members)
        if (model_[member].bar || is_truss(model_.analysis)) bars.push_back(model_[member].id);
    if (!bars.empty()) add(FaultKind::BarLoadedBetweenNodes, place, {listed(bars)});
}

void Checker::check_line(const InfluenceLineDefinition& line, const Entry& place)
{
    check_effect(line.effect, place);
    check_moving_load(line.path, line.load, place);
}

void Checker::check_effect(const MovingEffect& effect, const Entry& place)
{
    Expected asked{.quantity = effect.quantity,
                   .node = effect.node,
                   .dof = effect.dof,
                   .member = effect.member,
                   .component = effect.component,
                   .at = effect.at};
    asked.extreme = ExtremeKind::Max; // a moving load has both
    check_asked(asked, place);
}

void Checker::check_moving_load(const LoadPathReference& path, const std::vector<Component>& load, const Entry& place)
{
    require_distinct(place, load);
    bool has_direction = load.empty();
    for (const Component& component : load) {
        check_load_dof(component.dof, LoadAxes::Global, force_name(component.dof), place);
        require_finite(place, force_name(component.dof), component.value);
        has_direction = has_direction || component.value.value() != 0.0;
    }
    if (!has_direction) add(FaultKind::UnitLoadZero, place, {});
    const auto check_torques = [&](const std::vector<MemberId>& members) {
        for (const MemberId member : members) check_torque(model_[member], LoadAxes::Global, load, place);
    };
    if (const auto* members = std::get_if<std::vector<MemberId>>(&path)) {
        if (check_path(*members, place)) check_torques(*members);
        return;
    }
    const std::size_t i = std::get<PathId>(path).index;
    const std::vector<LoadPath>& paths = model_.moving_loads.paths;
    if (!require_entry(place, "paths", i, paths.size()) || flag(unreadable_.paths, i)) return;
    const bool is_whole = std::ranges::all_of(paths[i].members, [&](MemberId m) { return is_readable(m); });
    if (is_whole) check_torques(paths[i].members);
}

std::vector<Fault> check_line(const Model& model, const InfluenceLineDefinition& line, const PartName& part)
{
    const Unreadable nothing;
    return Checker(model, nothing).run_line(line, {part.list, part.index, {}});
}

std::vector<Fault> Checker::run_line(const InfluenceLineDefinition& line, const Entry& place)
{
    check_line(line, place);
    return std::move(faults_);
}

} // namespace femoop
