#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "femoop/model/check/checker.h"

namespace femoop {

namespace {

using Point = std::array<double, 3>;

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point along(const Point& a, const Point& d, double t) { return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double size(const Point& a) { return std::sqrt(dot(a, a)); }

/// A cell of a regular grid; the grid holds no cells, only their names.
using Cell = std::uint64_t;

class Grid {
public:
    Grid(const Point& corner, double cell_size) : corner_(corner), size_(cell_size) {}

    std::int64_t step(double x, std::size_t axis) const
    {
        constexpr double farthest = 1e15; // what an integer holds
        return static_cast<std::int64_t>(std::clamp(std::floor((x - corner_[axis]) / size_), -farthest, farthest));
    }
    // Two cells may share a name (the counts wrap at 2^21): they are only searched together.
    static Cell cell(std::int64_t i, std::int64_t j, std::int64_t k)
    {
        constexpr std::uint64_t mask = (1U << 21U) - 1U;
        const auto part = [](std::int64_t n) { return static_cast<std::uint64_t>(n) & mask; };
        return (part(i) << 42U) | (part(j) << 21U) | part(k);
    }

    /// Every cell that the box from `a` to `b`, made `margin` larger, touches.
    template <class Visit> void for_each_cell(const Point& a, const Point& b, double margin, Visit visit) const
    {
        std::array<std::int64_t, 3> low{}, high{};
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = step(std::min(a[i], b[i]) - margin, i);
            high[i] = step(std::max(a[i], b[i]) + margin, i);
        }
        for (std::int64_t i = low[0]; i <= high[0]; ++i)
            for (std::int64_t j = low[1]; j <= high[1]; ++j)
                for (std::int64_t k = low[2]; k <= high[2]; ++k) visit(cell(i, j, k));
    }

private:
    Point corner_;
    double size_;
};

struct Box {
    Point low, high;
    double diagonal() const { return size(minus(high, low)); }
};

Box box_around(const std::vector<Point>& points)
{
    constexpr double far = std::numeric_limits<double>::max();
    Box box{{far, far, far}, {-far, -far, -far}};
    for (const Point& point : points)
        for (std::size_t i = 0; i < 3; ++i) {
            box.low[i] = std::min(box.low[i], point[i]);
            box.high[i] = std::max(box.high[i], point[i]);
        }
    return box;
}

/// A member's line between its nodes.
struct Line {
    std::uint32_t member = 0;
    std::array<NodeId, 2> nodes;
    Point start{}, direction{}; ///< start + t direction, t in [0, 1]
    double length = 0.0;
};

enum class MemberMeeting : std::uint8_t { None, Cross, FirstEndsOnSecond, SecondEndsOnFirst, Overlap };

struct Encounter {
    MemberMeeting kind = MemberMeeting::None;
    Point place{};
    NodeId node; ///< that lies on the other member
};

bool is_inside(double t, double slack) { return t > slack && t < 1.0 - slack; }

constexpr double nearness = 1e-6; // of the shorter member's length: lines that near touch

/// Lines on one straight line: do they share more than a point?
Encounter overlap(const Line& a, const Line& b)
{
    const double from = dot(minus(b.start, a.start), a.direction) / (a.length * a.length);
    const double to = dot(minus(along(b.start, b.direction, 1.0), a.start), a.direction) / (a.length * a.length);
    const double begin = std::max(0.0, std::min(from, to)), end = std::min(1.0, std::max(from, to));
    const double shorter = std::min(a.length, b.length) / a.length;
    if (end - begin <= nearness * shorter) return {};
    return {MemberMeeting::Overlap, along(a.start, a.direction, 0.5 * (begin + end)), {}};
}

/// Where two lines come nearest, if that is a touch inside at least one of them.
Encounter meet(const Line& a, const Line& b)
{
    const double tolerance = nearness * std::min(a.length, b.length);
    const Point r = minus(a.start, b.start);
    const double aa = dot(a.direction, a.direction), ab = dot(a.direction, b.direction),
                 bb = dot(b.direction, b.direction);
    const double ra = dot(r, a.direction), rb = dot(r, b.direction);
    const double sine_squared = 1.0 - ab * ab / (aa * bb);
    if (sine_squared < nearness * nearness) {
        const double t = dot(minus(b.start, a.start), a.direction) / aa;
        const bool is_one_line = size(minus(b.start, along(a.start, a.direction, t))) <= tolerance;
        return is_one_line ? overlap(a, b) : Encounter{};
    }
    const double determinant = aa * bb * sine_squared;
    const double s = std::clamp((ab * rb - bb * ra) / determinant, 0.0, 1.0);
    const double t = std::clamp((ab * s + rb) / bb, 0.0, 1.0);
    const double s_again = std::clamp((ab * t - ra) / aa, 0.0, 1.0);
    const Point on_a = along(a.start, a.direction, s_again), on_b = along(b.start, b.direction, t);
    if (size(minus(on_a, on_b)) > tolerance) return {};
    const bool inside_a = is_inside(s_again, tolerance / a.length), inside_b = is_inside(t, tolerance / b.length);
    if (inside_a && inside_b) return {MemberMeeting::Cross, on_a, {}};
    if (inside_a) return {MemberMeeting::SecondEndsOnFirst, on_b, b.nodes[t < 0.5 ? 0 : 1]};
    if (inside_b) return {MemberMeeting::FirstEndsOnSecond, on_a, a.nodes[s_again < 0.5 ? 0 : 1]};
    return {};
}

constexpr std::size_t most_comparisons = 5'000'000; // a tenth of a second or two
constexpr std::size_t most_pairs = 10'000;          // then the search ends
constexpr std::size_t most_warnings = 50;           // then only their number

struct Pair {
    std::uint32_t first = 0, second = 0; ///< lines
    Encounter encounter;
};

using Placed = std::pair<Cell, std::uint32_t>; ///< a line in a cell

/// Each line is laid into the cells of a grid whose size is the lines' mean length.
std::vector<Placed> placed(const std::vector<Line>& lines)
{
    std::vector<Point> points;
    double total = 0.0;
    for (const Line& line : lines) {
        points.push_back(line.start);
        points.push_back(along(line.start, line.direction, 1.0));
        total += line.length;
    }
    const double cell_size = total / static_cast<double>(lines.size());
    const Grid grid(box_around(points).low, cell_size);
    std::vector<Placed> places;
    places.reserve(4 * lines.size());
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        const auto n_pieces = static_cast<int>(std::ceil(lines[i].length / cell_size));
        for (int piece = 0; piece < n_pieces; ++piece) {
            const Point a = along(lines[i].start, lines[i].direction, static_cast<double>(piece) / n_pieces);
            const Point b = along(lines[i].start, lines[i].direction, static_cast<double>(piece + 1) / n_pieces);
            grid.for_each_cell(a, b, nearness * lines[i].length, [&](Cell cell) { places.emplace_back(cell, i); });
        }
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

struct Search {
    std::vector<Pair> pairs;
    bool is_complete = true;
};

/// The lines that meet otherwise than at a common end. Only lines that share a cell are compared: that is linear for
/// structures as people build them, and cut short for others.
Search search(const std::vector<Line>& lines)
{
    Search found;
    std::size_t comparisons = 0;
    const std::vector<Placed> places = placed(lines);
    for (auto first = places.begin(); first != places.end(); ++first)
        for (auto second = first + 1; second != places.end() && second->first == first->first; ++second) {
            if (++comparisons > most_comparisons || found.pairs.size() == most_pairs) {
                found.is_complete = false;
                return found;
            }
            const Encounter encounter = meet(lines[first->second], lines[second->second]);
            if (encounter.kind != MemberMeeting::None)
                found.pairs.push_back({first->second, second->second, encounter});
        }
    return found;
}

/// In the lines' order, each pair once although it may share several cells.
void sort_pairs(std::vector<Pair>& pairs)
{
    const auto key = [](const Pair& pair) { return std::pair(pair.first, pair.second); };
    std::sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) { return key(a) < key(b); });
    const auto end = std::unique(pairs.begin(), pairs.end(),
                                 [&](const Pair& a, const Pair& b) { return key(a) == key(b); });
    pairs.erase(end, pairs.end());
}

} // namespace

void Checker::check_coincident_nodes()
{
    std::vector<Point> points;
    std::vector<std::uint32_t> owners;
    for (std::uint32_t i = 0; i < model_.nodes.size(); ++i) {
        if (!is_readable(NodeId(i)) || !is_within_reach(NodeId(i))) continue;
        const Node& node = model_.nodes[i];
        points.push_back({node.at[0], node.at[1], is_3d(model_.analysis) ? node.at[2].value() : 0.0});
        owners.push_back(i);
    }
    if (points.size() < 2) return;
    const Box box = box_around(points);
    const double extent = std::max(box.diagonal(), std::numeric_limits<double>::min());
    constexpr double largest_structure = 1e4; // one node that is far away moves no others together
    const double tolerance = 1e-9 * std::min(extent, largest_structure);
    const Grid grid(box.low, 1e-5 * extent);
    std::unordered_map<Cell, std::vector<std::uint32_t>> nodes_in;
    nodes_in.reserve(points.size());
    std::size_t comparisons = 0;
    for (std::uint32_t i = 0; i < points.size() && comparisons < most_comparisons; ++i) {
        std::optional<std::uint32_t> twin;
        grid.for_each_cell(points[i], points[i], tolerance, [&](Cell cell) {
            const auto found = nodes_in.find(cell);
            if (found == nodes_in.end()) return;
            for (const std::uint32_t other : found->second) {
                ++comparisons;
                if (!twin && size(minus(points[i], points[other])) <= tolerance) twin = other;
            }
        });
        if (twin)
            add(FaultKind::CoincidentNodes, {"nodes", owners[i], model_.nodes[owners[i]].id},
                {model_.nodes[owners[*twin]].id, shown(points[i])});
        else
            nodes_in[Grid::cell(grid.step(points[i][0], 0), grid.step(points[i][1], 1), grid.step(points[i][2], 2))]
                .push_back(i);
    }
}

void Checker::check_crossings()
{
    std::vector<Line> lines;
    for (std::size_t i = 0; i < model_.members.size(); ++i) {
        const Member& member = model_.members[i];
        if (!is_located(member) || !is_within_reach(member.nodes[0]) || !is_within_reach(member.nodes[1])) continue;
        const Axis whole = node_axis(member);
        if (whole.length == 0.0) continue;
        lines.push_back(
            {static_cast<std::uint32_t>(i), member.nodes, whole.start, minus(whole.end, whole.start), whole.length});
    }
    if (lines.size() < 2) return;
    std::set<std::pair<std::uint32_t, NodeId>> passed; // several members may end at a node that another one passes
    std::size_t n_warnings = 0;
    auto [pairs, is_complete] = search(lines);
    sort_pairs(pairs);
    for (const auto& [first, second, encounter] : pairs) {
        const bool ends_on_first = encounter.kind == MemberMeeting::SecondEndsOnFirst;
        const bool ends_inside = ends_on_first || encounter.kind == MemberMeeting::FirstEndsOnSecond;
        const std::uint32_t passing = lines[ends_on_first ? first : second].member, other = lines[first].member;
        if (ends_inside && !passed.insert({passing, encounter.node}).second) continue;
        if (++n_warnings > most_warnings) continue;
        const Entry place{"members", passing, model_.members[passing].id};
        if (ends_inside) add(FaultKind::MemberPassesNode, place, {model_[encounter.node].id, shown(encounter.place)});
        else
            add(encounter.kind == MemberMeeting::Cross ? FaultKind::MembersCross : FaultKind::MembersOverlap, place,
                {model_.members[other].id, shown(encounter.place)});
    }
    if (n_warnings <= most_warnings) return;
    const std::size_t n_more = n_warnings - most_warnings;
    faults_.push_back({FaultKind::MoreCrossings, {std::to_string(n_more) + (is_complete ? "" : "+")}});
}

} // namespace femoop
