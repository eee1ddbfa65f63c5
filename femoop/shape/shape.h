#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "femoop/shape/natural_point.h"

namespace femoop {

/// The shapes, as a model file names them: T for triangles, Q for quadrilaterals, with the number of nodes.
enum class ShapeKind : std::uint8_t { Line2, Line3, T3, T6, Q4, Q8, Q9 };

std::string_view name(ShapeKind kind); ///< "T6"
std::span<const ShapeKind> shape_kinds();
constexpr bool is_triangle(ShapeKind kind) { return kind == ShapeKind::T3 || kind == ShapeKind::T6; }

/// Geometry and interpolation of an element: its nodes in natural coordinates, and the functions N that carry what is
/// known at nodes, places as well as displacements, to every place of the element:
///
///      x(xi, eta) = sum N_i x_i        u(xi, eta) = sum N_i u_i
///
/// Nodes   corners first, counter-clockwise; then middle nodes, of corners 1-2, 2-3, ...; then the centre
/// Edges   counter-clockwise, so that the element lies to their left; each lists its nodes as its own shape has them
/// Source  [MarthaParente2002]: the class Shape
class Shape {
public:
    static constexpr int max_nodes = 9;
    using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_nodes, 1>;      ///< [nodes]
    using Derivatives = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, max_nodes, 2>; ///< [nodes x (d/dxi, d/deta)]
    using Edge = std::span<const int>;

    virtual ~Shape() = default;
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;

    ShapeKind kind() const { return outline_.kind; }
    Domain domain() const { return outline_.domain; }
    /// Every polynomial of x and y up to this degree is reproduced in an element with straight sides, their middle
    /// nodes at mid-length (of Q8: a parallelogram).
    int degree() const { return outline_.degree; }
    int n_nodes() const { return static_cast<int>(outline_.nodes.size()); }
    std::span<const NaturalPoint> nodes() const { return outline_.nodes; }
    std::span<const Edge> edges() const { return outline_.edges; } ///< none of a line
    std::optional<ShapeKind> edge_kind() const { return outline_.edge_kind; }
    int n_corners() const { return outline_.edges.empty() ? 2 : static_cast<int>(outline_.edges.size()); }

    virtual Values values(NaturalPoint p) const = 0;
    virtual Derivatives derivatives(NaturalPoint p) const = 0; ///< of a line d/deta is zero

protected:
    struct Outline {
        ShapeKind kind;
        Domain domain;
        int degree;
        std::span<const NaturalPoint> nodes;
        std::optional<ShapeKind> edge_kind{};
        std::span<const Edge> edges{};
    };
    explicit Shape(const Outline& outline) : outline_(outline) {}

private:
    Outline outline_;
};

/// The shape of a kind. Shapes hold nothing that changes, so one of each is enough.
const Shape& shape_of(ShapeKind kind);

} // namespace femoop
