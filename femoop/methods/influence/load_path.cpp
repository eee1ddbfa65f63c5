#include "femoop/methods/influence/load_path.h"

#include <algorithm>
#include <utility>

#include "femoop/geometry/member_geometry.h"
#include "femoop/geometry/path_walk.h"

namespace femoop::influence {

namespace {

constexpr double end_place = 1e-12; // of the path's length

} // namespace

PathPlace PathLayout::place(double s, Side side) const
{
    const double near = end_place * length();
    std::size_t i = 0;
    while (i + 1 < members.size() && (side == Side::After ? s >= members[i].end() - near : s > members[i].end() + near))
        ++i;
    const PathMember& on = members[i];
    return {.index = i, .member = on.member, .x = std::clamp(on.x_of(s), 0.0, on.length)};
}

std::vector<double> PathLayout::nodes() const
{
    std::vector<double> places{0.0};
    for (const PathMember& member : members) places.push_back(member.end());
    return places;
}

std::vector<double> PathLayout::places_of(MemberId m, double x) const
{
    std::vector<double> places;
    for (const PathMember& on : members)
        if (on.member == m) places.push_back(on.s_of(x));
    return places;
}

const std::vector<MemberId>& members_of(const Model& model, const LoadPathReference& path)
{
    if (const auto* id = std::get_if<PathId>(&path)) return model.moving_loads.paths[id->index].members;
    return std::get<std::vector<MemberId>>(path);
}

PathLayout lay_out(const Model& model, const std::vector<MemberId>& members)
{
    if (auto fault = why_no_path(model, members, "path")) throw ModelError({std::move(*fault)});
    const PathWalk way = walk(model, members);
    PathLayout layout;
    for (std::size_t i = 0; i < members.size(); ++i)
        layout.members.push_back({.member = members[i],
                                  .is_reversed = way.is_reversed[i],
                                  .begin = layout.length(),
                                  .length = geometry_of(model, model[members[i]]).length});
    return layout;
}

NodeVector unit_load(AnalysisKind kind, const std::vector<Component>& components)
{
    NodeVector load{};
    if (components.empty()) load[index(is_plane(kind) ? Dof::uy : Dof::uz)] = -1.0;
    for (const Component& component : components) load[index(component.dof)] += component.value;
    return load;
}

} // namespace femoop::influence
