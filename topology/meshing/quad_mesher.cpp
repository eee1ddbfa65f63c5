#include "topology/meshing/quad_mesher.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace topology {

namespace {

constexpr double least_of_pair = 0.2; // quality of what two triangles make; the rest waits
constexpr double worth_a_change = 0.01;
constexpr double good_enough = 0.5;       // quality that is not mended: sine of 30 degrees
constexpr double least_of_cell = 0.05;    // quality below which a quadrilateral is cut into two triangles
constexpr std::size_t n_whole_rounds = 4; // in which all is smoothed; then what lies around poor cells alone
constexpr int n_sweeps = 3;               // of smoothing, in a round

std::uint64_t edge_key(CellNode from, CellNode to) { return (std::uint64_t{from} << 32U) | to; }

double sine(const FlatVector& u, const FlatVector& v)
{
    const double lengths = length(u) * length(v);
    return lengths > 0.0 ? cross(u, v) / lengths : 0.0;
}

/// How often cells are recut and moved before the rest is taken for hopeless: each is work for all cells around.
std::size_t most_tries(std::size_t n_cells)
{
    return 40 + std::min(n_cells / 50, static_cast<std::size_t>(std::sqrt(static_cast<double>(n_cells))));
}

/// Whether a chain names a node twice: what it goes around meets itself.
bool meets_itself(std::vector<CellNode> chain)
{
    std::sort(chain.begin(), chain.end());
    return std::adjacent_find(chain.begin(), chain.end()) != chain.end();
}

} // namespace

double QuadMesher::quality(std::span<const FlatPoint> corners)
{
    const std::size_t n = corners.size();
    double least = 1.0;
    for (std::size_t i = 0; i < n; ++i)
        least = std::min(least, sine(corners[(i + 1) % n] - corners[i], corners[(i + n - 1) % n] - corners[i]));
    return n == 3 ? least * 2.0 / std::numbers::sqrt3 : least;
}

QuadMesher::QuadMesher(const MeshDomain& domain, MesherOptions options) : domain_(domain), options_(std::move(options))
{
    for (const auto& [a, b] : domain.segments) fixed_.push_back(edge_key(std::min(a, b), std::max(a, b)));
    std::sort(fixed_.begin(), fixed_.end());
    for (const auto& [edge, middle] : domain.bends)
        bends_.emplace(edge_key(std::min(edge[0], edge[1]), std::max(edge[0], edge[1])), middle);
}

QuadMesher::QuadMesher(const MeshDomain& domain, MesherOptions options, bool is_halved)
    : QuadMesher(domain, std::move(options))
{
    is_halved_ = is_halved;
}

QuadMesher::Step QuadMesher::next()
{
    made_.clear();
    return step();
}

QuadMesher::Step QuadMesher::step()
{
    if (!is_triangulated_) {
        triangulate();
        is_triangulated_ = true;
        return Step::Triangles;
    }
    if (pair_next()) return Step::Pair;
    if (paired_.empty()) paired_ = cells_;
    if (walk_next()) return Step::Walk;
    if (n_rounds_ < most_rounds && mend()) return Step::Mend;
    if (!std::exchange(is_cut_, true)) {
        cut_worst();
        if (worst(cells_) <= 0.0) fall_back();
        refill();
    }
    return Step::Done;
}

MeshMarks QuadMesher::marks() const
{
    MeshMarks marks;
    for (const CellIndex cell : made_) {
        if (cells_[cell].empty()) continue;
        marks.cells.emplace_back();
        for (const CellNode node : cells_[cell]) marks.cells.back().push_back(nodes_[node]);
    }
    return marks;
}

CellMesh QuadMesher::mesh() const
{
    CellMesh mesh;
    std::vector<bool> is_used(nodes_.size());
    std::fill_n(is_used.begin(), std::min(is_used.size(), domain_.nodes.size()), true);
    for (const Nodes& cell : cells_)
        for (const CellNode node : cell) is_used[node] = true;
    std::vector<CellNode> number(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        number[i] = static_cast<CellNode>(mesh.nodes.size());
        if (is_used[i]) mesh.nodes.push_back(nodes_[i]);
    }
    for (const Nodes& cell : cells_) {
        if (cell.size() == 3) mesh.cells.emplace_back(number[cell[0]], number[cell[1]], number[cell[2]]);
        if (cell.size() == 4)
            mesh.cells.emplace_back(number[cell[0]], number[cell[1]], number[cell[2]], number[cell[3]]);
    }
    return mesh;
}

void QuadMesher::triangulate()
{
    const CellMesh triangles = DelaunayMesher(domain_, options_).run();
    nodes_ = triangulated_ = triangles.nodes;
    for (const Cell& cell : triangles.cells) add({cell.nodes().begin(), cell.nodes().end()});
    find_pairs();
}

QuadMesher::CellIndex QuadMesher::add(const Nodes& nodes)
{
    const auto cell = static_cast<CellIndex>(cells_.size());
    cells_.emplace_back();
    put(cell, nodes);
    made_.push_back(cell);
    return cell;
}

void QuadMesher::put(CellIndex cell, const Nodes& nodes)
{
    cells_[cell] = nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) edges_[edge_key(nodes[i], nodes[(i + 1) % nodes.size()])] = cell;
}

void QuadMesher::remove(CellIndex cell)
{
    const Nodes nodes = std::exchange(cells_[cell], {});
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto found = edges_.find(edge_key(nodes[i], nodes[(i + 1) % nodes.size()]));
        if (found != edges_.end() && found->second == cell) edges_.erase(found);
    }
}

QuadMesher::CellIndex QuadMesher::across(CellNode from, CellNode to) const
{
    const auto found = edges_.find(edge_key(from, to));
    return found == edges_.end() ? none : found->second;
}

bool QuadMesher::is_fixed_edge(CellNode a, CellNode b) const
{
    return std::binary_search(fixed_.begin(), fixed_.end(), edge_key(std::min(a, b), std::max(a, b)));
}

std::vector<QuadMesher::CellIndex> QuadMesher::neighbours(CellIndex cell) const
{
    std::vector<CellIndex> found;
    const Nodes& nodes = cells_[cell];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const CellNode a = nodes[i], b = nodes[(i + 1) % nodes.size()];
        const CellIndex other = across(b, a);
        if (other != none && !is_fixed_edge(a, b)) found.push_back(other);
    }
    return found;
}

/// Counter-clockwise from the end of the shared edge, as the first one sees it: all of the first, then the rest.
QuadMesher::Nodes QuadMesher::outline(CellIndex a, CellIndex b) const
{
    const Nodes &first = cells_[a], &second = cells_[b];
    for (std::size_t i = 0; i < first.size(); ++i) {
        const CellNode from = first[i], to = first[(i + 1) % first.size()];
        if (across(to, from) != b) continue;
        Nodes around;
        for (std::size_t k = 1; k <= first.size(); ++k) around.push_back(first[(i + k) % first.size()]);
        const auto at = std::find(second.begin(), second.end(), from);
        const auto start = static_cast<std::size_t>(at - second.begin());
        for (std::size_t k = 1; k + 1 < second.size(); ++k) around.push_back(second[(start + k) % second.size()]);
        return around;
    }
    return {};
}

FlatVector QuadMesher::leaving(CellNode from, CellNode to) const
{
    const FlatVector chord = nodes_[to] - nodes_[from];
    if (from >= domain_.nodes.size() || to >= domain_.nodes.size()) return chord;
    const auto bend = bends_.find(edge_key(std::min(from, to), std::max(from, to)));
    return bend == bends_.end() ? chord : 4.0 * (bend->second - nodes_[from]) - chord;
}

double QuadMesher::quality(const Nodes& cell) const
{
    const std::size_t n = cell.size();
    if (bends_.empty()) {
        std::array<FlatPoint, 4> corners;
        for (std::size_t i = 0; i < n; ++i) corners[i] = nodes_[cell[i]];
        return quality(std::span(corners.data(), n));
    }
    double least = 1.0;
    for (std::size_t i = 0; i < n; ++i)
        least = std::min(least, sine(leaving(cell[i], cell[(i + 1) % n]), leaving(cell[i], cell[(i + n - 1) % n])));
    return n == 3 ? least * 2.0 / std::numbers::sqrt3 : least;
}

double QuadMesher::worst(const std::vector<Nodes>& cells) const
{
    double least = 1.0;
    for (const Nodes& cell : cells)
        if (!cell.empty()) least = std::min(least, quality(cell));
    return least;
}

void QuadMesher::find_pairs()
{
    for (CellIndex cell = 0; cell < cells_.size(); ++cell) {
        for (const CellIndex other : neighbours(cell))
            if (cell < other) {
                const double of_pair = quality(outline(cell, other));
                if (of_pair > least_of_pair) pairs_.push_back({cell, other, of_pair});
            }
        if (neighbours(cell).size() == 1) lonely_.push_back(cell);
    }
    std::stable_sort(pairs_.begin(), pairs_.end(),
                     [](const Pairing& a, const Pairing& b) { return a.quality > b.quality; });
}

void QuadMesher::pair(CellIndex a, CellIndex b)
{
    const Nodes around = outline(a, b);
    std::vector<CellIndex> beside = neighbours(a);
    const std::vector<CellIndex> of_b = neighbours(b);
    beside.insert(beside.end(), of_b.begin(), of_b.end());
    remove(a);
    remove(b);
    add(around);
    for (const CellIndex cell : beside) {
        if (cells_[cell].size() != 3) continue;
        const std::vector<CellIndex> left = neighbours(cell);
        if (std::count_if(left.begin(), left.end(), [&](CellIndex other) { return is_triangle(other); }) == 1)
            lonely_.push_back(cell);
    }
}

/// Pairs a triangle that has one partner left, else the two that make the best quadrilateral.
bool QuadMesher::pair_next()
{
    while (!lonely_.empty()) {
        const CellIndex cell = lonely_.back();
        lonely_.pop_back();
        if (cells_[cell].size() != 3) continue;
        for (const CellIndex other : neighbours(cell)) {
            if (!is_triangle(other) || quality(outline(cell, other)) <= least_of_pair) continue;
            pair(cell, other);
            return true;
        }
    }
    while (n_looked_ < pairs_.size()) {
        const Pairing& next = pairs_[n_looked_++];
        if (cells_[next.a].size() != 3 || cells_[next.b].size() != 3) continue;
        pair(next.a, next.b);
        return true;
    }
    return false;
}

/// Cells from a triangle to the nearest other one, both included; nothing where there is none.
std::vector<QuadMesher::CellIndex> QuadMesher::path_to_triangle(CellIndex from)
{
    reached_.resize(cells_.size());
    ++search_;
    const auto reach = [&](CellIndex cell, CellIndex before) {
        if (reached_[cell].search == search_) return;
        reached_[cell] = {before, search_};
        open_.push_back(cell);
    };
    open_.clear();
    reach(from, none);
    for (std::size_t i = 0; i < open_.size(); ++i) {
        const CellIndex cell = open_[i];
        if (cell == from || !is_triangle(cell)) {
            for (const CellIndex next : neighbours(cell)) reach(next, cell);
            continue;
        }
        std::vector<CellIndex> path;
        for (CellIndex each = cell; each != none; each = reached_[each].before) path.push_back(each);
        std::reverse(path.begin(), path.end());
        return path;
    }
    return {};
}

/// The triangle that a triangle and a quadrilateral are which share two edges, without the node between these.
QuadMesher::CellIndex QuadMesher::without_doublet(CellIndex triangle, CellIndex quadrilateral)
{
    Nodes rest;
    for (const CellNode node : cells_[quadrilateral]) {
        const Nodes& three = cells_[triangle];
        const auto at = std::find(three.begin(), three.end(), node);
        const bool is_shared_twice = at != three.end() && cells_around(node, {triangle}).size() == 2 && rest.size() < 3;
        if (!is_shared_twice) rest.push_back(node);
    }
    if (rest.size() != 3) return none;
    remove(triangle);
    remove(quadrilateral);
    return add(rest);
}

/// Cuts a triangle and the quadrilateral beside it anew, so that the triangle lies on the border to the cell ahead. The
/// triangle.
QuadMesher::CellIndex QuadMesher::step_through(CellIndex triangle, CellIndex through, CellIndex ahead)
{
    const Nodes five = outline(triangle, through);
    if (meets_itself(five)) return without_doublet(triangle, through);
    Nodes best_triangle, best_rest;
    double best = -2.0;
    for (std::size_t j = 0; j < five.size(); ++j) {
        if (across(five[(j + 1) % 5], five[j]) != ahead) continue;
        for (const std::size_t i : {j, (j + 4) % 5}) { // from the edge to the one ahead, and from the one before
            Nodes three{five[i], five[(i + 1) % 5], five[(i + 2) % 5]};
            Nodes rest{five[i], five[(i + 2) % 5], five[(i + 3) % 5], five[(i + 4) % 5]};
            const double of_both = worst({three, rest});
            if (of_both <= best) continue;
            best = of_both;
            best_triangle = std::move(three);
            best_rest = std::move(rest);
        }
    }
    remove(triangle);
    remove(through);
    add(best_rest);
    return add(best_triangle);
}

bool QuadMesher::walk_next()
{
    for (; walked_ < cells_.size(); ++walked_) {
        const CellIndex cell = walked_;
        if (cells_[cell].size() != 3) continue;
        const std::vector<CellIndex> path = path_to_triangle(cell);
        if (path.empty()) continue;
        CellIndex walking = cell;
        for (std::size_t i = 1; i + 1 < path.size() && walking != none; ++i)
            walking = step_through(walking, path[i], path[i + 1]);
        if (walking == none) continue;
        const Nodes around = outline(walking, path.back());
        if (around.size() != 4 || meets_itself(around)) continue;
        remove(walking);
        remove(path.back());
        add(around);
        return true;
    }
    return false;
}

/// Puts the best choice in place of cells, if it is better than these.
bool QuadMesher::recut(const std::vector<CellIndex>& cells, const std::vector<Choice>& choices)
{
    std::vector<Nodes> now;
    for (const CellIndex cell : cells) now.push_back(cells_[cell]);
    double best = worst(now) + worth_a_change;
    const Choice* chosen = nullptr;
    for (const Choice& choice : choices)
        if (const double of_choice = worst(choice); of_choice > best) {
            best = of_choice;
            chosen = &choice;
        }
    if (chosen == nullptr) return false;
    for (const CellIndex cell : cells) remove(cell);
    for (const Nodes& nodes : *chosen) add(nodes);
    return true;
}

/// Puts a choice in place of cells and moves its nodes to their best places, if all cells around are better for it.
bool QuadMesher::recut_and_move(const std::vector<CellIndex>& cells, const Choice& choice)
{
    if (++n_tries_ > most_tries(cells_.size())) return false;
    Nodes moving;
    for (const Nodes& nodes : choice)
        for (const CellNode node : nodes)
            if (node >= domain_.nodes.size()) moving.push_back(node);
    std::sort(moving.begin(), moving.end());
    moving.erase(std::unique(moving.begin(), moving.end()), moving.end());
    const auto worst_around = [&](const std::vector<CellIndex>& here) {
        double least = worst_of(here);
        for (const CellNode node : moving) least = std::min(least, worst_of(cells_around(node, here)));
        return least;
    };
    const double before = worst_around(cells);
    std::vector<FlatPoint> places;
    for (const CellNode node : moving) places.push_back(nodes_[node]);
    Choice old;
    for (const CellIndex cell : cells) {
        old.push_back(cells_[cell]);
        remove(cell);
    }
    std::vector<CellIndex> made;
    for (const Nodes& nodes : choice) made.push_back(add(nodes));
    constexpr int n_moves = 12;
    for (int i = 0; i < n_moves; ++i)
        for (const CellNode node : moving) move_to_best(node, cells_around(node, made));
    if (worst_around(made) > before + worth_a_change) return true;
    for (std::size_t i = 0; i < moving.size(); ++i) nodes_[moving[i]] = places[i];
    for (const CellIndex cell : made) remove(cell);
    for (std::size_t i = 0; i < cells.size(); ++i) put(cells[i], old[i]);
    return false;
}

/// All cells of a node, found from those of some cells that have it.
std::vector<QuadMesher::CellIndex> QuadMesher::cells_around(CellNode node, const std::vector<CellIndex>& known) const
{
    std::vector<CellIndex> found;
    const auto add_if_new = [&](CellIndex cell) {
        if (cell != none && std::find(found.begin(), found.end(), cell) == found.end()) found.push_back(cell);
    };
    const auto place_in = [&](CellIndex cell) { return std::find(cells_[cell].begin(), cells_[cell].end(), node); };
    for (const CellIndex cell : known)
        if (place_in(cell) != cells_[cell].end()) add_if_new(cell);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Nodes& nodes = cells_[found[i]];
        const auto at = static_cast<std::size_t>(place_in(found[i]) - nodes.begin());
        add_if_new(across(nodes[(at + 1) % nodes.size()], node));
        add_if_new(across(node, nodes[(at + nodes.size() - 1) % nodes.size()]));
    }
    return found;
}

/// Two cells that have another edge between them, or another triangle.
std::vector<QuadMesher::Choice> QuadMesher::turned_edges(CellIndex a, CellIndex b) const
{
    const Nodes around = outline(a, b);
    const std::size_t n = around.size();
    std::vector<Choice> choices;
    const auto at = [&](std::size_t i) { return around[i % n]; };
    const auto is_new = [&](CellNode from, CellNode to) {
        return across(from, to) == none && across(to, from) == none;
    };
    if (meets_itself(around)) return choices;
    if (n == 6)
        for (const std::size_t i : {1U, 2U})
            if (is_new(at(i), at(i + 3)))
                choices.push_back({{at(i), at(i + 1), at(i + 2), at(i + 3)}, {at(i + 3), at(i + 4), at(i + 5), at(i)}});
    if (n == 5)
        for (std::size_t i = 0; i < n; ++i)
            if (is_new(at(i), at(i + 2)))
                choices.push_back({{at(i), at(i + 1), at(i + 2)}, {at(i), at(i + 2), at(i + 3), at(i + 4)}});
    return choices;
}

/// Three quadrilaterals around a node in place of two.
std::vector<QuadMesher::Choice> QuadMesher::around_node(CellIndex a, CellIndex b, CellNode centre) const
{
    const Nodes around = outline(a, b);
    std::vector<Choice> choices;
    if (around.size() != 6 || meets_itself(around)) return choices;
    for (const std::size_t i : {0U, 1U}) {
        choices.emplace_back();
        for (std::size_t k = i; k < i + 6; k += 2)
            choices.back().push_back({around[k % 6], around[(k + 1) % 6], around[(k + 2) % 6], centre});
    }
    return choices;
}

/// The cells around one corner with the opposite one in its place, without the cell itself, which goes.
std::optional<QuadMesher::Choice> QuadMesher::without_cell(const std::vector<CellIndex>& around, CellIndex cell,
                                                           std::size_t corner) const
{
    const Nodes& four = cells_[cell];
    const CellNode gone = four[corner], kept = four[(corner + 2) % 4];
    const auto are_joined = [&](CellNode a, CellNode b) { return across(a, b) != none || across(b, a) != none; };
    Choice choice;
    for (const CellIndex each : around) {
        if (each == cell) continue;
        Nodes nodes = cells_[each];
        const auto at = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), gone) - nodes.begin());
        for (const CellNode next : {nodes[(at + 1) % nodes.size()], nodes[(at + nodes.size() - 1) % nodes.size()]}) {
            const bool is_of_cell = std::find(four.begin(), four.end(), next) != four.end();
            if (next == kept || (!is_of_cell && are_joined(next, kept))) return std::nullopt;
        }
        nodes[at] = kept;
        if (meets_itself(nodes)) return std::nullopt;
        choice.push_back(std::move(nodes));
    }
    return choice;
}

/// Takes a flat cell out by joining two opposite corners.
bool QuadMesher::collapse(CellIndex cell)
{
    if (cells_[cell].size() != 4) return false;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const CellNode gone = cells_[cell][corner];
        if (gone < domain_.nodes.size()) continue;
        const std::vector<CellIndex> around = cells_around(gone, {cell});
        const std::optional<Choice> choice = without_cell(around, cell, corner);
        if (choice && recut_and_move(around, *choice)) return true;
    }
    return false;
}

/// Turns an edge of the cell where that helps at once; else, if the cell is poor, tries each change with the moves that
/// it allows.
bool QuadMesher::mend_cell(CellIndex cell)
{
    const std::vector<CellIndex> beside = neighbours(cell);
    for (const CellIndex other : beside)
        if (recut({cell, other}, turned_edges(cell, other))) return true;
    if (quality(cells_[cell]) > least_of_pair) return false;
    if (collapse(cell)) return true;
    for (const CellIndex other : beside)
        for (const Choice& choice : turned_edges(cell, other))
            if (recut_and_move({cell, other}, choice)) return true;
    for (const CellIndex other : beside) {
        const auto centre = static_cast<CellNode>(nodes_.size());
        const Nodes& nodes = cells_[cell];
        nodes_.push_back(middle(middle(nodes_[nodes[0]], nodes_[nodes[1]]), nodes_[nodes[2]]));
        for (const Choice& choice : around_node(cell, other, centre))
            if (recut_and_move({cell, other}, choice)) return true;
        nodes_.pop_back();
    }
    return false;
}

std::vector<std::vector<QuadMesher::CellIndex>> QuadMesher::cells_of_nodes() const
{
    std::vector<std::vector<CellIndex>> found(nodes_.size());
    for (CellIndex cell = 0; cell < cells_.size(); ++cell)
        for (const CellNode node : cells_[cell]) found[node].push_back(cell);
    return found;
}

/// Takes out nodes inside that have two quadrilaterals alone, which become one.
bool QuadMesher::remove_doublets()
{
    bool has_changed = false;
    const std::vector<std::vector<CellIndex>> of_node = cells_of_nodes();
    for (std::size_t node = domain_.nodes.size(); node < of_node.size(); ++node) {
        if (of_node[node].size() != 2) continue;
        const Nodes first = cells_[of_node[node][0]], second = cells_[of_node[node][1]];
        if (first.size() != 4 || second.size() != 4) continue; // one has changed, or is a triangle
        const auto other_corner = [&](const Nodes& cell, std::size_t ahead) {
            const auto at = std::find(cell.begin(), cell.end(), static_cast<CellNode>(node));
            return cell[(static_cast<std::size_t>(at - cell.begin()) + ahead) % 4];
        };
        const Nodes joined{other_corner(first, 1), other_corner(first, 2), other_corner(first, 3),
                           other_corner(second, 2)};
        if (quality(joined) <= 0.0) continue;
        remove(of_node[node][0]);
        remove(of_node[node][1]);
        add(joined);
        has_changed = true;
    }
    return has_changed;
}

/// Moves each place inside towards the middle of its neighbours, as far as its worst cell gets no worse; where that is
/// poor, to the best of the places around.
void QuadMesher::smooth_all()
{
    const std::vector<std::vector<CellIndex>> of_node = cells_of_nodes();
    for (int i = 0; i < n_sweeps; ++i)
        for (std::size_t node = domain_.nodes.size(); node < of_node.size(); ++node)
            if (!of_node[node].empty()) smooth(static_cast<CellNode>(node), of_node[node]);
}

void QuadMesher::smooth(CellNode node, const std::vector<CellIndex>& around)
{
    move_to_middle(node, around);
    if (worst_of(around) < good_enough) move_to_best(node, around);
}

/// The same around poor cells alone, two rings wide.
void QuadMesher::smooth_poor()
{
    std::vector<CellIndex> near = poor_cells();
    constexpr int n_rings = 2;
    for (int ring = 0; ring < n_rings; ++ring) {
        const std::size_t n = near.size();
        for (std::size_t i = 0; i < n; ++i)
            for (const CellIndex other : neighbours(near[i])) near.push_back(other);
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
    }
    for (int i = 0; i < n_sweeps; ++i)
        for (const CellIndex cell : near)
            for (const CellNode node : cells_[cell])
                if (node >= domain_.nodes.size()) smooth(node, cells_around(node, {cell}));
}

std::vector<QuadMesher::CellIndex> QuadMesher::poor_cells() const
{
    std::vector<CellIndex> poor;
    for (CellIndex cell = 0; cell < cells_.size(); ++cell)
        if (!cells_[cell].empty() && quality(cells_[cell]) < good_enough) poor.push_back(cell);
    return poor;
}

double QuadMesher::worst_of(const std::vector<CellIndex>& cells) const
{
    double least = 1.0;
    for (const CellIndex cell : cells) least = std::min(least, quality(cells_[cell]));
    return least;
}

void QuadMesher::move_to_middle(CellNode node, const std::vector<CellIndex>& around)
{
    const FlatPoint before = nodes_[node];
    FlatVector sum;
    for (const CellIndex cell : around) {
        const Nodes& nodes = cells_[cell];
        const auto at = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
        sum = sum + (nodes_[nodes[(at + 1) % nodes.size()]] - before);
    }
    const double least = worst_of(around);
    for (double share = 1.0; share > 0.1; share *= 0.5) {
        nodes_[node] = before + (share / static_cast<double>(around.size())) * sum;
        const double now = worst_of(around);
        if (now >= least || now >= good_enough) return;
    }
    nodes_[node] = before;
}

/// Looks around in steps that get smaller, as large as the mean distance from the neighbours at first.
void QuadMesher::move_to_best(CellNode node, const std::vector<CellIndex>& around)
{
    constexpr int n_directions = 8;
    double reach = 0.0;
    for (const CellIndex cell : around)
        for (const CellNode other : cells_[cell])
            reach += distance(nodes_[other], nodes_[node]) / static_cast<double>(3 * around.size());
    double best = worst_of(around);
    for (double step = 0.5 * reach; step > 0.02 * reach; step *= 0.5) {
        const FlatPoint from = nodes_[node];
        FlatPoint best_place = from;
        for (int i = 0; i < n_directions; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / n_directions;
            nodes_[node] = from + step * FlatVector{std::cos(angle), std::sin(angle)};
            const double now = worst_of(around);
            if (now <= best) continue;
            best = now;
            best_place = nodes_[node];
        }
        nodes_[node] = best_place;
    }
}

/// One look at all poor cells. False where nothing is left to be mended, or nothing helps.
bool QuadMesher::mend()
{
    ++n_rounds_;
    const double before = worst(cells_);
    bool has_changed = remove_doublets();
    for (const CellIndex cell : poor_cells())
        if (!cells_[cell].empty()) has_changed = mend_cell(cell) || has_changed;
    const bool is_whole = n_rounds_ <= n_whole_rounds;
    if (is_whole) smooth_all();
    else smooth_poor();
    return has_changed || is_whole || worst(cells_) > before;
}

/// The pairs as they were before triangles walked: with more triangles, and each cell as it should be.
void QuadMesher::fall_back()
{
    nodes_ = std::move(triangulated_);
    cells_ = std::move(paired_);
    edges_.clear();
    for (CellIndex cell = 0; cell < cells_.size(); ++cell) {
        const Nodes nodes = cells_[cell];
        put(cell, nodes);
    }
}

/// What could not be mended becomes two triangles.
void QuadMesher::cut_worst()
{
    const std::size_t n = cells_.size();
    for (CellIndex cell = 0; cell < n; ++cell) {
        const Nodes four = cells_[cell];
        if (four.size() != 4 || quality(four) > least_of_cell) continue;
        const std::vector<Nodes> first{{four[0], four[1], four[2]}, {four[0], four[2], four[3]}},
            second{{four[0], four[1], four[3]}, {four[1], four[2], four[3]}};
        remove(cell);
        for (const Nodes& three : worst(first) > worst(second) ? first : second) add(three);
    }
}

} // namespace topology
