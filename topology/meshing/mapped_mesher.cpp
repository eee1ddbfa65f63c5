#include "topology/meshing/mapped_mesher.h"

#include <algorithm>

namespace topology {

namespace {

/// How far along a chain each of its nodes is, from 0 to 1, by the length of its chords.
std::vector<double> shares(const std::vector<FlatPoint>& chain)
{
    std::vector<double> along{0.0};
    for (std::size_t i = 1; i < chain.size(); ++i) along.push_back(along.back() + distance(chain[i - 1], chain[i]));
    for (double& each : along) each /= along.back();
    return along;
}

/// A side with its places, in the direction of growing u or v.
struct MappedChain {
    std::vector<CellNode> nodes;
    std::vector<FlatPoint> places;
    std::vector<double> along;

    MappedChain(std::vector<CellNode> of, const std::vector<FlatPoint>& all) : nodes(std::move(of))
    {
        for (const CellNode node : nodes) places.push_back(all[node]);
        along = shares(places);
    }
};

std::vector<CellNode> reversed(std::vector<CellNode> nodes)
{
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
}

/// (1 - u) a + u b, of places.
FlatPoint blend(const FlatPoint& a, const FlatPoint& b, double u) { return a + u * (b - a); }

/// The blended place of the i-th node of bottom and top and the j-th of left and right.
FlatPoint mapped_place(const MappedChain& bottom, const MappedChain& top, const MappedChain& left,
                       const MappedChain& right, std::size_t i, std::size_t j)
{
    // u and v where the line between the i-th nodes meets that between the j-th ones in the unit square
    const double du = top.along[i] - bottom.along[i], dv = right.along[j] - left.along[j];
    const double u = (bottom.along[i] + left.along[j] * du) / (1.0 - du * dv);
    const double v = left.along[j] + u * dv;
    const FlatPoint upwards = blend(bottom.places[i], top.places[i], v);
    const FlatPoint across = blend(left.places[j], right.places[j], u);
    const FlatPoint corners = blend(blend(bottom.places.front(), bottom.places.back(), u),
                                    blend(top.places.front(), top.places.back(), u), v);
    return upwards + (across - corners);
}

/// Four sides, bottom and top from left to right, left and right upwards.
struct MappedGrid {
    MappedChain bottom, right, top, left;

    MappedGrid(const MappedSides& sides, const std::vector<FlatPoint>& nodes)
        : bottom(sides[0], nodes),
          right(sides[1], nodes),
          top(reversed(sides[2]), nodes),
          left(reversed(sides[3]), nodes)
    {}

    /// Rows from bottom to top, with new nodes inside at their places.
    template <class Place>
    std::vector<std::vector<CellNode>> rows(std::vector<FlatPoint>& nodes, const Place& place) const
    {
        std::vector<std::vector<CellNode>> rows{bottom.nodes};
        for (std::size_t j = 1; j + 1 < right.nodes.size(); ++j) {
            std::vector<CellNode> row{left.nodes[j]};
            for (std::size_t i = 1; i + 1 < bottom.nodes.size(); ++i) {
                row.push_back(static_cast<CellNode>(nodes.size()));
                nodes.push_back(place(i, j));
            }
            row.push_back(right.nodes[j]);
            rows.push_back(std::move(row));
        }
        rows.push_back(top.nodes);
        return rows;
    }
};

/// A place of a chain when it is moved, turned and scaled so that its ends come to others: z -> start + (z - z0) (end -
/// start) / (zn - z0) in complex numbers.
FlatPoint carried(const std::vector<FlatPoint>& chain, std::size_t i, const FlatPoint& start, const FlatPoint& end)
{
    const FlatVector z = chain[i] - chain.front(), from = chain.back() - chain.front(), to = end - start;
    const double squared = dot(from, from);
    const FlatVector turned{dot(from, to) / squared, cross(from, to) / squared};
    return start + FlatVector{z.x * turned.x - z.y * turned.y, z.x * turned.y + z.y * turned.x};
}

} // namespace

std::vector<std::vector<CellNode>> mapped_nodes(const MappedSides& sides, std::vector<FlatPoint>& nodes)
{
    const MappedGrid grid(sides, nodes);
    return grid.rows(nodes, [&](std::size_t i, std::size_t j) {
        return mapped_place(grid.bottom, grid.top, grid.left, grid.right, i, j);
    });
}

std::vector<std::vector<CellNode>> swept_nodes(const MappedSides& sides, std::vector<FlatPoint>& nodes)
{
    const MappedGrid grid(sides, nodes);
    return grid.rows(nodes, [&](std::size_t i, std::size_t j) {
        const FlatPoint &start = grid.left.places[j], &end = grid.right.places[j];
        const double share = 0.5 * (grid.left.along[j] + grid.right.along[j]);
        return blend(carried(grid.bottom.places, i, start, end), carried(grid.top.places, i, start, end), share);
    });
}

std::vector<Cell> quadrilaterals(const std::vector<std::vector<CellNode>>& rows)
{
    std::vector<Cell> cells;
    for (std::size_t j = 0; j + 1 < rows.size(); ++j)
        for (std::size_t i = 0; i + 1 < rows[j].size(); ++i)
            cells.emplace_back(rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]);
    return cells;
}

std::vector<Cell> triangles(const std::vector<Cell>& quadrilaterals, Diagonal diagonal, std::vector<FlatPoint>& nodes)
{
    std::vector<Cell> cells;
    for (const Cell& cell : quadrilaterals) {
        const CellNode a = cell.nodes()[0], b = cell.nodes()[1], c = cell.nodes()[2], d = cell.nodes()[3];
        if (diagonal == Diagonal::Cross) {
            const auto centre = static_cast<CellNode>(nodes.size());
            nodes.push_back(middle(middle(nodes[a], nodes[c]), middle(nodes[b], nodes[d])));
            for (const auto& [from, to] : {CellEdge{a, b}, CellEdge{b, c}, CellEdge{c, d}, CellEdge{d, a}})
                cells.emplace_back(from, to, centre);
            continue;
        }
        const bool is_shorter = distance(nodes[b], nodes[d]) < distance(nodes[a], nodes[c]);
        if (diagonal == Diagonal::Left || (diagonal == Diagonal::Shortest && is_shorter)) {
            cells.emplace_back(a, b, d);
            cells.emplace_back(b, c, d);
        } else {
            cells.emplace_back(a, b, c);
            cells.emplace_back(a, c, d);
        }
    }
    return cells;
}

} // namespace topology
