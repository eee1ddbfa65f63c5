#include "apps/plane/discretize/region_mesher.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "apps/plane/discretize/entry_name.h"
#include "apps/plane/discretize/untangle.h"
#include "femoop/element/continuum/continuum_formulation.h"
#include "femoop/element/continuum/element_geometry.h"
#include "topology/meshing/delaunay_mesher.h"
#include "topology/meshing/front_mesher.h"
#include "topology/meshing/quad_mesher.h"
#include "topology/meshing/quadtree_mesher.h"
#include "topology/meshing/row_mesher.h"

namespace discretize {

namespace {

using femoop::FaultKind;
using femoop::plane::RegionId;
using topology::Cell;
using topology::CellNode;
using topology::EdgeId;
using topology::FlatPoint;
using topology::HalfEdgeId;
using topology::VertexId;

std::uint64_t key_of(CellNode a, CellNode b) { return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b); }

/// The same cell by other numbers.
Cell renumbered(const Cell& cell, const std::vector<CellNode>& numbers)
{
    const auto nodes = cell.nodes();
    if (cell.is_triangle()) return {numbers[nodes[0]], numbers[nodes[1]], numbers[nodes[2]]};
    return {numbers[nodes[0]], numbers[nodes[1]], numbers[nodes[2]], numbers[nodes[3]]};
}

/// The shape of a cell's element: a triangle among quadrilaterals has middle nodes if these have.
femoop::ShapeKind kind_of(const Cell& cell, const MeshSettings& settings)
{
    if (!cell.is_triangle() || settings.is_triangle()) return settings.element;
    return settings.is_quadratic() ? femoop::ShapeKind::T6 : femoop::ShapeKind::T3;
}

/// The smallest angle of a triangle [degrees].
double smallest_angle_of(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
{
    const auto angle = [](const topology::FlatVector& u, const topology::FlatVector& v) {
        return std::atan2(std::abs(cross(u, v)), dot(u, v)) * 180.0 / std::numbers::pi;
    };
    return std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
}

} // namespace

RegionMesher::RegionMesher(const Drawing& drawing, const std::vector<FaceOutline>& outlines,
                           const std::vector<MeshSettings>& settings, const EdgeDivisions& divisions,
                           std::function<bool()> is_cancelled)
    : drawing_(drawing),
      outlines_(outlines),
      settings_(settings),
      divisions_(divisions),
      is_cancelled_(std::move(is_cancelled)),
      of_vertex_(drawing.subdivision().solid().vertices().n_rows()),
      chains_(drawing.subdivision().solid().edges().n_rows()),
      is_quadratic_(chains_.size()),
      reports_(drawing.model().regions.size())
{}

std::string RegionMesher::entry(RegionId region) const
{
    return entry_of("regions", drawing_.model().regions, region.index);
}

bool RegionMesher::prepare()
{
    require_possible();
    require_one_order();
    if (!errors_.empty()) return false;
    const topology::Solid& solid = drawing_.subdivision().solid();
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
        const auto use = [&](EdgeId e) {
            if (settings_[i].is_quadratic()) is_quadratic_[e.index] = true;
            divide(e);
        };
        for (const OutlineLoop& loop : outlines_[i].loops)
            for (const HalfEdgeId h : loop) use(*solid.edge(h));
        for (const EdgeId e : outlines_[i].inner_edges) use(e);
        for (const VertexId v : outlines_[i].inner_vertices) node_at(v);
    }
    for (const EdgeId e : solid.edges()) {
        const Chain& chain = chains_[e.index];
        if (!is_quadratic_[e.index]) continue;
        const EdgeShares& shares = divisions_.shares(e);
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            set_middle(chain[i], chain[i + 1],
                       add_node(place_on_edge(drawing_.subdivision(), e, 0.5 * (shares[i] + shares[i + 1]))));
    }
    return true;
}

void RegionMesher::run()
{
    if (!prepare()) return;
    const std::size_t n_of_curves = nodes_.size();
    for (std::size_t i = 0; i < outlines_.size() && errors_.empty(); ++i) mesh(i);
    if (!errors_.empty()) return;
    std::vector<bool> is_held(nodes_.size());
    std::fill_n(is_held.begin(), n_of_curves, true);
    untangle(nodes_, elements_, is_held);
    require_right_way_round();
}

RegionMesh RegionMesher::mesh() const
{
    RegionMesh mesh{.nodes = nodes_,
                    .elements = elements_,
                    .of_vertex = of_vertex_,
                    .chains = chains_,
                    .on_edges = {},
                    .reports = reports_};
    for (const EdgeId e : drawing_.subdivision().solid().edges()) {
        const Chain& chain = chains_[e.index];
        if (chain.empty()) continue;
        const EdgeShares& shares = divisions_.shares(e);
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            if (i > 0) mesh.on_edges.push_back({chain[i], e, shares[i]});
            if (const auto middle = middles_.find(key_of(chain[i], chain[i + 1])); middle != middles_.end())
                mesh.on_edges.push_back({middle->second, e, 0.5 * (shares[i] + shares[i + 1])});
        }
    }
    return mesh;
}

/// About as many elements as an outline gets.
double RegionMesher::n_expected(std::size_t outline) const
{
    const auto n_parts = [&](const OutlineLoop& loop) {
        double n = 0.0;
        for (const HalfEdgeId h : loop)
            n += static_cast<double>(divisions_.shares(*drawing_.subdivision().solid().edge(h)).size() - 1);
        return n;
    };
    const MeshSettings& settings = settings_[outline];
    if (const auto& sides = divisions_.mapped()[outline]) {
        const double n_quadrilaterals = n_parts((*sides)[0]) * n_parts((*sides)[1]);
        if (settings.is_trilateral()) return (settings.is_triangle() ? 1.0 : 0.75) * n_quadrilaterals;
        if (!settings.is_triangle()) return n_quadrilaterals;
        return (settings.diagonal == topology::Diagonal::Cross ? 4.0 : 2.0) * n_quadrilaterals;
    }
    constexpr double equilateral = 0.25 * std::numbers::sqrt3; // its area by that of its side's square
    double n = drawing_.faces()[outlines_[outline].face].area / (equilateral * settings.size * settings.size);
    for (const OutlineLoop& loop : outlines_[outline].loops)
        for (const HalfEdgeId h : loop) n += n_beside(h, settings.size) / (equilateral * topology::usual_growth);
    return settings.is_triangle() ? n : 0.5 * n;
}

/// Along an edge that is divided finer than the size inside, triangles that grow with the distance from it, by the
/// integral of 1 / (h + growth y)^2: parts of it, each by what it is smaller.
double RegionMesher::n_beside(HalfEdgeId h, double size) const
{
    const EdgeShares& shares = divisions_.shares(*drawing_.subdivision().solid().edge(h));
    double n = 0.0;
    for (std::size_t i = 0; i + 1 < shares.size(); ++i)
        n += std::max(0.0, 1.0 - (shares[i + 1] - shares[i]) * divisions_.length(h) / size);
    return n;
}

/// By what an outline is meshed: what its region asks for, or what suits it.
std::string RegionMesher::method_of(std::size_t outline) const
{
    const MeshSettings& settings = settings_[outline];
    if (settings.method != "auto") return settings.method;
    if (divisions_.mapped()[outline]) return "mapped";
    return settings.is_triangle() ? "delaunay" : "quads";
}

void RegionMesher::require_possible()
{
    double n = 0.0;
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
        n += n_expected(i);
        const MeshSettings& settings = settings_[i];
        const RegionId region = outlines_[i].region;
        if (divisions_.mapped()[i] || settings.is_map()) continue;
        const std::string method = method_of(i);
        const bool makes_triangles = method != "quads";
        if (makes_triangles != settings.is_triangle())
            errors_.push_back({FaultKind::MeshMethodOfElement,
                               {entry(region), method, std::string(name(settings.element)),
                                makes_triangles ? "T3, T6" : "Q4, Q8, Q9"}});
    }
    if (n > static_cast<double>(femoop::plane::most_elements))
        errors_.push_back(
            {FaultKind::MeshTooLarge, {rounded(std::min(n, 1e300)), std::to_string(femoop::plane::most_elements)}});
}

/// On a border both regions have nodes in the middle of edges, or neither.
void RegionMesher::require_one_order()
{
    std::vector<std::optional<std::size_t>> first(chains_.size());
    for (std::size_t i = 0; i < outlines_.size(); ++i)
        for (const OutlineLoop& loop : outlines_[i].loops)
            for (const HalfEdgeId h : loop) {
                std::optional<std::size_t>& other = first[drawing_.subdivision().solid().edge(h)->index];
                if (!other) other = i;
                if (settings_[*other].is_quadratic() == settings_[i].is_quadratic()) continue;
                errors_.push_back({FaultKind::MeshOrdersDiffer,
                                   {entry(outlines_[i].region), std::string(name(settings_[i].element)),
                                    entry(outlines_[*other].region), std::string(name(settings_[*other].element))}});
                return;
            }
}

/// Elements that curves have turned inside out: the first of each region is told.
void RegionMesher::require_right_way_round()
{
    std::vector<bool> is_told(drawing_.model().regions.size());
    femoop::GeometryChecks checks(drawing_.model().analysis);
    for (const MeshedElement& element : elements_) {
        if (is_told[element.region.index]) continue;
        femoop::NodePositions X(static_cast<Eigen::Index>(element.nodes.size()), 2);
        for (std::size_t i = 0; i < element.nodes.size(); ++i)
            X.row(static_cast<Eigen::Index>(i)) << nodes_[element.nodes[i]].x, nodes_[element.nodes[i]].y;
        if (!checks.of(element.kind).fault(X)) continue;
        is_told[element.region.index] = true;
        const FlatPoint at = middle(nodes_[element.nodes[0]],
                                    middle(nodes_[element.nodes[1]], nodes_[element.nodes[2]]));
        errors_.push_back({FaultKind::MeshElementTurned, {entry(element.region), place_text(drawing_.model(), at)}});
    }
}

CellNode RegionMesher::add_node(const FlatPoint& at)
{
    nodes_.push_back(at);
    return static_cast<CellNode>(nodes_.size() - 1);
}

CellNode RegionMesher::node_at(VertexId vertex)
{
    std::optional<CellNode>& known = of_vertex_[vertex.index];
    if (!known) known = add_node(drawing_.subdivision().at(vertex));
    return *known;
}

void RegionMesher::divide(EdgeId edge)
{
    Chain& chain = chains_[edge.index];
    if (!chain.empty()) return;
    const topology::Solid& solid = drawing_.subdivision().solid();
    const EdgeShares& shares = divisions_.shares(edge);
    chain.push_back(node_at(solid.start(solid.plus(edge))));
    for (std::size_t i = 1; i + 1 < shares.size(); ++i)
        chain.push_back(add_node(place_on_edge(drawing_.subdivision(), edge, shares[i])));
    chain.push_back(node_at(solid.end(solid.plus(edge))));
}

RegionMesher::Chain RegionMesher::chain_along(HalfEdgeId h) const
{
    const topology::Solid& solid = drawing_.subdivision().solid();
    Chain chain = chains_[solid.edge(h)->index];
    if (solid.plus(*solid.edge(h)) != h) std::reverse(chain.begin(), chain.end());
    return chain;
}

/// A region that is mapped of itself, not because it asks for it, is meshed freely where the map turns cells inside out.
void RegionMesher::mesh(std::size_t outline)
{
    const MeshSettings& settings = settings_[outline];
    const RegionId region = outlines_[outline].region;
    const auto start = std::chrono::steady_clock::now();
    const auto& sides = divisions_.mapped()[outline];
    std::string method = method_of(outline);
    bool is_mapped = sides.has_value();
    if (is_mapped) {
        const std::vector<Cell> cells = cells_of_map(*sides, settings);
        is_mapped = settings.is_map() || are_well_shaped(cells);
        if (is_mapped) add_mapped(cells, settings, region);
        else method = settings.is_triangle() ? "delaunay" : "quads";
    }
    if (!is_mapped) mesh_freely(outlines_[outline], settings, method);
    RegionReport& report = reports_[region.index];
    if (report.method.empty()) report.method = method;
    else if (report.method.find(method) == std::string::npos) report.method += ", " + method;
    report.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of cells of a map: by the angles at which edges meet, as their middle nodes bend them.
bool RegionMesher::are_well_shaped(const std::vector<Cell>& cells) const
{
    constexpr double least_sine = 0.1; // of 6 degrees
    const auto leaving = [&](CellNode from, CellNode to) {
        const auto bend = middles_.find(key_of(from, to));
        const topology::FlatVector chord = nodes_[to] - nodes_[from];
        return bend == middles_.end() ? chord : 4.0 * (nodes_[bend->second] - nodes_[from]) - chord;
    };
    return std::all_of(cells.begin(), cells.end(), [&](const Cell& cell) {
        const auto nodes = cell.nodes();
        const std::size_t n = nodes.size();
        for (std::size_t i = 0; i < n; ++i) {
            const topology::FlatVector u = leaving(nodes[i], nodes[(i + 1) % n]),
                                       v = leaving(nodes[i], nodes[(i + n - 1) % n]);
            if (!(cross(u, v) > least_sine * length(u) * length(v))) return false;
        }
        return true;
    });
}

/// Nodes along a side, those in the middle of edges too where elements have them: so a map places all middle nodes.
RegionMesher::Chain RegionMesher::side_nodes(const OutlineLoop& side, const MeshSettings& settings)
{
    Chain nodes;
    for (const HalfEdgeId h : side) {
        const Chain chain = chain_along(h);
        for (std::size_t j = nodes.empty() ? 0 : 1; j < chain.size(); ++j) {
            if (settings.is_quadratic() && j > 0) nodes.push_back(middle_node(chain[j - 1], chain[j]));
            nodes.push_back(chain[j]);
        }
    }
    return nodes;
}

std::vector<Cell> RegionMesher::cells_of_map(const MappedOutline& outline, const MeshSettings& settings)
{
    std::vector<Chain> sides;
    for (const OutlineLoop& side : outline) sides.push_back(side_nodes(side, settings));
    if (sides.size() == 4) return cells_of_four({sides[0], sides[1], sides[2], sides[3]}, settings);
    if (settings.is_triangle()) return cells_of_three({sides[0], sides[1], sides[2]}, settings);
    std::vector<Cell> cells;
    for (const topology::MappedSides& part : topology::trilateral_parts({sides[0], sides[1], sides[2]}, nodes_)) {
        const std::vector<Cell> of_part = cells_of_four(part, settings);
        cells.insert(cells.end(), of_part.begin(), of_part.end());
    }
    return cells;
}

std::vector<Cell> RegionMesher::cells_of_four(const topology::MappedSides& sides, const MeshSettings& settings)
{
    const std::vector<Chain> rows = settings.method == "sweep" ? topology::swept_nodes(sides, nodes_)
                                                               : topology::mapped_nodes(sides, nodes_);
    return topology::quadrilaterals(settings.is_quadratic() ? set_middles(rows) : rows);
}

std::vector<Cell> RegionMesher::cells_of_three(const topology::TrilateralSides& sides, const MeshSettings& settings)
{
    const std::vector<Chain> rows = topology::trilateral_nodes(sides, nodes_);
    return topology::trilateral_triangles(settings.is_quadratic() ? set_middles(rows) : rows);
}

/// Every other node of every other row; those between become middle nodes, of diagonals too.
std::vector<RegionMesher::Chain> RegionMesher::set_middles(const std::vector<Chain>& rows)
{
    const auto set_between = [&](std::size_t j, std::size_t i, std::size_t below, std::size_t from, std::size_t above,
                                 std::size_t to) {
        if (from < rows[below].size() && to < rows[above].size())
            set_middle(rows[below][from], rows[above][to], rows[j][i]);
    };
    std::vector<Chain> corners;
    for (std::size_t j = 0; j < rows.size(); ++j) {
        if (j % 2 == 0) corners.emplace_back();
        for (std::size_t i = 0; i < rows[j].size(); ++i) {
            if (i % 2 == 0 && j % 2 == 0) corners.back().push_back(rows[j][i]);
            if (i % 2 == 1 && j % 2 == 0) set_between(j, i, j, i - 1, j, i + 1);
            if (i % 2 == 0 && j % 2 == 1) set_between(j, i, j - 1, i, j + 1, i);
            if (i % 2 == 0 || j % 2 == 0) continue;
            set_between(j, i, j - 1, i - 1, j + 1, i + 1);
            set_between(j, i, j - 1, i + 1, j + 1, i - 1);
        }
    }
    return corners;
}

void RegionMesher::add_mapped(const std::vector<Cell>& cells, const MeshSettings& settings, RegionId region)
{
    for (const Cell& cell : cut_cells(cells, settings)) add_element(cell, settings, region);
}

/// Triangles in place of quadrilaterals where these are wanted.
std::vector<Cell> RegionMesher::cut_cells(const std::vector<Cell>& cells, const MeshSettings& settings)
{
    const bool is_cut = settings.is_triangle() && !settings.is_trilateral();
    return is_cut ? topology::triangles(cells, settings.diagonal, nodes_) : cells;
}

/// Where elements have middle nodes that are not half way between the corners beside them.
template <class Number>
void RegionMesher::add_bends(const Chain& chain, const Number& number, topology::MeshDomain& domain) const
{
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        const auto found = middles_.find(key_of(chain[i], chain[i + 1]));
        if (found == middles_.end()) continue;
        const FlatPoint &a = nodes_[chain[i]], &b = nodes_[chain[i + 1]], &place = nodes_[found->second];
        constexpr double straight = 1e-9;
        if (distance(place, middle(a, b)) <= straight * distance(a, b)) continue;
        domain.bends.push_back({{number(chain[i]), number(chain[i + 1])}, place});
    }
}

/// Numbers the outline's nodes anew. \param of_domain  gets the number of each in the mesh of all regions
topology::MeshDomain RegionMesher::domain_of(const FaceOutline& outline, Chain& of_domain) const
{
    topology::MeshDomain domain;
    std::unordered_map<CellNode, CellNode> numbers;
    const auto number = [&](CellNode node) {
        const auto [found, is_new] = numbers.try_emplace(node, static_cast<CellNode>(of_domain.size()));
        if (is_new) {
            of_domain.push_back(node);
            domain.nodes.push_back(nodes_[node]);
        }
        return found->second;
    };
    for (const OutlineLoop& loop : outline.loops) {
        domain.loops.emplace_back();
        for (const HalfEdgeId h : loop) {
            const Chain chain = chain_along(h);
            for (std::size_t i = 0; i + 1 < chain.size(); ++i) domain.loops.back().push_back(number(chain[i]));
        }
    }
    for (const OutlineLoop& loop : outline.loops)
        for (const HalfEdgeId h : loop) add_bends(chain_along(h), number, domain);
    for (const EdgeId e : outline.inner_edges) {
        const Chain& chain = chains_[e.index];
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            domain.segments.push_back({number(chain[i]), number(chain[i + 1])});
    }
    for (const VertexId v : outline.inner_vertices) number(*of_vertex_[v.index]);
    return domain;
}

/// Of points of the model that stand inside and have a size of their own; 0 of other nodes.
std::vector<double> RegionMesher::sizes_of_points(const FaceOutline& outline, std::size_t n_nodes) const
{
    std::vector<double> sizes(n_nodes);
    const std::size_t first = n_nodes - outline.inner_vertices.size();
    const PlaneModel& model = drawing_.model();
    for (std::size_t i = 0; i < model.points.size(); ++i) {
        const auto vertex = drawing_.vertex(femoop::NodeId(i));
        const auto& inside = outline.inner_vertices;
        const auto found = vertex ? std::find(inside.begin(), inside.end(), *vertex) : inside.end();
        if (found != inside.end() && model.points[i].size)
            sizes[first + static_cast<std::size_t>(found - inside.begin())] = *model.points[i].size;
    }
    return sizes;
}

namespace {

std::unique_ptr<topology::Mesher> mesher_of(const std::string& method, const topology::MeshDomain& domain,
                                            const topology::MesherOptions& options)
{
    if (method == "front") return std::make_unique<topology::FrontMesher>(domain, options);
    if (method == "quadtree") return std::make_unique<topology::QuadtreeMesher>(domain, options);
    if (method == "quads") return std::make_unique<topology::QuadMesher>(domain, options);
    return std::make_unique<topology::DelaunayMesher>(domain, options);
}

} // namespace

void RegionMesher::mesh_freely(const FaceOutline& outline, const MeshSettings& settings, const std::string& method)
{
    Chain of_domain;
    const topology::MeshDomain domain = domain_of(outline, of_domain);
    topology::CellMesh mesh;
    try {
        mesh = mesher_of(method, domain, options_of(outline, settings, domain.nodes.size()))->run(is_cancelled_);
    } catch (const topology::CrossingEdges& crossing) {
        report_crossing(crossing, outline, of_domain);
        return;
    }
    if (method == "delaunay") report_angle(mesh, settings, outline.region);
    for (std::size_t i = of_domain.size(); i < mesh.nodes.size(); ++i) of_domain.push_back(add_node(mesh.nodes[i]));
    for (const Cell& cell : mesh.cells) add_element(renumbered(cell, of_domain), settings, outline.region);
}

topology::MesherOptions RegionMesher::options_of(const FaceOutline& outline, const MeshSettings& settings,
                                                 std::size_t n_nodes) const
{
    if (settings.field) return {.size = settings.size, .min_angle = settings.min_angle, .field = settings.field};
    return {.size = settings.size, .min_angle = settings.min_angle, .sizes = sizes_of_points(outline, n_nodes)};
}

OutlineMesher RegionMesher::outline_mesher(std::size_t outline)
{
    MeshSettings settings = settings_[outline];
    settings.element = settings.is_triangle() ? femoop::ShapeKind::T3 : femoop::ShapeKind::Q4;
    OutlineMesher made{.method = method_of(outline), .region = outlines_[outline].region, .domain = {}, .mesher = {}};
    if (const auto& sides = divisions_.mapped()[outline]) {
        const std::size_t n_before = nodes_.size();
        const auto middles = middles_;
        const bool is_mapped = settings.is_map() || are_well_shaped(cells_of_map(*sides, settings_[outline]));
        nodes_.resize(n_before);
        middles_ = middles;
        const std::vector<Cell> cells = cells_of_map(*sides, settings);
        auto rows = rows_of(*sides, settings, cut_cells(cells, settings));
        if (is_mapped) made.mesher = std::make_unique<topology::RowMesher>(nodes_, std::move(rows));
        nodes_.resize(n_before);
        if (is_mapped) return made;
        made.method = settings.is_triangle() ? "delaunay" : "quads";
    }
    Chain of_domain;
    made.domain = std::make_unique<topology::MeshDomain>(domain_of(outlines_[outline], of_domain));
    made.mesher = mesher_of(made.method, *made.domain,
                            options_of(outlines_[outline], settings, made.domain->nodes.size()));
    return made;
}

/// Cells of a map as they were laid: along the first side, and row by row away from it.
std::vector<std::vector<Cell>> RegionMesher::rows_of(const MappedOutline& sides, const MeshSettings& settings,
                                                     const std::vector<Cell>& cells) const
{
    const auto n_parts = [&](const OutlineLoop& side) {
        std::size_t n = 0;
        for (const HalfEdgeId h : side) n += chain_along(h).size() - 1;
        return n;
    };
    const std::size_t n = n_parts(sides[0]);
    if (sides.size() == 4) {
        const std::size_t n_in_row = cells.size() / n_parts(sides[1]);
        return topology::in_rows(cells, [&](std::size_t) { return n_in_row; });
    }
    if (!settings.is_triangle()) return topology::in_rows(cells, [&](std::size_t) { return n / 2; });
    return topology::in_rows(cells, [&](std::size_t row) { return 2 * (n - row) - 1; });
}

void RegionMesher::report_angle(const topology::CellMesh& mesh, const MeshSettings& settings, RegionId region)
{
    constexpr double margin = 0.05; // degrees, not worth a word
    double smallest = 180.0;
    FlatPoint at;
    for (const Cell& cell : mesh.cells) {
        const FlatPoint &a = mesh.nodes[cell.nodes()[0]], &b = mesh.nodes[cell.nodes()[1]],
                        &c = mesh.nodes[cell.nodes()[2]];
        const double angle = smallest_angle_of(a, b, c);
        if (angle >= smallest) continue;
        smallest = angle;
        at = middle(a, middle(b, c));
    }
    if (smallest >= settings.min_angle - margin) return;
    warnings_.push_back(
        {FaultKind::MeshAngleMissed,
         {entry(region), rounded(smallest), rounded(settings.min_angle), place_text(drawing_.model(), at)}});
}

/// The curve that a chord of the outline belongs to.
std::string RegionMesher::curve_through(const FaceOutline& outline, const topology::CellEdge& edge) const
{
    const topology::PlanarSubdivision& plane = drawing_.subdivision();
    const auto holds = [&](EdgeId e) {
        const Chain& chain = chains_[e.index];
        const auto has = [&](CellNode node) { return std::find(chain.begin(), chain.end(), node) != chain.end(); };
        return has(edge[0]) && has(edge[1]);
    };
    std::vector<EdgeId> edges = outline.inner_edges;
    for (const OutlineLoop& loop : outline.loops)
        for (const HalfEdgeId h : loop) edges.push_back(*plane.solid().edge(h));
    for (const EdgeId e : edges)
        if (holds(e)) return "\"" + drawing_.model()[drawing_.owner(plane.part(e).curve)].id + "\"";
    return place_text(drawing_.model(), nodes_[edge[0]]);
}

void RegionMesher::report_crossing(const topology::CrossingEdges& crossing, const FaceOutline& outline,
                                   const Chain& of_domain)
{
    const auto name = [&](const topology::CellEdge& edge) {
        return curve_through(outline, {of_domain[edge[0]], of_domain[edge[1]]});
    };
    errors_.push_back(
        {FaultKind::MeshEdgesCross, {entry(outline.region), name(crossing.edges[0]), name(crossing.edges[1])}});
}

CellNode RegionMesher::middle_node(CellNode a, CellNode b)
{
    const auto known = middles_.find(key_of(a, b));
    if (known != middles_.end()) return known->second;
    const CellNode made = add_node(middle(nodes_[a], nodes_[b]));
    set_middle(a, b, made);
    return made;
}

void RegionMesher::set_middle(CellNode a, CellNode b, CellNode node) { middles_.try_emplace(key_of(a, b), node); }

/// Where the natural centre of a Q8 with these nodes lies.
CellNode RegionMesher::centre_node(const std::vector<CellNode>& nodes)
{
    topology::FlatVector at;
    const FlatPoint& origin = nodes_[nodes[0]];
    for (std::size_t i = 0; i < 8; ++i) at = at + (i < 4 ? -0.25 : 0.5) * (nodes_[nodes[i]] - origin);
    return add_node(origin + at);
}

void RegionMesher::add_element(const Cell& cell, const MeshSettings& settings, RegionId region)
{
    const auto corners = cell.nodes();
    MeshedElement element{.nodes = {corners.begin(), corners.end()}, .kind = kind_of(cell, settings), .region = region};
    if (settings.is_quadratic())
        for (std::size_t i = 0; i < corners.size(); ++i)
            element.nodes.push_back(middle_node(corners[i], corners[(i + 1) % corners.size()]));
    if (element.kind == femoop::ShapeKind::Q9) element.nodes.push_back(centre_node(element.nodes));
    elements_.push_back(std::move(element));
}

} // namespace discretize
