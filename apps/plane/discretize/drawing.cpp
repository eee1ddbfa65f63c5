#include "apps/plane/discretize/drawing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "apps/plane/discretize/drawing_check.h"
#include "apps/plane/discretize/entry_name.h"
#include "femoop/model/quantity/number_text.h"

namespace discretize {

namespace {

using femoop::Fault;
using femoop::FaultKind;
using femoop::NodeId;
using femoop::plane::CurveId;
using femoop::plane::DrawnKind;
using femoop::plane::PlaneExpected;
using femoop::plane::PlaneQuantity;
using topology::FlatBox;
using topology::FlatPoint;

constexpr double usual_snap = 1e-9;   // of the diagonal of the drawing's box
constexpr double finest_snap = 1e-14; // of its largest coordinate
constexpr double least_snap = 1e-15;  // that may be given, of the same

double largest_coordinate(const FlatBox& box)
{
    return std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
}

/// Whether a curve only uses a place to find its shape: a control point of Bezier's.
bool is_control(const femoop::plane::DrawnShape& shape, std::size_t i)
{
    return shape.kind == DrawnKind::Bezier && i % 3 != 0;
}

} // namespace

Drawing::Drawing(const PlaneModel& model) : model_(model), subdivision_(1.0), vertices_(model.points.size())
{
    const std::vector<Drawn> drawn = draw_curves();
    if (!faults_.empty()) return;
    insert(drawn);
    if (!faults_.empty()) return;
    list_faces();
    if (!faults_.empty()) return;
    FaceRegions regions = regions_of_faces(*this);
    for (std::size_t i = 0; i < faces_.size(); ++i) faces_[i].region = regions.of_face[i];
    faults_ = std::move(regions.faults);
    std::ranges::move(faults_of(*this), std::back_inserter(faults_));
}

bool Drawing::is_sound() const { return std::ranges::none_of(faults_, femoop::is_error); }

/// A point stands as a vertex unless it is merely a centre or a control point.
std::vector<bool> Drawing::standing_points() const
{
    std::vector<bool> is_helper(model_.points.size()), stands(model_.points.size());
    for (const auto& curve : model_.curves) {
        if (!curve.shape) continue;
        if (curve.shape->center && curve.shape->center->point) is_helper[curve.shape->center->point->index] = true;
        for (std::size_t i = 0; i < curve.shape->places.size(); ++i)
            if (const auto point = curve.shape->places[i].point)
                (is_control(*curve.shape, i) ? is_helper : stands)[point->index] = true;
    }
    for (const auto& load_case : model_.load_cases)
        for (const auto& load : load_case.points) stands[load.node.index] = true;
    for (std::size_t i = 0; i < stands.size(); ++i)
        if (!is_helper[i] || model_.points[i].support) stands[i] = true;
    return stands;
}

std::vector<Drawing::Drawn> Drawing::draw_curves()
{
    const auto draw = [&](double snap, std::vector<Fault>& faults) {
        std::vector<Drawn> drawn;
        for (std::size_t i = 0; i < model_.curves.size(); ++i) {
            const auto& curve = model_.curves[i];
            if (!curve.shape) continue;
            ShapeCurves made = curves_of(model_, *curve.shape, entry_of("curves", model_.curves, i), snap);
            std::ranges::move(made.faults, std::back_inserter(faults));
            drawn.push_back({CurveId(i), std::move(made.parts)});
        }
        return drawn;
    };
    std::vector<Fault> of_no_tolerance; // which is a share of the drawing's size
    const double snap = snap_of(draw(0.0, of_no_tolerance));
    std::vector<Drawn> drawn = draw(snap, faults_);
    subdivision_ = topology::PlanarSubdivision(snap);
    require_right_of_axis(drawn);
    return drawn;
}

/// Curves may bulge over the axis of revolution between places that do not.
void Drawing::require_right_of_axis(const std::vector<Drawn>& drawn)
{
    if (model_.analysis != femoop::StressState::Axisymmetric) return;
    for (const auto& [curve, parts] : drawn)
        for (const ShapePart& part : parts)
            if (const double x = part.curve.box({}).low.x; x < -subdivision_.snap()) {
                faults_.push_back(
                    {FaultKind::PointLeftOfAxis, {entry_of("curves", model_.curves, curve.index), length_text(x)}});
                break;
            }
}

std::string Drawing::length_text(double length) const
{
    return femoop::number_text(length) + " " + std::string(femoop::name(model_.units.length));
}

/// Around everything that is drawn, and the places of curves that could not be.
FlatBox Drawing::box_around(const std::vector<Drawn>& drawn) const
{
    FlatBox box;
    for (const auto& [curve, parts] : drawn) {
        for (const ShapePart& part : parts) {
            const FlatBox of_part = part.curve.box({});
            for (const FlatPoint& p : {of_part.low, of_part.high, part.ends[0], part.ends[1]}) box.add(p);
        }
        if (parts.empty())
            for (const auto& at : model_[curve].shape->places) box.add(place_of(model_, at));
    }
    for (const auto& point : model_.points) box.add({point.at[0], point.at[1]});
    return box;
}

double Drawing::snap_of(const std::vector<Drawn>& drawn)
{
    const FlatBox box = box_around(drawn);
    if (box.is_empty()) return 1.0;
    const double largest = largest_coordinate(box);
    if (!model_.snap) return std::max({usual_snap * box.diagonal(), finest_snap * largest, least_snap});
    const double given = *model_.snap;
    if (given >= least_snap * largest && given > 0.0) return given;
    faults_.push_back({FaultKind::SnapTooSmall, {length_text(given), length_text(least_snap * largest)}});
    return std::max(least_snap * largest, std::numeric_limits<double>::min());
}

void Drawing::insert(const std::vector<Drawn>& drawn)
{
    const std::vector<bool> stands = standing_points();
    for (std::size_t i = 0; i < stands.size(); ++i)
        if (stands[i]) vertices_[i] = subdivision_.insert({model_.points[i].at[0], model_.points[i].at[1]});
    for (const auto& [curve, parts] : drawn)
        for (const ShapePart& part : parts) {
            const auto refusal = subdivision_.insert(part.curve, part.ends);
            if (!refusal) {
                owners_.push_back(curve);
                ends_.push_back(part.ends);
                continue;
            }
            const std::string place = entry_of("curves", model_.curves, curve.index);
            if (refusal->runs_along)
                faults_.push_back({FaultKind::CurvesRunTogether, {place, model_[owners_[*refusal->runs_along]].id}});
            else faults_.push_back({FaultKind::CurveTooNear, {place}});
            break;
        }
}

void Drawing::list_faces()
{
    const double sliver = subdivision_.snap() * subdivision_.snap();
    const topology::Solid& solid = subdivision_.solid();
    for (const topology::FaceId f : solid.faces()) {
        if (f == subdivision_.unbounded()) continue;
        if (subdivision_.area(f) < -sliver) { // no number of such a drawing is shown
            faces_.clear();
            faults_ = {{FaultKind::CurveTooNear, {"curves"}}};
            return;
        }
        faces_.push_back({.id = f,
                          .area = subdivision_.area(f),
                          .perimeter = subdivision_.perimeter(f),
                          .n_holes = subdivision_.n_holes(f),
                          .inside = subdivision_.place_inside(f),
                          .region = {}});
    }
    std::ranges::stable_sort(faces_, [](const DrawnFace& a, const DrawnFace& b) { // from left to right where equal
        const bool are_equal = std::abs(a.area - b.area) <= 1e-9 * std::max(a.area, b.area);
        if (!are_equal) return a.area > b.area;
        return std::pair(a.inside.x, a.inside.y) < std::pair(b.inside.x, b.inside.y);
    });
    index_of_face_.resize(solid.faces().n_rows());
    for (std::size_t i = 0; i < faces_.size(); ++i) index_of_face_[faces_[i].id.index] = i;
}

std::optional<std::size_t> Drawing::face_at(const FlatPoint& at) const
{
    if (subdivision_.solid().is_empty() || subdivision_.edge_at(at)) return std::nullopt;
    return index_of_face_[subdivision_.face_at(at).index];
}

std::optional<double> Drawing::read(const PlaneExpected& check) const
{
    if (check.quantity == PlaneQuantity::Area) return area(check);
    if (check.quantity == PlaneQuantity::Count) return count(check);
    return std::nullopt;
}

std::optional<std::size_t> Drawing::face_of(const PlaneExpected& check) const
{
    if (check.rank) {
        const auto rank = static_cast<std::size_t>(*check.rank);
        return rank <= faces_.size() ? std::optional(rank - 1) : std::nullopt;
    }
    if (!check.at.empty()) return face_at({check.at[0], check.at[1]});
    if (check.point) return face_at({model_[*check.point].at[0], model_[*check.point].at[1]});
    return std::nullopt;
}

std::optional<double> Drawing::area(const PlaneExpected& check) const
{
    if (!check.region) {
        const auto face = face_of(check);
        return face ? std::optional(faces_[*face].area) : std::nullopt;
    }
    double sum = 0.0;
    for (const DrawnFace& face : faces_)
        if (face.region == check.region) sum += face.area;
    return sum;
}

double Drawing::count(const PlaneExpected& check) const
{
    const topology::PlanarCounts counts = subdivision_.counts();
    const std::string& what = check.counted;
    if (what == "vertices") return static_cast<double>(counts.vertices);
    if (what == "edges") return static_cast<double>(counts.edges);
    if (what == "regions") return static_cast<double>(counts.regions);
    if (what == "components") return static_cast<double>(counts.components);
    if (what == "dangling") return static_cast<double>(counts.dangling);
    if (check.region) {
        std::size_t sum = 0;
        for (const DrawnFace& face : faces_)
            if (face.region == check.region) sum += face.n_holes;
        return static_cast<double>(sum);
    }
    const auto face = face_of(check);
    return face ? static_cast<double>(faces_[*face].n_holes) : 0.0;
}

} // namespace discretize
