#include "femoop/plane/mesh/mesh_geometry.h"

#include <cstddef>

#include "femoop/rule/integration_rule.h"

namespace femoop::plane {

namespace {

constexpr int points_of_length = 8;

const Shape& line_of(Eigen::Index n_nodes) { return shape_of(n_nodes == 2 ? ShapeKind::Line2 : ShapeKind::Line3); }

/// One direction where two are nearly the same.
std::vector<Eigen::Vector2d> joined(const Eigen::Vector2d& before, const Eigen::Vector2d& behind)
{
    if (is_corner(before, behind)) return {before, behind};
    return {(before + behind).normalized()};
}

} // namespace

Eigen::Vector2d position(const PlanePoint& point) { return {point.at[0], point.at[1]}; }

std::vector<Eigen::Vector2d> positions(const PlaneModel& model)
{
    std::vector<Eigen::Vector2d> all;
    all.reserve(model.points.size());
    for (const PlanePoint& point : model.points) all.push_back(position(point));
    return all;
}

double extent(const std::vector<Eigen::Vector2d>& places)
{
    if (places.empty()) return 0.0;
    Eigen::Vector2d low = places.front(), high = low;
    for (const Eigen::Vector2d& at : places) {
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
    }
    return (high - low).norm();
}

double extent(const NodePositions& X) { return (X.colwise().maxCoeff() - X.colwise().minCoeff()).norm(); }

bool is_corner(const Eigen::Vector2d& before, const Eigen::Vector2d& behind)
{
    constexpr double cosine_of_corner = 0.5;
    return before.dot(behind) <= cosine_of_corner * before.norm() * behind.norm();
}

NodePositions positions_of(const PlaneModel& model, const PlaneElement& element)
{
    NodePositions X(static_cast<Eigen::Index>(element.points.size()), 2);
    for (std::size_t i = 0; i < element.points.size(); ++i)
        X.row(static_cast<Eigen::Index>(i)) = position(model[element.points[i]]);
    return X;
}

CurveGeometry::CurveGeometry(const PlaneModel& model, const std::vector<CurveEdge>& edges,
                             const std::optional<CurveReach>& reach)
{
    std::size_t n_runs = 0;
    for (const CurveEdge& edge : edges) {
        if (edge.begins_run && reach) length_ = reach->runs[n_runs++].start;
        EdgePositions X(edge.middle ? 3 : 2, 2);
        X.row(0) = position(model[edge.start]);
        X.row(1) = position(model[edge.end]);
        if (edge.middle) X.row(2) = position(model[*edge.middle]);
        edges_.push_back(X);
        starts_.push_back(length_);
        length_ = s(edges_.size() - 1, 1.0);
    }
    if (!edges.empty()) add_nodes(edges);
    if (reach) length_ = reach->length;
}

Eigen::Vector2d CurveGeometry::at(std::size_t edge, double xi) const
{
    const EdgePositions& X = edges_[edge];
    return X.transpose() * line_of(X.rows()).values({.xi = xi});
}

Eigen::Vector2d CurveGeometry::tangent(std::size_t edge, double xi) const
{
    const EdgePositions& X = edges_[edge];
    return X.transpose() * line_of(X.rows()).derivatives({.xi = xi}).col(0);
}

double CurveGeometry::s(std::size_t edge, double xi) const
{
    static const IntegrationRule rule = gauss_line(points_of_length);
    const double half = 0.5 * (xi + 1.0);
    double length = starts_[edge];
    if (edges_[edge].rows() == 2) return length + half * (edges_[edge].row(1) - edges_[edge].row(0)).norm();
    for (const IntegrationPoint& point : rule.points)
        length += point.weight * half * tangent(edge, half * (point.at.xi + 1.0) - 1.0).norm();
    return length;
}

void CurveGeometry::add_nodes(const std::vector<CurveEdge>& edges)
{
    const std::size_t last = edges.size() - 1;
    const bool is_closed = edges[last].end == edges.front().start;
    const auto add_end = [&](std::size_t i) {
        nodes_.push_back({.node = edges[i].end, .s = s(i, 1.0), .directions = {tangent(i, 1.0).normalized()}});
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool goes_on = i > 0 ? !edges[i].begins_run : is_closed;
        if (i > 0 && !goes_on) add_end(i - 1);
        const Eigen::Vector2d behind = tangent(i, -1.0).normalized();
        CurveNode node{.node = edges[i].start, .s = starts_[i], .directions = {behind}};
        if (goes_on) node.directions = joined(tangent(i > 0 ? i - 1 : last, 1.0).normalized(), behind);
        nodes_.push_back(node);
        if (edges[i].middle)
            nodes_.push_back({.node = *edges[i].middle, .s = s(i, 0.0), .directions = {tangent(i, 0.0).normalized()}});
    }
    if (!is_closed) add_end(last);
}

} // namespace femoop::plane
