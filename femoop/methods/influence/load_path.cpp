#include "femoop/methods/influence/load_path.h"

#include <algorithm>
#include <array>
#include <utility>

#include "femoop/geometry/member_geometry.h"

namespace femoop::influence {

namespace {

constexpr double end_place = 1e-12; // of the path's length

/// The members of a path as they are passed, as far as they follow one another.
struct Walk {
    std::vector<bool> is_reversed;
    std::size_t n_passed = 0; ///< fewer than there are: the next one does not follow
};

Walk walk_from(const Model& model, const std::vector<MemberId>& members, bool first_is_reversed)
{
    Walk walk{.is_reversed = {first_is_reversed}, .n_passed = 1};
    NodeId at = model[members[0]].nodes[first_is_reversed ? 0 : 1];
    for (; walk.n_passed < members.size(); ++walk.n_passed) {
        const std::array<NodeId, 2>& nodes = model[members[walk.n_passed]].nodes;
        if (nodes[0] != at && nodes[1] != at) return walk;
        walk.is_reversed.push_back(nodes[0] != at);
        at = nodes[walk.is_reversed.back() ? 0 : 1];
    }
    return walk;
}

/// The way that gets farther; along the first member's own direction where both do.
Walk walk(const Model& model, const std::vector<MemberId>& members)
{
    Walk forwards = walk_from(model, members, false), backwards = walk_from(model, members, true);
    return backwards.n_passed > forwards.n_passed ? backwards : forwards;
}

std::string ends_text(const Model& model, MemberId member)
{
    const auto& nodes = model[member].nodes;
    return model[nodes[0]].id + "-" + model[nodes[1]].id;
}

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

std::optional<Fault> why_no_path(const Model& model, const std::vector<MemberId>& members, const std::string& place)
{
    if (members.empty()) return Fault{FaultKind::PathWithoutMembers, {place}};
    const std::size_t n = walk(model, members).n_passed;
    if (n == members.size()) return std::nullopt;
    const MemberId last = members[n - 1], next = members[n];
    return Fault{FaultKind::PathBroken,
                 {place, model[last].id, ends_text(model, last), model[next].id, ends_text(model, next)}};
}

PathLayout lay_out(const Model& model, const std::vector<MemberId>& members)
{
    if (auto fault = why_no_path(model, members, "path")) throw ModelError({std::move(*fault)});
    const Walk way = walk(model, members);
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
