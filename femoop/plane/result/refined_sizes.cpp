#include "femoop/plane/result/refined_sizes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

constexpr double least_ratio = 0.25, greatest_ratio = 1.5; // of a size to the one before
constexpr double ratio_step = 1.0 / 1024.0;                // far below what an estimate of an error is worth

/// The last digits of an error differ from one processor to another; the mesh that it asks for must not.
double rounded(double ratio) { return std::round(ratio / ratio_step) * ratio_step; }

struct CornerPolygon {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double area = 0.0;
};

CornerPolygon corner_polygon(const PlaneModel& mesh, const PlaneElement& element)
{
    const std::size_t n = is_triangle(element.kind) ? 3 : 4;
    CornerPolygon polygon;
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector2d a = position(mesh[element.points[i]]), b = position(mesh[element.points[(i + 1) % n]]);
        polygon.centre += a / static_cast<double>(n);
        polygon.area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return polygon;
}

} // namespace

int complete_degree(ShapeKind kind) { return kind == ShapeKind::T3 || kind == ShapeKind::Q4 ? 1 : 2; }

std::vector<RefinedSize> refined_sizes(const PlaneModel& mesh, const std::vector<double>& element_errors, double eta)
{
    std::vector<RefinedSize> sizes;
    sizes.reserve(mesh.elements.size());
    const double share = eta / std::sqrt(static_cast<double>(mesh.elements.size())); // that each may have
    for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
        const CornerPolygon polygon = corner_polygon(mesh, mesh.elements[i]);
        const double of_triangle = is_triangle(mesh.elements[i].kind) ? polygon.area : 0.5 * polygon.area;
        const double size = std::sqrt(4.0 / std::sqrt(3.0) * of_triangle);
        const double error = element_errors[i];
        const double ratio = error > 0.0 ? std::pow(share / error, 1.0 / complete_degree(mesh.elements[i].kind))
                                         : greatest_ratio;
        sizes.push_back({.at = polygon.centre,
                         .size = size,
                         .wanted = size * rounded(std::clamp(ratio, least_ratio, greatest_ratio))});
    }
    return sizes;
}

double growth_of_mesh(const std::vector<RefinedSize>& sizes)
{
    double sum = 0.0;
    for (const RefinedSize& each : sizes) sum += (each.size / each.wanted) * (each.size / each.wanted);
    return sizes.empty() ? 1.0 : sum / static_cast<double>(sizes.size());
}

} // namespace femoop::plane
