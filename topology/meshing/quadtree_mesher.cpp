#include "topology/meshing/quadtree_mesher.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace topology {

namespace {

constexpr double largest_square = 1.2; // its side over the edge that is wanted
constexpr double band_width = 0.5;     // of the tree's places from the boundary, over the side of their squares
constexpr std::size_t most_squares = 8'000'000;

double distance_to_part(const FlatPoint& at, const FlatPoint& a, const FlatPoint& b)
{
    const FlatVector along = b - a;
    const double squared = dot(along, along);
    const double share = squared > 0.0 ? std::clamp(dot(at - a, along) / squared, 0.0, 1.0) : 0.0;
    return distance(at, a + share * along);
}

/// Whether a straight part comes into a box: no line along an axis or the part keeps them apart.
bool part_meets(const FlatBox& box, const FlatPoint& a, const FlatPoint& b)
{
    FlatBox of_part;
    of_part.add(a);
    of_part.add(b);
    if (!box.meets(of_part)) return false;
    const FlatPoint corners[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    int n_left = 0, n_right = 0;
    for (const FlatPoint& corner : corners) {
        const double side = turn(a, b, corner);
        n_left += side >= 0.0 ? 1 : 0;
        n_right += side <= 0.0 ? 1 : 0;
    }
    return n_left < 4 || n_right < 4 || a == b;
}

} // namespace

/// The largest squares inside are as large as edges are wanted.
Quadtree QuadtreeMesher::tree_around(const MeshDomain& domain, double size)
{
    FlatBox box;
    for (const FlatPoint& node : domain.nodes) box.add(node);
    const double extent = std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1e-300});
    const double side = size > 0.0 && size < extent ? size * std::exp2(std::ceil(std::log2(extent / size))) : extent;
    const FlatPoint centre = middle(box.low, box.high);
    return {{centre.x - 0.5 * side, centre.y - 0.5 * side}, side};
}

QuadtreeMesher::QuadtreeMesher(const MeshDomain& domain, MesherOptions options)
    : given_(domain),
      options_(std::move(options)),
      domain_(domain),
      outline_(domain),
      inside_(domain),
      tree_(tree_around(domain, options_.size)),
      around_(1)
{
    list_borders();
}

void QuadtreeMesher::list_borders()
{
    const std::vector<double> sizes = given_.sizes(options_.size, options_.sizes);
    std::vector<bool> is_alone(sizes.size(), true);
    for (const auto& [a, b] : given_.edges()) {
        const double length = distance(given_.nodes[a], given_.nodes[b]);
        borders_.push_back({given_.nodes[a], given_.nodes[b], std::min({length, sizes[a], sizes[b]})});
        is_alone[a] = is_alone[b] = false;
    }
    for (std::size_t i = 0; i < sizes.size(); ++i)
        if (is_alone[i]) borders_.push_back({given_.nodes[i], given_.nodes[i], sizes[i]});
    for (std::uint32_t i = 0; i < borders_.size(); ++i) around_[0].borders.push_back(i);
}

QuadtreeMesher::Step QuadtreeMesher::next()
{
    if (stage_ == Stage::Outline) {
        if (const auto made = outline_.next()) return last_ = *made;
        stage_ = Stage::Cut;
    }
    if (stage_ == Stage::Cut) {
        if (cut_next()) return last_ = Step::Quarter;
        stage_ = Stage::Balance;
        looked_ = 0;
    }
    if (stage_ == Stage::Balance) {
        if (balance_next()) return last_ = Step::Quarter;
        stage_ = Stage::Fill;
        looked_ = 0;
        list_places();
    }
    if (stage_ == Stage::Fill) {
        if (fill_next()) return last_ = Step::Pattern;
        stage_ = Stage::Smooth;
        make_band();
        return last_ = Step::Band;
    }
    if (n_sweeps_++ >= options_.n_sweeps || !band_->is_smoothed()) return last_ = Step::Done;
    band_->smooth(DomainTriangulation::vertex(static_cast<CellNode>(given_.nodes.size())));
    return last_ = Step::Smoothed;
}

bool QuadtreeMesher::is_too_large(Index square) const
{
    if (tree_[square].level >= Quadtree::deepest || tree_.size() > most_squares) return false;
    const Surroundings& around = around_[square];
    if (around.is_outside) return false;
    const double side = tree_.side(square);
    const FlatBox box = tree_.box(square);
    if (side > largest_square * options_.limited(side, middle(box.low, box.high))) return true;
    return std::any_of(around.borders.begin(), around.borders.end(),
                       [&](std::uint32_t i) { return side > largest_square * borders_[i].size; });
}

/// Which borders of the square's own are near its quarter, and where nothing is near, on which side it lies.
void QuadtreeMesher::look_around(Index square)
{
    Surroundings& around = around_[square];
    const FlatBox box = tree_.box(square).grown(band_width * tree_.side(square));
    std::erase_if(around.borders, [&](std::uint32_t i) { return !part_meets(box, borders_[i].a, borders_[i].b); });
    if (!around.borders.empty() || around.is_inside || around.is_outside) return;
    around.is_inside = inside_.has_inside(middle(box.low, box.high));
    around.is_outside = !around.is_inside;
}

void QuadtreeMesher::cut(Index square)
{
    last_square_ = square;
    tree_.quarter(square);
    const Surroundings of_whole = std::exchange(around_[square], {});
    around_.resize(tree_.size(), of_whole);
    for (Index quarter = tree_[square].first_quarter; quarter < tree_.size(); ++quarter) look_around(quarter);
}

bool QuadtreeMesher::cut_next()
{
    for (; looked_ < tree_.size(); ++looked_) {
        if (!tree_[looked_].is_leaf() || !is_too_large(looked_)) continue;
        cut(looked_++);
        return true;
    }
    return false;
}

/// Cuts a square that has a side against another one of less than half its size. What is cut is looked at again later,
/// as part of the round that follows.
bool QuadtreeMesher::balance_next()
{
    for (; looked_ < tree_.size(); ++looked_) {
        const Quadtree::Square here = tree_[looked_];
        if (!here.is_leaf() || around_[looked_].is_outside) continue;
        const Quadtree::Step half = here.side() / 2, side = here.side();
        const std::array<Place, 4> beside{Place{here.y + half, here.x + side},
                                          {here.y + side, here.x + half},
                                          {here.y + half, here.x - 1},
                                          {here.y - 1, here.x + half}};
        for (const auto& [y, x] : beside) {
            if (!Quadtree::has(x, y)) continue; // past 0 a step is the largest number
            const Index other = tree_.leaf_at(x, y);
            if (tree_[other].level + 1 >= here.level || around_[other].is_outside) continue;
            if (tree_.size() > most_squares) return false;
            cut(other); // this one is looked at again
            return true;
        }
    }
    return false;
}

/// Corners of leaves that are inside, and far enough from the boundary for every square that has them.
void QuadtreeMesher::list_places()
{
    for (Index leaf = 0; leaf < tree_.size(); ++leaf)
        if (tree_[leaf].is_leaf() && !around_[leaf].is_outside) list_corners(leaf);
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    std::erase_if(places_, [&](const Place& place) {
        const FlatPoint at = tree_.place(place.second, place.first);
        bool is_known_inside = false, is_near = false;
        for (const Quadtree::Step back_x : {Quadtree::Step{0}, Quadtree::Step{1}})
            for (const Quadtree::Step back_y : {Quadtree::Step{0}, Quadtree::Step{1}}) {
                const Quadtree::Step x = place.second - back_x, y = place.first - back_y;
                if (!Quadtree::has(x, y)) continue;
                const Index leaf = tree_.leaf_at(x, y);
                is_known_inside = is_known_inside || around_[leaf].is_inside;
                is_near = is_near ||
                          std::any_of(around_[leaf].borders.begin(), around_[leaf].borders.end(), [&](std::uint32_t i) {
                              return distance_to_part(at, borders_[i].a, borders_[i].b) < band_width * tree_.side(leaf);
                          });
            }
        return is_near || (!is_known_inside && !inside_.has_inside(at));
    });
    for (const auto& [y, x] : places_) domain_.nodes.push_back(tree_.place(x, y));
}

void QuadtreeMesher::list_corners(Index leaf)
{
    const Quadtree::Square& here = tree_[leaf];
    for (const Quadtree::Step x : {here.x, here.x + here.side()})
        for (const Quadtree::Step y : {here.y, here.y + here.side()}) places_.emplace_back(y, x);
}

bool QuadtreeMesher::stands(const Place& place) const
{
    return std::binary_search(places_.begin(), places_.end(), place);
}

CellNode QuadtreeMesher::node(const Place& place) const
{
    const auto at = std::lower_bound(places_.begin(), places_.end(), place);
    return static_cast<CellNode>(given_.nodes.size() + static_cast<std::size_t>(at - places_.begin()));
}

/// Nodes around a square from its lower left corner, counter-clockwise, those in the middle of sides between.
std::array<std::optional<CellNode>, 8> QuadtreeMesher::outline(Index leaf) const
{
    const Quadtree::Square& here = tree_[leaf];
    const Quadtree::Step half = here.side() / 2, x = here.x, y = here.y, right = x + 2 * half, top = y + 2 * half;
    const std::array<Place, 8> around{Place{y, x},  {y, x + half},   {y, right}, {y + half, right},
                                      {top, right}, {top, x + half}, {top, x},   {y + half, x}};
    std::array<std::optional<CellNode>, 8> nodes;
    for (std::size_t i = 0; i < around.size(); ++i)
        if (stands(around[i])) nodes[i] = node(around[i]);
    return nodes;
}

/// Whether a square becomes cells of its own: all its corners stand, and what is cut beside it has its node there.
bool QuadtreeMesher::is_filled(Index leaf) const
{
    constexpr double margin = 1e-9;
    const Quadtree::Square& here = tree_[leaf];
    if (!here.is_leaf() || around_[leaf].is_outside || here.side() < 2) return false;
    const FlatBox box = tree_.box(leaf).grown(margin * tree_.side(leaf));
    const auto& near = around_[leaf].borders;
    if (std::any_of(near.begin(), near.end(),
                    [&](std::uint32_t i) { return part_meets(box, borders_[i].a, borders_[i].b); }))
        return false;
    const auto nodes = outline(leaf);
    return nodes[0] && nodes[2] && nodes[4] && nodes[6];
}

bool QuadtreeMesher::fill_next()
{
    for (; looked_ < tree_.size(); ++looked_) {
        if (!is_filled(looked_)) continue;
        last_square_ = looked_;
        n_cells_before_ = cells_.size();
        fill(outline(looked_++));
        return true;
    }
    return false;
}

/// The corners between two cut sides first, then what is left: the middle of a side sees all the rest.
void QuadtreeMesher::fill(const std::array<std::optional<CellNode>, 8>& outline)
{
    std::vector<CellNode> rest;
    std::size_t first_middle = 0;
    bool has_middle = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (!outline[i]) continue;
        const auto &before = outline[(i + 7) % 8], &behind = outline[(i + 1) % 8];
        if (i % 2 == 0 && before && behind) {
            cells_.emplace_back(*before, *outline[i], *behind);
            continue;
        }
        if (i % 2 == 1 && !has_middle) {
            has_middle = true;
            first_middle = rest.size();
        }
        rest.push_back(*outline[i]);
    }
    std::rotate(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(first_middle), rest.end());
    for (std::size_t i = 1; i + 1 < rest.size(); ++i) cells_.emplace_back(rest[0], rest[i], rest[i + 1]);
}

std::vector<CellEdge> QuadtreeMesher::pattern_edges() const
{
    std::vector<CellEdge> edges;
    for (const Cell& cell : cells_)
        for (std::size_t i = 0; i < 3; ++i) {
            const CellNode a = cell.nodes()[i], b = cell.nodes()[(i + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b)});
        }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

/// The triangulation of all nodes, in which the edges of the patterns are made too; the rest is the band.
void QuadtreeMesher::make_band()
{
    band_.emplace(domain_);
    while (band_->next()) {
    }
    std::vector<CellEdge> edges = pattern_edges();
    std::erase_if(edges, [&](const CellEdge& edge) {
        return band_->triangles()
            .fix(DomainTriangulation::vertex(edge[0]), DomainTriangulation::vertex(edge[1]))
            .has_value();
    });
    for (const auto& [a, b] : edges)
        band_->triangles().release(DomainTriangulation::vertex(a), DomainTriangulation::vertex(b));
}

CellMesh QuadtreeMesher::mesh() const
{
    if (stage_ == Stage::Outline) return outline_.mesh();
    if (band_) return band_->mesh();
    return {domain_.nodes, cells_};
}

MeshMarks QuadtreeMesher::marks() const
{
    MeshMarks marks;
    if (last_ == Step::Node) marks.places = {outline_.triangles().at(outline_.last_vertex())};
    if (last_ == Step::Edge) marks.edges = {outline_.last_edge()};
    const auto sides = [&](Index square) {
        const FlatBox box = tree_.box(square);
        const FlatPoint right{box.high.x, box.low.y}, left{box.low.x, box.high.y};
        return std::array<std::array<FlatPoint, 2>, 4>{
            {{box.low, right}, {right, box.high}, {box.high, left}, {left, box.low}}};
    };
    if (stage_ != Stage::Outline && stage_ != Stage::Smooth)
        for (Index square = 0; square < tree_.size(); ++square)
            if (tree_[square].is_leaf())
                for (const auto& side : sides(square)) marks.lines.push_back(side);
    if (last_ == Step::Quarter)
        for (const auto& side : sides(last_square_)) marks.edges.push_back(side);
    if (last_ == Step::Pattern)
        for (std::size_t i = n_cells_before_; i < cells_.size(); ++i) {
            marks.cells.emplace_back();
            for (const CellNode node : cells_[i].nodes()) marks.cells.back().push_back(domain_.nodes[node]);
        }
    return marks;
}

} // namespace topology
