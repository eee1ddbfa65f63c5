#include "femoop/plane/mesh/mesh_quality.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

constexpr int degree_of_area = 4; // of det J of any shape, in each natural coordinate

double corner_angle(const NodePositions& X, int before, int corner, int behind)
{
    const Eigen::Vector2d a = (X.row(before) - X.row(corner)).transpose(),
                          b = (X.row(behind) - X.row(corner)).transpose();
    return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b)) * 180.0 / std::numbers::pi;
}

/// det J over the lengths of the two edges that meet in a corner, as they leave it.
double scaled_jacobian(const Shape& shape, const NodePositions& X, int before, int corner, int behind)
{
    const auto natural = [&](int i) {
        const NaturalPoint& at = shape.nodes()[static_cast<std::size_t>(i)];
        return Eigen::Vector2d(at.xi, at.eta);
    };
    const Eigen::Matrix2d J = jacobian(shape.derivatives(shape.nodes()[static_cast<std::size_t>(corner)]), X);
    const Eigen::Vector2d a = J.transpose() * (natural(behind) - natural(corner)).normalized(),
                          b = J.transpose() * (natural(before) - natural(corner)).normalized();
    return (a.x() * b.y() - a.y() * b.x()) / (a.norm() * b.norm());
}

} // namespace

MeshQuality mesh_quality(const PlaneModel& model, std::optional<RegionId> region)
{
    MeshQuality worst;
    for (const PlaneElement& element : model.elements) {
        if (region && element.region != *region) continue;
        const Shape& shape = shape_of(element.kind);
        const NodePositions X = positions_of(model, element);
        const int n = shape.n_corners();
        for (int i = 0; i < n; ++i) {
            const int before = (i + n - 1) % n, behind = (i + 1) % n;
            const double angle = corner_angle(X, before, i, behind);
            worst.min_angle = std::min(worst.min_angle, angle);
            worst.max_angle = std::max(worst.max_angle, angle);
            worst.min_jacobian = std::min(worst.min_jacobian, scaled_jacobian(shape, X, before, i, behind));
        }
    }
    return worst;
}

std::vector<RegionSize> region_sizes(const PlaneModel& model)
{
    std::vector<RegionSize> sizes(model.regions.size());
    for (const PlaneElement& element : model.elements) {
        const Shape& shape = shape_of(element.kind);
        const NodePositions X = positions_of(model, element);
        RegionSize& size = sizes[element.region.index];
        ++size.n_elements;
        for (const IntegrationPoint& point : rule_of_degree(shape.domain(), degree_of_area).points)
            size.area += point.weight * jacobian(shape.derivatives(point.at), X).determinant();
    }
    return sizes;
}

} // namespace femoop::plane
