#include "tests/bench/cgal_reference.h"

#include <CGAL/HalfedgeDS_decorator.h>
#include <CGAL/HalfedgeDS_items_2.h>
#include <CGAL/HalfedgeDS_vector.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <vector>

namespace bench {

namespace {

struct Traits {
    using Point_2 = std::array<double, 3>; // NOLINT(readability-identifier-naming): the name that CGAL asks for
};
using Structure = CGAL::HalfedgeDS_vector<Traits, CGAL::HalfedgeDS_items_2>;
using Decorator = CGAL::HalfedgeDS_decorator<Structure>;
using Half = Structure::Halfedge_handle;

std::array<double, 3> grid_point(std::size_t column, std::size_t row)
{
    return {static_cast<double>(column), static_cast<double>(row), 0.0};
}

/// A strut from the end of `corner`. \returns its half that points at the new vertex
Half grow(Decorator& op, Half corner, const std::array<double, 3>& point)
{
    const Half tip = op.split_vertex(corner, corner)->opposite();
    tip->vertex()->point() = point;
    return tip;
}

/// `up` gets, of each vertex, the half-edge that ends there below the grid's next row.
void draw_first_row(Decorator& op, std::size_t n, std::vector<Half>& up)
{
    up[1] = op.create_segment();
    up[0] = up[1]->opposite();
    up[0]->vertex()->point() = grid_point(0, 0);
    up[1]->vertex()->point() = grid_point(1, 0);
    for (std::size_t i = 2; i <= n; ++i) up[i] = grow(op, up[i - 1], grid_point(i, 0));
}

void draw_row(Decorator& op, std::size_t row, std::vector<Half>& up)
{
    Half left = grow(op, up[0], grid_point(0, row));
    for (std::size_t i = 1; i < up.size(); ++i) {
        const Half right = grow(op, up[i], grid_point(i, row));
        up[i - 1] = left;
        left = op.split_face(left, right);
    }
    up.back() = left;
}

} // namespace

double cgal_grid(std::size_t n)
{
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t edges = 2 * n * (n + 1);
    Structure structure((n + 1) * (n + 1), 2 * edges, n * n + 1);
    Decorator op(structure);
    std::vector<Half> up(n + 1);
    draw_first_row(op, n, up);
    for (std::size_t row = 1; row <= n; ++row) draw_row(op, row, up);
    const double time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (structure.size_of_faces() != n * n + 1 || structure.size_of_halfedges() != 2 * edges)
        throw std::logic_error("CGAL's grid has other counts than ours");
    return time;
}

} // namespace bench
