#include "apps/plane/discretize/drawing_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "apps/plane/discretize/entry_name.h"
#include "apps/plane/discretize/merged_places.h"
#include "femoop/model/quantity/number_text.h"

namespace discretize {

namespace {

using femoop::Fault;
using femoop::FaultKind;
using femoop::NodeId;
using femoop::plane::CurveId;
using femoop::plane::PlaneExpected;
using femoop::plane::PlaneQuantity;
using femoop::plane::RegionId;
using topology::EdgeId;
using topology::FlatPoint;
using topology::HalfEdgeId;

constexpr double sharp_angle = 5.0; // degrees

/// Gives the faces to the regions whose places they hold.
class RegionAssignment {
public:
    explicit RegionAssignment(const Drawing& drawing) : drawing_(drawing), model_(drawing.model())
    {
        given_.of_face.resize(drawing.faces().size());
    }

    FaceRegions run()
    {
        for (std::size_t i = 0; i < model_.regions.size(); ++i)
            for (const auto& [x, y] : model_.regions[i].at) give(RegionId(i), {x, y});
        for (std::size_t i = 0; i < model_.regions.size(); ++i)
            if (model_.regions[i].at.empty()) give_rest(RegionId(i));
        return std::move(given_);
    }

private:
    void refuse(FaultKind kind, RegionId region, std::vector<std::string> details)
    {
        details.insert(details.begin(), entry_of("regions", model_.regions, region.index));
        given_.faults.push_back({kind, std::move(details)});
    }

    void give(RegionId region, const FlatPoint& at)
    {
        const std::string where = place_text(model_, at);
        if (const auto edge = drawing_.subdivision().edge_at(at)) {
            const CurveId curve = drawing_.owner(drawing_.subdivision().part(*edge).curve);
            return refuse(FaultKind::RegionPlaceOnCurve, region, {where, model_[curve].id});
        }
        const auto face = drawing_.face_at(at);
        if (!face) return refuse(FaultKind::RegionPlaceOutside, region, {where});
        std::optional<RegionId>& taken = given_.of_face[*face];
        if (taken)
            return refuse(FaultKind::RegionPlaceTaken, region,
                          {where, entry_of("regions", model_.regions, taken->index)});
        taken = region;
    }

    void give_rest(RegionId region)
    {
        std::size_t n = 0;
        for (std::optional<RegionId>& of_face : given_.of_face) {
            if (of_face) continue;
            of_face = region;
            ++n;
        }
        if (n == 0) refuse(FaultKind::NoFaceLeft, region, {});
    }

    const Drawing& drawing_;
    const PlaneModel& model_;
    FaceRegions given_;
};

/// Looks at a drawing with its regions.
class DrawingCheck {
public:
    explicit DrawingCheck(const Drawing& drawing)
        : drawing_(drawing), model_(drawing.model()), plane_(drawing.subdivision()), edges_(model_.curves.size())
    {
        for (const DrawnFace& face : drawing.faces())
            if (face.region && !model_[*face.region].is_hole) material_.insert(face.id);
        for (const EdgeId e : plane_.solid().edges())
            for (const topology::CurvePart& part : plane_.carriers(e))
                edges_[drawing.owner(part.curve).index].push_back(e);
    }

    std::vector<Fault> run()
    {
        check_divisions();
        check_supports();
        check_loads();
        check_asked();
        warn_of_what_is_left();
        std::ranges::move(merged_places(drawing_), std::back_inserter(faults_));
        if (!model_.regions.empty()) warn_of_corners();
        return std::move(faults_);
    }

private:
    void add(FaultKind kind, std::vector<std::string> details) { faults_.push_back({kind, std::move(details)}); }
    bool is_material(HalfEdgeId h) const { return material_.contains(plane_.solid().face(h)); }
    bool touches(EdgeId e) const { return is_material(plane_.solid().plus(e)) || is_material(plane_.solid().minus(e)); }
    bool touches(CurveId curve) const
    {
        return std::ranges::any_of(edges_[curve.index], [&](EdgeId e) { return touches(e); });
    }
    bool touches(NodeId point) const
    {
        const auto vertex = drawing_.vertex(point);
        if (!vertex) return false;
        for (const HalfEdgeId h : plane_.solid().fan(*vertex))
            if (is_material(h)) return true;
        return false;
    }

    void check_divisions()
    {
        for (std::size_t i = 0; i < model_.curves.size(); ++i) {
            const auto& shape = model_.curves[i].shape;
            if (!shape || !shape->is_divided_by_piece || shape->divide.size() == edges_[i].size()) continue;
            add(FaultKind::DivisionsOfPieces, {entry_of("curves", model_.curves, i),
                                               std::to_string(shape->divide.size()), std::to_string(edges_[i].size())});
        }
    }

    void check_supports()
    {
        for (std::size_t i = 0; i < model_.points.size(); ++i)
            if (model_.points[i].support && !touches(NodeId(i)))
                add(FaultKind::TouchesNoMaterial, {entry_of("points", model_.points, i), model_.points[i].id});
        for (std::size_t i = 0; i < model_.curves.size(); ++i)
            if ((model_.curves[i].support || !model_.curves[i].tie.is_empty()) && !touches(CurveId(i)))
                add(FaultKind::TouchesNoMaterial, {entry_of("curves", model_.curves, i), model_.curves[i].id});
    }

    void check_loads()
    {
        for (std::size_t i = 0; i < model_.load_cases.size(); ++i) {
            const auto& load_case = model_.load_cases[i];
            const std::string list = femoop::Entry{"load_cases", i, {}}.text();
            for (std::size_t j = 0; j < load_case.points.size(); ++j)
                if (const NodeId point = load_case.points[j].node; !touches(point))
                    add(FaultKind::TouchesNoMaterial,
                        {femoop::Entry{list + ".points", j, {}}.text(), model_[point].id});
            for (std::size_t j = 0; j < load_case.curves.size(); ++j)
                check_load(load_case.curves[j], femoop::Entry{list + ".curves", j, {}}.text());
        }
    }

    void check_load(const femoop::plane::CurveLoad& load, const std::string& place)
    {
        const bool is_pressure = load.kind == femoop::plane::CurveLoadKind::Pressure;
        for (const CurveId curve : load.curves) {
            if (!touches(curve)) add(FaultKind::TouchesNoMaterial, {place, model_[curve].id});
            const bool is_inside = std::ranges::any_of(edges_[curve.index], [&](EdgeId e) {
                return is_material(plane_.solid().plus(e)) && is_material(plane_.solid().minus(e));
            });
            if (is_pressure && is_inside) add(FaultKind::PressureInside, {place, model_[curve].id});
        }
    }

    /// Counts and areas of faces that are not there.
    void check_asked()
    {
        for (std::size_t i = 0; i < model_.expected.size(); ++i) {
            const PlaneExpected& check = model_.expected[i];
            if (check.curve && !touches(*check.curve))
                add(FaultKind::TouchesNoMaterial, {femoop::Entry{"expected", i, {}}.text(), model_[*check.curve].id});
            const bool is_of_face = check.quantity == PlaneQuantity::Area || check.counted == "holes";
            if (!is_of_face || check.region) continue;
            const std::string place = femoop::Entry{"expected", i, {}}.text();
            const std::size_t n = drawing_.faces().size();
            if (check.rank && static_cast<std::size_t>(*check.rank) > n)
                add(FaultKind::CheckFaceRank, {place, std::to_string(*check.rank), std::to_string(n)});
            if (check.rank || (check.at.empty() && !check.point)) continue;
            const FlatPoint at = check.point ? place_of(model_, {.point = check.point, .at = {}})
                                             : FlatPoint{check.at[0], check.at[1]};
            if (!drawing_.face_at(at)) add(FaultKind::CheckFaceOutside, {place, place_text(model_, at)});
        }
    }

    void warn_of_what_is_left()
    {
        const topology::Solid& solid = plane_.solid();
        for (const DrawnFace& face : drawing_.faces())
            if (!face.region && !model_.regions.empty())
                add(FaultKind::FaceWithoutRegion,
                    {place_text(model_, face.inside),
                     rounded(face.area) + " " + std::string(femoop::name(model_.units.length)) + "^2"});
        for (std::size_t i = 0; i < model_.points.size(); ++i)
            if (const auto vertex = drawing_.vertex(NodeId(i)); vertex && !solid.edge(solid.half_edge(*vertex)))
                add(FaultKind::DrawnPointAlone, {entry_of("points", model_.points, i)});
        for (std::size_t i = 0; i < model_.curves.size(); ++i)
            if (std::ranges::any_of(edges_[i],
                                    [&](EdgeId e) { return solid.face(solid.plus(e)) == solid.face(solid.minus(e)); }))
                add(FaultKind::CurveDangles, {entry_of("curves", model_.curves, i)});
    }

    /// A place is told once, where curves touch and leave a corner on either side too.
    void warn_of_corners()
    {
        const topology::Solid& solid = plane_.solid();
        std::set<topology::VertexId> told;
        for (const topology::FaceId f : material_)
            for (const topology::LoopId l : solid.loops(f))
                for (const HalfEdgeId h : solid.chain(l)) {
                    if (!solid.edge(h)) continue;
                    const double angle = plane_.corner_angle(h) * 180.0 / std::numbers::pi;
                    if (angle < sharp_angle && told.insert(solid.start(h)).second)
                        add(FaultKind::SharpCorner, {place_text(model_, plane_.at(solid.start(h))), rounded(angle)});
                }
    }

    const Drawing& drawing_;
    const PlaneModel& model_;
    const topology::PlanarSubdivision& plane_;
    std::vector<std::vector<EdgeId>> edges_; ///< of each curve
    std::set<topology::FaceId> material_;
    std::vector<Fault> faults_;
};

} // namespace

FaceRegions regions_of_faces(const Drawing& drawing) { return RegionAssignment(drawing).run(); }
std::vector<Fault> faults_of(const Drawing& drawing) { return DrawingCheck(drawing).run(); }

} // namespace discretize
