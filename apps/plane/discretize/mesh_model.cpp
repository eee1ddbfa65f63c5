#include "apps/plane/discretize/mesh_model.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "apps/plane/discretize/entry_name.h"

namespace discretize {

namespace {

using femoop::FaultKind;
using femoop::NodeId;
using femoop::plane::CurveId;
using femoop::plane::PlaneCurve;
using femoop::plane::PlanePoint;
using femoop::plane::RegionId;
using topology::CellNode;
using topology::EdgeId;

/// A beginning of names that no point's name has followed by a digit.
std::string free_prefix(const PlaneModel& model)
{
    std::string prefix = "n";
    const auto is_taken = [&] {
        return std::any_of(model.points.begin(), model.points.end(), [&](const PlanePoint& point) {
            return point.id.size() > prefix.size() && point.id.starts_with(prefix) &&
                   point.id.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
        });
    };
    while (is_taken()) prefix += "n";
    return prefix;
}

bool is_of_drawing(const femoop::plane::PlaneExpected& check)
{
    using femoop::plane::PlaneQuantity;
    return check.quantity == PlaneQuantity::Count || check.quantity == PlaneQuantity::Area;
}

} // namespace

MeshModelMaker::MeshModelMaker(const Drawing& drawing, const std::vector<FaceOutline>& outlines, const RegionMesh& mesh)
    : drawing_(drawing),
      drawn_(drawing.model()),
      outlines_(outlines),
      mesh_(mesh),
      is_used_(mesh.nodes.size()),
      number_of_(mesh.nodes.size()),
      node_of_point_(drawn_.points.size()),
      curve_of_(drawn_.curves.size()),
      region_of_(drawn_.regions.size())
{
    for (const MeshedElement& element : mesh.elements)
        for (const CellNode node : element.nodes) is_used_[node] = true;
}

PlaneModel MeshModelMaker::model()
{
    PlaneModel model;
    model.title = drawn_.title;
    model.notes = drawn_.notes;
    model.analysis = drawn_.analysis;
    model.units = drawn_.units;
    model.mesh.formulation = drawn_.mesh.formulation;
    model.materials = drawn_.materials;
    model.combinations = drawn_.combinations;
    add_points(model);
    add_regions(model);
    add_elements(model);
    add_curves(model);
    add_load_cases(model);
    for (const auto& check : drawn_.expected)
        if (!is_of_drawing(check)) model.expected.push_back(meshed(check));
    return model;
}

/// Points of the drawing first; of those that are one place, the first.
void MeshModelMaker::add_points(PlaneModel& model)
{
    std::vector<std::size_t> point_of(mesh_.nodes.size());
    for (std::size_t i = 0; i < drawn_.points.size(); ++i) {
        const auto vertex = drawing_.vertex(NodeId(i));
        const auto at = vertex ? mesh_.of_vertex[vertex->index] : std::nullopt;
        if (!at || !is_used_[*at]) continue;
        if (!number_of_[*at]) {
            number_of_[*at] = NodeId(model.points.size());
            point_of[*at] = i;
            model.points.push_back(drawn_.points[i]);
            model.points.back().size.reset();
        } else if (drawn_.points[i].support) {
            auto& known = model.points[number_of_[*at]->index].support;
            if (known)
                errors_.push_back(
                    {FaultKind::PointsAtOnePlace,
                     {entry_of("points", drawn_.points, i), entry_of("points", drawn_.points, point_of[*at])}});
            else known = drawn_.points[i].support;
        }
        node_of_point_[i] = number_of_[*at];
    }
    n_points_ = model.points.size();
    const std::string prefix = free_prefix(drawn_);
    for (std::size_t i = 0; i < number_of_.size(); ++i) {
        if (!is_used_[i] || number_of_[i]) continue;
        number_of_[i] = NodeId(model.points.size());
        const auto& [x, y] = mesh_.nodes[i];
        model.points.push_back({.id = prefix + std::to_string(model.points.size() - n_points_ + 1), .at = {x, y}});
    }
}

void MeshModelMaker::add_regions(PlaneModel& model)
{
    for (std::size_t i = 0; i < drawn_.regions.size(); ++i) {
        if (drawn_.regions[i].is_hole) continue;
        region_of_[i] = RegionId(model.regions.size());
        auto& region = model.regions.emplace_back(drawn_.regions[i]);
        region.at.clear();
        region.is_listed = false;
        region.mesh = {};
        region.mesh.formulation = drawn_.regions[i].mesh.formulation;
    }
}

void MeshModelMaker::add_elements(PlaneModel& model) const
{
    model.elements.reserve(mesh_.elements.size());
    for (const MeshedElement& meshed : mesh_.elements) {
        auto& element = model.elements.emplace_back();
        element.id = std::to_string(model.elements.size());
        element.kind = meshed.kind;
        element.region = *region_of_[meshed.region.index];
        element.points.reserve(meshed.nodes.size());
        for (const CellNode each : meshed.nodes) element.points.push_back(node(each));
    }
}

std::vector<CellNode> MeshModelMaker::chain_along(const CurvePiece& piece) const
{
    std::vector<CellNode> chain = mesh_.chains[piece.edge.index];
    if (!piece.is_forward) std::reverse(chain.begin(), chain.end());
    return chain;
}

/// Each curve as far as elements have edges along it, in runs.
void MeshModelMaker::add_curves(PlaneModel& model)
{
    const topology::Solid& solid = drawing_.subdivision().solid();
    std::set<EdgeId> meshed_edges;
    for (const FaceOutline& outline : outlines_) {
        for (const OutlineLoop& loop : outline.loops)
            for (const topology::HalfEdgeId h : loop) meshed_edges.insert(*solid.edge(h));
        meshed_edges.insert(outline.inner_edges.begin(), outline.inner_edges.end());
    }
    const auto pieces = pieces_of_curves(drawing_);
    for (std::size_t c = 0; c < pieces.size(); ++c) {
        PlaneCurve curve = drawn_.curves[c];
        curve.shape.reset();
        femoop::plane::CurveReach reach;
        std::optional<CellNode> end;
        bool is_whole = true;
        for (const CurvePiece& piece : pieces[c]) {
            if (meshed_edges.contains(piece.edge)) {
                const std::vector<CellNode> chain = chain_along(piece);
                const bool goes_on = end == chain.front();
                if (!goes_on) reach.runs.push_back({.first = curve.points.size(), .start = reach.length});
                for (std::size_t i = goes_on ? 1 : 0; i < chain.size(); ++i) curve.points.push_back(node(chain[i]));
                end = chain.back();
            } else {
                is_whole = false;
                end.reset();
            }
            reach.length += piece.length;
        }
        if (curve.points.empty()) continue;
        if (!is_whole || reach.runs.size() > 1) curve.reach = std::move(reach);
        curve_of_[c] = CurveId(model.curves.size());
        model.curves.push_back(std::move(curve));
    }
}

std::vector<CurveId> MeshModelMaker::meshed(const std::vector<CurveId>& curves) const
{
    std::vector<CurveId> found;
    for (const CurveId curve : curves)
        if (curve_of_[curve.index]) found.push_back(*curve_of_[curve.index]);
    return found;
}

/// Nothing of a load on holes alone.
std::optional<femoop::plane::RegionLoad> MeshModelMaker::meshed(const femoop::plane::RegionLoad& load) const
{
    femoop::plane::RegionLoad made = load;
    made.regions.clear();
    for (const RegionId region : load.regions)
        if (region_of_[region.index]) made.regions.push_back(*region_of_[region.index]);
    if (made.regions.empty() && !load.regions.empty()) return std::nullopt;
    return made;
}

void MeshModelMaker::add_load_cases(PlaneModel& model) const
{
    for (const auto& drawn : drawn_.load_cases) {
        auto& made = model.load_cases.emplace_back();
        made.id = drawn.id;
        made.self_weight = drawn.self_weight;
        for (auto load : drawn.points) {
            load.node = *node_of_point_[load.node.index];
            made.points.push_back(std::move(load));
        }
        for (auto load : drawn.curves) {
            load.curves = meshed(load.curves);
            if (!load.curves.empty()) made.curves.push_back(std::move(load));
        }
        for (const auto& load : drawn.regions)
            if (auto on_regions = meshed(load)) made.regions.push_back(std::move(*on_regions));
        for (auto settlement : drawn.settlements) {
            if (settlement.point) settlement.point = node_of_point_[settlement.point->index];
            settlement.curves = meshed(settlement.curves);
            if (settlement.point || !settlement.curves.empty()) made.settlements.push_back(std::move(settlement));
        }
    }
}

/// A point that is no node is a place.
femoop::plane::PlaneExpected MeshModelMaker::meshed(const femoop::plane::PlaneExpected& drawn) const
{
    femoop::plane::PlaneExpected check = drawn;
    if (is_of_drawing(drawn)) return check;
    if (check.point && !node_of_point_[check.point->index]) {
        const auto& [x, y] = drawn_[*check.point].at;
        check.at = {x, y};
        check.point.reset();
    } else if (check.point) check.point = node_of_point_[check.point->index];
    if (check.curve) check.curve = curve_of_[check.curve->index];
    if (check.region) check.region = region_of_[check.region->index];
    return check;
}

std::vector<femoop::plane::PlaneExpected> MeshModelMaker::checks() const
{
    std::vector<femoop::plane::PlaneExpected> all;
    for (const auto& check : drawn_.expected) all.push_back(meshed(check));
    return all;
}

} // namespace discretize
