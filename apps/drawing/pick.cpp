#include "apps/drawing/pick.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

constexpr double node_reach = 9.0;      // [px]
constexpr double member_reach = 8.0;    // [px]
constexpr double ordinate_reach = 45.0; // [px] over a diagram

struct Near {
    double distance;
    double nearness; ///< to the eye
    double share;    ///< along the member
};

Near near_segment(ui::Point a, ui::Point b, ui::Point cursor)
{
    const ui::Point along = b - a;
    const double square = ui::dot(along, along);
    const double t = square > 0.0 ? std::clamp(ui::dot(cursor - a, along) / square, 0.0, 1.0) : 0.0;
    return {ui::distance(cursor, a + t * along), 0.0, t};
}

// Of two that are about equally far from the cursor the one in front.
bool is_better(const Near& a, const Near& b)
{
    constexpr double same = 3.0; // [px]
    if (std::abs(a.distance - b.distance) > same) return a.distance < b.distance;
    return a.nearness > b.nearness || (a.nearness == b.nearness && a.distance < b.distance);
}

std::optional<femoop::NodeId> nearest_node(const StructureShape& shape, const Projection& projection, ui::Point cursor)
{
    std::optional<femoop::NodeId> found;
    Near best{};
    for (std::size_t i = 0; i < shape.nodes.size(); ++i) {
        const Near now{ui::distance(projection(shape.nodes[i]), cursor), projection.nearness(shape.nodes[i]), 0.0};
        if (now.distance > node_reach || (found && !is_better(now, best))) continue;
        best = now;
        found = femoop::NodeId{i};
    }
    return found;
}

std::optional<Cut> nearest_member(const StructureShape& shape, const Projection& projection, ui::Point cursor,
                                  double reach)
{
    std::optional<Cut> found;
    Near best{};
    for (std::size_t i = 0; i < shape.members.size(); ++i) {
        const MemberShape& member = shape.members[i];
        Near now = near_segment(projection(member.start), projection(member.end), cursor);
        now.nearness = projection.nearness(member.at(now.share * member.length));
        if (now.distance > reach || (found && !is_better(now, best))) continue;
        best = now;
        found = Cut{femoop::MemberId{i}, now.share * member.length};
    }
    return found;
}

bool shows_results(const ShowSet& show)
{
    for (const Show item :
         {Show::N, Show::V, Show::M, Show::T, Show::Vy, Show::Vz, Show::My, Show::Mz, Show::Deformed, Show::Thrust})
        if (show.contains(item)) return true;
    return false;
}

} // namespace

Pick pick(const StructureShape& shape, const Projection& projection, ui::Point cursor, const ShowSet& shown)
{
    if (const auto node = nearest_node(shape, projection, cursor)) return {.node = node, .cut = std::nullopt};
    if (const auto cut = nearest_member(shape, projection, cursor, member_reach))
        return {.node = std::nullopt, .cut = cut, .is_on_member = true};
    if (!shows_results(shown)) return {};
    return {.node = std::nullopt, .cut = nearest_member(shape, projection, cursor, ordinate_reach)};
}

} // namespace drawing
