#include "topology/meshing/trilateral_mesher.h"

namespace topology {

namespace {

using TrilateralChain = std::vector<CellNode>;

/// Where the lines are that run at constant u, v, w, whose sum is n, between the sides.
class TrilateralMap {
public:
    TrilateralMap(const TrilateralSides& sides, const std::vector<FlatPoint>& nodes)
        : sides_(sides), nodes_(nodes), n_(sides[0].size() - 1)
    {}

    /// v parts towards the second corner, w towards the third. \pre it is inside
    FlatPoint operator()(std::size_t v, std::size_t w) const
    {
        const std::size_t u = n_ - v - w;
        const FlatPoint at_u = between(side(0, v + w), v, side(2, u), w); // the same u on sides 0 and 2
        const FlatPoint at_v = between(side(0, v), u, side(1, u + w), w);
        const FlatPoint at_w = between(side(1, w), v, side(2, u + v), u);
        const FlatPoint origin = side(0, 0);
        const double n = static_cast<double>(n_);
        const FlatVector corners = (static_cast<double>(v) / n) * (side(1, 0) - origin) +
                                   (static_cast<double>(w) / n) * (side(2, 0) - origin);
        return origin + 0.5 * ((at_u - origin) + (at_v - origin) + (at_w - origin) - corners);
    }

private:
    FlatPoint side(std::size_t of, std::size_t i) const { return nodes_[sides_[of][i]]; }
    static FlatPoint between(const FlatPoint& a, std::size_t of_a, const FlatPoint& b, std::size_t of_b)
    {
        return a + static_cast<double>(of_b) / static_cast<double>(of_a + of_b) * (b - a);
    }

    const TrilateralSides& sides_;
    const std::vector<FlatPoint>& nodes_;
    std::size_t n_;
};

/// Nodes on a straight line, its ends included.
TrilateralChain straight_chain(CellNode from, CellNode to, std::size_t n_parts, std::vector<FlatPoint>& nodes)
{
    TrilateralChain chain{from};
    for (std::size_t i = 1; i < n_parts; ++i) {
        chain.push_back(static_cast<CellNode>(nodes.size()));
        const FlatPoint place = nodes[from] +
                                static_cast<double>(i) / static_cast<double>(n_parts) * (nodes[to] - nodes[from]);
        nodes.push_back(place);
    }
    chain.push_back(to);
    return chain;
}

} // namespace

std::vector<std::vector<CellNode>> trilateral_nodes(const TrilateralSides& sides, std::vector<FlatPoint>& nodes)
{
    const std::size_t n = sides[0].size() - 1;
    std::vector<TrilateralChain> rows{sides[0]};
    for (std::size_t w = 1; w < n; ++w) {
        TrilateralChain row{sides[2][n - w]};
        for (std::size_t v = 1; v + w < n; ++v) {
            const FlatPoint place = TrilateralMap(sides, nodes)(v, w);
            row.push_back(static_cast<CellNode>(nodes.size()));
            nodes.push_back(place);
        }
        row.push_back(sides[1][w]);
        rows.push_back(std::move(row));
    }
    rows.push_back({sides[2].front()});
    return rows;
}

std::vector<Cell> trilateral_triangles(const std::vector<std::vector<CellNode>>& rows)
{
    std::vector<Cell> cells;
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
        const TrilateralChain &below = rows[j], &above = rows[j + 1];
        for (std::size_t i = 0; i < above.size(); ++i) {
            cells.emplace_back(below[i], below[i + 1], above[i]);
            if (i + 1 < above.size()) cells.emplace_back(below[i + 1], above[i + 1], above[i]);
        }
    }
    return cells;
}

std::array<MappedSides, 3> trilateral_parts(const TrilateralSides& sides, std::vector<FlatPoint>& nodes)
{
    const std::size_t half = (sides[0].size() - 1) / 2;
    FlatVector sum;
    for (const TrilateralChain& side : sides) sum = sum + (1.0 / 3.0) * (nodes[side[half]] - nodes[sides[0][half]]);
    const auto centre = static_cast<CellNode>(nodes.size());
    nodes.push_back(nodes[sides[0][half]] + sum);
    std::array<TrilateralChain, 3> inwards;
    for (std::size_t i = 0; i < 3; ++i) inwards[i] = straight_chain(sides[i][half], centre, half, nodes);
    std::array<MappedSides, 3> parts;
    for (std::size_t i = 0; i < 3; ++i) {
        const TrilateralChain &from = sides[i], &to = sides[(i + 2) % 3], &in = inwards[i], &out = inwards[(i + 2) % 3];
        const auto middle = static_cast<std::ptrdiff_t>(half);
        parts[i] = {TrilateralChain(from.begin(), from.begin() + middle + 1), in,
                    TrilateralChain(out.rbegin(), out.rend()), TrilateralChain(to.begin() + middle, to.end())};
    }
    return parts;
}

} // namespace topology
