#include "femoop/geometry/path_walk.h"

#include <array>

namespace femoop {

namespace {

PathWalk walk_from(const Model& model, const std::vector<MemberId>& members, bool first_is_reversed)
{
    PathWalk walk{.is_reversed = {first_is_reversed}, .n_passed = 1};
    NodeId at = model[members[0]].nodes[first_is_reversed ? 0 : 1];
    for (; walk.n_passed < members.size(); ++walk.n_passed) {
        const std::array<NodeId, 2>& nodes = model[members[walk.n_passed]].nodes;
        const bool turns_back = members[walk.n_passed] == members[walk.n_passed - 1];
        if (turns_back || (nodes[0] != at && nodes[1] != at)) return walk;
        walk.is_reversed.push_back(nodes[0] != at);
        at = nodes[walk.is_reversed.back() ? 0 : 1];
    }
    return walk;
}

std::string ends_text(const Model& model, MemberId member)
{
    const auto& nodes = model[member].nodes;
    return model[nodes[0]].id + " - " + model[nodes[1]].id;
}

} // namespace

PathWalk walk(const Model& model, const std::vector<MemberId>& members)
{
    if (members.empty()) return {};
    PathWalk forwards = walk_from(model, members, false), backwards = walk_from(model, members, true);
    return backwards.n_passed > forwards.n_passed ? backwards : forwards;
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

} // namespace femoop
