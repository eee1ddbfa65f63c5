// Quadrilaterals alone, where pairs of triangles left more than the boundary asks for: half as fine a mesh, each cell
// of which is cut into quadrilaterals at the middles of its edges.
#include <algorithm>
#include <cmath>
#include <utility>

#include "topology/meshing/quad_mesher.h"

namespace topology {

namespace {

std::uint64_t undirected_key(CellNode a, CellNode b) { return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b); }

} // namespace

/// Every other node of each loop, and what lies between them: one edge of a loop with an odd number stays whole.
struct QuadMesher::Halved {
    MeshDomain domain;
    std::vector<CellNode> numbers; ///< of its nodes in the whole domain
    std::unordered_map<std::uint64_t, CellNode> middles, whole;

    Halved(const MeshDomain& whole_domain, std::size_t first)
    {
        std::vector<bool> is_of_loop(whole_domain.nodes.size());
        for (const auto& loop : whole_domain.loops) {
            for (const CellNode node : loop) is_of_loop[node] = true;
            add(whole_domain, loop, first);
        }
        for (CellNode node = 0; node < whole_domain.nodes.size(); ++node)
            if (!is_of_loop[node]) number(whole_domain, node);
    }

private:
    std::unordered_map<CellNode, CellNode> known_;

    CellNode number(const MeshDomain& of, CellNode node)
    {
        const auto [known, is_new] = known_.try_emplace(node, static_cast<CellNode>(numbers.size()));
        if (is_new) {
            numbers.push_back(node);
            domain.nodes.push_back(of.nodes[node]);
        }
        return known->second;
    }

    void add(const MeshDomain& of, const std::vector<CellNode>& loop, std::size_t first)
    {
        const std::size_t n = loop.size();
        domain.loops.emplace_back();
        for (std::size_t i = 0; i < n;) {
            const bool stays_whole = i + 1 == n;
            const CellNode a = loop[(first + i) % n], between = loop[(first + i + 1) % n],
                           b = loop[(first + i + (stays_whole ? 1 : 2)) % n];
            const CellNode from = number(of, a), to = number(of, b);
            domain.loops.back().push_back(from);
            if (stays_whole) whole.emplace(undirected_key(a, b), a);
            else {
                middles.emplace(undirected_key(a, b), between);
                domain.bends.push_back({{from, to}, of.nodes[between]});
            }
            i += stays_whole ? 1 : 2;
        }
    }
};

std::size_t QuadMesher::n_triangles() const
{
    return static_cast<std::size_t>(
        std::count_if(cells_.begin(), cells_.end(), [](const Nodes& cell) { return cell.size() == 3; }));
}

/// Where more triangles are left than one for an odd boundary.
void QuadMesher::refill()
{
    std::size_t n_edges = 0;
    bool is_short = false;
    for (const auto& loop : domain_.loops) {
        n_edges += loop.size();
        is_short = is_short || loop.size() < 6;
    }
    const std::size_t n_wanted = n_edges % 2;
    if (n_triangles() <= n_wanted || is_short || !domain_.segments.empty() || options_.field || is_halved_) return;
    const auto nodes = nodes_;
    const auto cells = cells_;
    const auto edges = edges_;
    constexpr std::size_t hopeless = 20; // triangles that are left, which another beginning would leave too
    bool is_hopeless = false;
    for (std::size_t first = 0; first < 2 && !is_hopeless; ++first) {
        const bool is_filled = fill_halved(first);
        is_hopeless = is_filled && n_triangles() > n_wanted + hopeless;
        if (is_filled && n_triangles() <= n_wanted && worst(cells_) > least_of_filled) return;
        nodes_ = nodes;
        cells_ = cells;
        edges_ = edges;
        made_.clear();
    }
}

bool QuadMesher::fill_halved(std::size_t first)
{
    const Halved half(domain_, first);
    MesherOptions options = options_;
    options.size *= 2.0;
    options.sizes.clear();
    if (!options_.sizes.empty())
        for (const CellNode node : half.numbers) options.sizes.push_back(2.0 * options_.sizes[node]);
    CellMesh coarse;
    try {
        coarse = QuadMesher(half.domain, options, true).run();
    } catch (const CrossingEdges&) {
        return false;
    }
    nodes_.resize(domain_.nodes.size());
    cells_.clear();
    edges_.clear();
    made_.clear();
    std::vector<CellNode> numbers = half.numbers;
    for (std::size_t i = numbers.size(); i < coarse.nodes.size(); ++i) numbers.push_back(add_place(coarse.nodes[i]));
    auto middles = half.middles;
    for (const Cell& cell : coarse.cells) {
        Nodes corners;
        for (const CellNode node : cell.nodes()) corners.push_back(numbers[node]);
        if (!cut_at_middles(corners, half, middles)) return false;
    }
    mend_filled();
    return true;
}

CellNode QuadMesher::add_place(const FlatPoint& at)
{
    nodes_.push_back(at);
    return static_cast<CellNode>(nodes_.size() - 1);
}

/// A quadrilateral at each corner; a triangle beside an edge that stays whole. False where two do.
bool QuadMesher::cut_at_middles(const Nodes& corners, const Halved& half,
                                std::unordered_map<std::uint64_t, CellNode>& middles)
{
    const std::size_t n = corners.size();
    constexpr std::size_t is_nowhere = 4;
    std::size_t uncut = is_nowhere;
    FlatVector sum;
    Nodes between(n);
    for (std::size_t i = 0; i < n; ++i) {
        const CellNode a = corners[i], b = corners[(i + 1) % n];
        sum = sum + (nodes_[a] - nodes_[corners[0]]);
        const std::uint64_t key = undirected_key(a, b);
        if (half.whole.contains(key)) {
            if (uncut != is_nowhere) return false;
            uncut = i;
            continue;
        }
        const auto known = middles.find(key);
        between[i] = known != middles.end() ? known->second : add_place(middle(nodes_[a], nodes_[b]));
        middles.emplace(key, between[i]);
    }
    const CellNode centre = add_place(nodes_[corners[0]] + (1.0 / static_cast<double>(n)) * sum);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = (i + n - 1) % n;
        if (i == uncut) {
            add({corners[i], corners[(i + 1) % n], between[(i + 1) % n], centre});
            add({corners[i], centre, between[before]});
        } else if (before != uncut) {
            add({corners[i], between[i], centre, between[before]});
        }
    }
    return true;
}

/// As what was paired: triangles walk towards each other, and what is poor is mended.
void QuadMesher::mend_filled()
{
    walked_ = 0;
    while (walk_next()) {
    }
    n_rounds_ = n_tries_ = 0;
    while (n_rounds_ < most_rounds && mend()) {
    }
}

} // namespace topology
