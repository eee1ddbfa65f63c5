#include "femoop/plane/result/triangulated_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "femoop/element/continuum/element_geometry.h"
#include "femoop/plane/analysis/result_reader.h"
#include "femoop/plane/mesh/edge_table.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

using Eigen::Vector2d;

/// A place of an element's pattern: a node, a place on a side between two corners, or one of its own.
struct PatternPoint {
    NaturalPoint at;
    Shape::Values N;
    std::optional<int> node{};
    std::optional<int> side{}; ///< from corner `side` on
    int part = 0;              ///< along the side
};

/// How elements of a kind are cut.
struct Pattern {
    std::vector<PatternPoint> points;
    std::vector<std::array<int, 3>> triangles;
};

PatternPoint pattern_point(const Shape& shape, NaturalPoint at, int parts)
{
    constexpr double near = 1e-9;
    PatternPoint point{.at = at, .N = shape.values(at)};
    const auto nodes = shape.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (std::abs(nodes[i].xi - at.xi) < near && std::abs(nodes[i].eta - at.eta) < near)
            point.node = static_cast<int>(i);
    if (point.node) return point;
    const int n = shape.n_corners();
    for (int side = 0; side < n; ++side) {
        const NaturalPoint a = nodes[static_cast<std::size_t>(side)],
                           b = nodes[static_cast<std::size_t>((side + 1) % n)];
        for (int k = 1; k < parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            if (std::abs(a.xi + t * (b.xi - a.xi) - at.xi) > near) continue;
            if (std::abs(a.eta + t * (b.eta - a.eta) - at.eta) > near) continue;
            point.side = side;
            point.part = k;
        }
    }
    return point;
}

/// Triangles (i, j) (i + 1, j) (i, j + 1), and those between them.
Pattern triangle_pattern(const Shape& shape, int n)
{
    Pattern pattern;
    std::map<std::pair<int, int>, int> index;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i + j <= n; ++i) {
            index[{i, j}] = static_cast<int>(pattern.points.size());
            pattern.points.push_back(pattern_point(shape, {static_cast<double>(i) / n, static_cast<double>(j) / n}, n));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i + j < n; ++i) {
            pattern.triangles.push_back({index[{i, j}], index[{i + 1, j}], index[{i, j + 1}]});
            if (i + j + 1 < n)
                pattern.triangles.push_back({index[{i + 1, j}], index[{i + 1, j + 1}], index[{i, j + 1}]});
        }
    return pattern;
}

/// Cells of four triangles about their middle.
Pattern quadrilateral_pattern(const Shape& shape, int n)
{
    Pattern pattern;
    const auto at = [n](int i) { return 2.0 * i / n - 1.0; };
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) pattern.points.push_back(pattern_point(shape, {at(i), at(j)}, n));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, middle = static_cast<int>(pattern.points.size());
            const std::array<int, 4> corners{a, a + 1, a + n + 2, a + n + 1};
            pattern.points.push_back(pattern_point(shape, {0.5 * (at(i) + at(i + 1)), 0.5 * (at(j) + at(j + 1))}, n));
            for (std::size_t k = 0; k < 4; ++k) pattern.triangles.push_back({corners[k], corners[(k + 1) % 4], middle});
        }
    return pattern;
}

/// All nodes of a Q8 or Q9 in a ring about the centre.
Pattern ring_pattern(const Shape& shape)
{
    Pattern pattern;
    for (int i = 0; i < 4; ++i) {
        pattern.points.push_back(pattern_point(shape, shape.nodes()[static_cast<std::size_t>(i)], 1));
        pattern.points.push_back(pattern_point(shape, shape.nodes()[static_cast<std::size_t>(4 + i)], 1));
    }
    pattern.points.push_back(pattern_point(shape, {}, 1));
    for (int i = 0; i < 8; ++i) pattern.triangles.push_back({i, (i + 1) % 8, 8});
    return pattern;
}

Pattern pattern_of(ShapeKind kind, int parts)
{
    const Shape& shape = shape_of(kind);
    const bool is_fine = parts > 0;
    switch (kind) {
    case ShapeKind::T3: return triangle_pattern(shape, 1);
    case ShapeKind::T6: return triangle_pattern(shape, is_fine ? parts : 2);
    case ShapeKind::Q4: return quadrilateral_pattern(shape, is_fine ? parts : 1);
    default: return is_fine ? quadrilateral_pattern(shape, parts) : ring_pattern(shape);
    }
}

/// Whether elements of a region have the same values at the nodes that they share.
enum class NodeValues : std::uint8_t { OfRegion, OfElement };

/// What a place has in the region that came there first, and in others.
class RegionValues {
public:
    /// The value that is known, or else the one that is found.
    double known_or(std::uint32_t place, RegionId region, auto&& find)
    {
        if (place >= first_.size()) first_.resize(place + 1);
        std::optional<Entry>& first = first_[place];
        if (!first) first = Entry{.region = region, .value = find()};
        if (first->region == region) return first->value;
        const auto [found, is_new] = others_.try_emplace({place, region.index});
        if (is_new) found->second = find();
        return found->second;
    }

private:
    struct Entry {
        RegionId region;
        double value = 0.0;
    };
    std::vector<std::optional<Entry>> first_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> others_; ///< on borders of regions
};

/// The value at a place of an element, whose shape's functions are N there.
using ValueAt = std::function<double(const Location&, const Shape::Values& N)>;

/// Cuts a mesh element by element. What is shared has one value in a region, to the last bit: a field is continuous
/// only then.
class Triangulation {
public:
    Triangulation(const PlaneModel& mesh, int parts, NodeValues at_nodes, ValueAt value)
        : mesh_(mesh),
          value_(std::move(value)),
          parts_(parts),
          place_of_node_(mesh.points.size(), TriangulatedField::none),
          is_shared_(at_nodes == NodeValues::OfRegion)
    {}

    TriangulatedField made()
    {
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) add(ElementId(e));
        join(field_);
        return std::move(field_);
    }

private:
    const Pattern& pattern(ShapeKind kind)
    {
        const auto [found, is_new] = patterns_.try_emplace(kind);
        if (is_new) found->second = pattern_of(kind, parts_);
        return found->second;
    }

    std::uint32_t new_place(const Vector2d& at, const Location& location)
    {
        field_.places.push_back(at);
        field_.located.push_back(location);
        return static_cast<std::uint32_t>(field_.places.size() - 1);
    }

    std::uint32_t place_on_side(ElementId e, const PatternPoint& point, const Vector2d& at)
    {
        const PlaneElement& element = mesh_[e];
        const int n_corners = shape_of(element.kind).n_corners();
        const auto node = [&](int i) { return element.points[static_cast<std::size_t>(i)].index; };
        std::uint32_t from = node(*point.side), to = node((*point.side + 1) % n_corners);
        const bool is_backwards = from > to;
        if (is_backwards) std::swap(from, to);
        const auto n = static_cast<std::size_t>(parts_ - 1);
        const auto [found, is_new] = on_sides_.try_emplace((std::uint64_t{from} << 32U) | to, places_on_sides_.size());
        if (is_new) places_on_sides_.resize(found->second + n, TriangulatedField::none);
        const int part = is_backwards ? parts_ - point.part : point.part;
        std::uint32_t& place = places_on_sides_[found->second + static_cast<std::size_t>(part) - 1];
        if (place == TriangulatedField::none) place = new_place(at, {.element = e, .at = point.at});
        return place;
    }

    std::uint32_t place_of(ElementId e, const PatternPoint& point, const NodePositions& X)
    {
        const Location here{.element = e, .at = point.at};
        if (point.node) {
            const NodeId node = mesh_[e].points[static_cast<std::size_t>(*point.node)];
            std::uint32_t& place = place_of_node_[node.index];
            if (place == TriangulatedField::none) place = new_place(position(mesh_[node]), here);
            return place;
        }
        const Vector2d at = X.transpose() * point.N;
        return point.side ? place_on_side(e, point, at) : new_place(at, here);
    }

    void add(ElementId e)
    {
        const PlaneElement& element = mesh_[e];
        const Pattern& cut = pattern(element.kind);
        const NodePositions X = positions_of(mesh_, element);
        places_.clear();
        values_.clear();
        for (const PatternPoint& point : cut.points) {
            const std::uint32_t place = places_.emplace_back(place_of(e, point, X));
            const auto value = [&] { return value_({.element = e, .at = point.at}, point.N); };
            values_.push_back(is_shared_ ? known_.known_or(place, element.region, value) : value());
        }
        for (const auto& [a, b, c] : cut.triangles) {
            const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b),
                       k = static_cast<std::size_t>(c);
            field_.triangles.push_back({places_[i], places_[j], places_[k]});
            field_.values.push_back({values_[i], values_[j], values_[k]});
        }
    }

    const PlaneModel& mesh_;
    ValueAt value_;
    int parts_;
    std::vector<std::uint32_t> place_of_node_;
    bool is_shared_; ///< elements of a region have one value where they meet
    RegionValues known_;
    std::unordered_map<std::uint64_t, std::size_t> on_sides_; ///< by both corners, the lesser first: among the next
    std::vector<std::uint32_t> places_on_sides_;
    std::map<ShapeKind, Pattern> patterns_;
    std::vector<std::uint32_t> places_; ///< of the pattern's points in an element, and what is there
    std::vector<double> values_;
    TriangulatedField field_;
};

bool is_of_strain(PlaneComponent component)
{
    using enum PlaneComponent;
    return component == ex || component == ey || component == ez || component == gxy;
}

bool is_of_displacement(PlaneComponent component)
{
    using enum PlaneComponent;
    return component == ux || component == uy;
}

} // namespace

double TriangulatedField::area() const
{
    double twice = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const Vector2d u = places[b] - places[a], v = places[c] - places[a];
        twice += u.x() * v.y() - u.y() * v.x();
    }
    return 0.5 * twice;
}

/// Half-edges are listed by their lesser place; those of one place are few.
void join(TriangulatedField& field)
{
    const auto n = static_cast<std::uint32_t>(3 * field.triangles.size());
    std::vector<std::uint32_t> first(field.places.size() + 1, 0), listed(n);
    const auto least = [&](std::uint32_t h) {
        return std::min(field.start(h), field.start(TriangulatedField::next(h)));
    };
    for (std::uint32_t h = 0; h < n; ++h) ++first[least(h) + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<std::uint32_t> filled = first;
    field.twins.assign(n, TriangulatedField::none);
    for (std::uint32_t h = 0; h < n; ++h) {
        const std::uint32_t place = least(h), start = field.start(h), end = field.start(TriangulatedField::next(h));
        for (std::uint32_t i = first[place]; i < filled[place]; ++i) {
            const std::uint32_t other = listed[i];
            if (field.twins[other] != TriangulatedField::none || field.start(other) != end) continue;
            if (field.start(TriangulatedField::next(other)) != start) continue;
            field.twins[other] = h;
            field.twins[h] = other;
            break;
        }
        listed[filled[place]++] = h;
    }
    field.ends.clear();
    for (std::uint32_t h = 0; h < n; ++h)
        if (!field.is_continuous(h)) field.ends.push_back(h);
}

int parts_of_sides(const PlaneModel& mesh)
{
    const std::size_t n = mesh.elements.size();
    if (n > 1000) return 0;
    if (n > 400) return 4;
    return n > 60 ? 8 : 16;
}

TriangulatedField triangulated(const PlaneModel& mesh, int parts, const std::function<double(const Location&)>& value)
{
    const auto at_location = [&](const Location& here, const Shape::Values&) { return value(here); };
    return Triangulation(mesh, parts, NodeValues::OfElement, at_location).made();
}

double component_at(const PlaneCase& result, PlaneComponent which, StressReading reading, const Location& place)
{
    if (is_of_displacement(which))
        return component(result.displacement(place), which, Vector2d::Zero(), Vector2d::Zero());
    if (is_of_strain(which)) return component(result.smoothed_strain(place), which);
    const PlaneStress stress = reading == StressReading::Element ? result.element_stress(place)
                                                                 : result.smoothed_stress(place);
    return component(stress, which, Vector2d::Zero(), Vector2d::Zero());
}

TriangulatedField component_field(const PlaneCase& result, PlaneComponent which, StressReading reading)
{
    const PlaneModel& mesh = result.structure().model();
    const bool jumps = reading == StressReading::Element && !is_of_displacement(which) && !is_of_strain(which);
    const bool is_recovered = reading == StressReading::Smoothed && !is_of_displacement(which) && !is_of_strain(which);
    const auto value = [&](const Location& place, const Shape::Values& N) {
        if (!is_recovered) return component_at(result, which, reading, place);
        return component(result.smoothed_stress(place.element, N), which, Vector2d::Zero(), Vector2d::Zero());
    };
    return Triangulation(mesh, parts_of_sides(mesh), jumps ? NodeValues::OfElement : NodeValues::OfRegion, value)
        .made();
}

FieldExtremes field_extremes(const PlaneCase& result, PlaneComponent which, StressReading reading)
{
    if (!is_of_displacement(which) && !is_of_strain(which)) {
        const auto find = [&](ExtremeKind kind) {
            return extreme(result, {.component = which, .which = kind, .read = reading});
        };
        return {find(ExtremeKind::Min), find(ExtremeKind::Max)};
    }
    FieldExtremes found{{.value = std::numeric_limits<double>::infinity()},
                        {.value = -std::numeric_limits<double>::infinity()}};
    const PlaneModel& mesh = result.structure().model();
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto nodes = shape_of(mesh.elements[e].kind).nodes();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double value = component_at(result, which, reading, {.element = ElementId(e), .at = nodes[i]});
            const Vector2d at = position(mesh[mesh.elements[e].points[i]]);
            if (value < found.min.value) found.min = {value, at};
            if (value > found.max.value) found.max = {value, at};
        }
    }
    return found;
}

} // namespace femoop::plane
