#include "apps/cli/bench_halfedge.h"

#include <chrono>
#include <stdexcept>
#include <vector>

#include "topology/halfedge/check/validate.h"

namespace cli {

namespace {

using topology::EulerOperator;
using topology::HalfEdgeId;
using topology::Solid;

template <class Work> double seconds(const Work& work)
{
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

topology::Point grid_point(std::size_t column, std::size_t row)
{
    return {static_cast<double>(column), static_cast<double>(row), 0.0};
}

/// The lowest line of the grid, struts one after the other; `up` gets the corner above each vertex.
void draw_first_row(EulerOperator& op, std::size_t n, std::vector<HalfEdgeId>& up)
{
    HalfEdgeId corner = op.mvfs(grid_point(0, 0)).half_edge;
    for (std::size_t i = 1; i <= n; ++i) {
        const topology::NewEdge edge = op.mev(corner, grid_point(i, 0));
        up[i - 1] = edge.minus;
        up[i] = corner = edge.plus;
    }
}

/// A strut up from every vertex; each but the first is joined to its left neighbour by MEF, which closes a cell.
void draw_row(EulerOperator& op, std::size_t row, std::vector<HalfEdgeId>& up)
{
    HalfEdgeId left = op.mev(up[0], grid_point(0, row)).plus;
    for (std::size_t i = 1; i < up.size(); ++i) {
        const HalfEdgeId right = op.mev(up[i], grid_point(i, row)).plus;
        up[i - 1] = op.mef(left, right).plus;
        left = right;
    }
    up.back() = left;
}

} // namespace

std::size_t draw_grid(EulerOperator& op, std::size_t n)
{
    std::vector<HalfEdgeId> up(n + 1);
    draw_first_row(op, n, up);
    for (std::size_t row = 1; row <= n; ++row) draw_row(op, row, up);
    return 1 + n + n * (n + 1) + n * n;
}

topology::Counts grid_counts(std::size_t n)
{
    const std::size_t edges = 2 * n * (n + 1), faces = n * n + 1;
    return {.vertices = (n + 1) * (n + 1), .edges = edges, .half_edges = 2 * edges, .faces = faces, .loops = faces};
}

HalfEdgeBench bench_halfedge(std::size_t n)
{
    HalfEdgeBench bench;
    {
        Solid solid;
        bench.build = seconds([&] {
            solid.reserve(grid_counts(n));
            EulerOperator op(solid);
            bench.operators = draw_grid(op, n);
        });
        if (!(solid.counts() == grid_counts(n))) throw std::logic_error("the grid has other counts than it should");
        bench.validate = seconds([&] { topology::validate(solid); });
        bench.bytes_per_edge = static_cast<double>(solid.bytes()) / static_cast<double>(solid.counts().edges);
    }
    Solid solid;
    topology::Journal journal;
    EulerOperator op(solid, journal);
    bench.build_journaled = seconds([&] {
        solid.reserve(grid_counts(n));
        draw_grid(op, n);
    });
    bench.undo = seconds([&] {
        while (journal.n_done() != 0) op.undo();
    });
    if (!solid.is_empty()) throw std::logic_error("undoing the whole grid left something");
    return bench;
}

} // namespace cli
