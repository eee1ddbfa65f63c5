#include "femoop/plane/check/plane_checker.h"

#include <algorithm>
#include <sstream>

#include "femoop/element/continuum/element_geometry.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/model/quantity/dof_dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/solver/at_once.h"

namespace femoop::plane {

namespace {

constexpr DofSet plane_displacements{Dof::ux, Dof::uy};
constexpr double locking_ratio = 0.49;                  // Poisson's
constexpr std::size_t elements_checked_at_once = 10000; // that a thread checks

constexpr Dimension foundation_dimension{.length = -3, .force = 1};

std::string natural_text(NaturalPoint at)
{
    std::ostringstream text;
    text << "xi = " << at.xi << ", eta = " << at.eta;
    return text.str();
}

} // namespace

RegionsOfPoints::RegionsOfPoints(const PlaneModel& model) : first_(model.points.size(), none)
{
    for (const PlaneElement& element : model.elements) {
        if (element.region.index >= model.regions.size()) continue;
        for (const NodeId point : element.points) {
            if (point.index >= first_.size() || first_[point.index] == element.region.index) continue;
            if (first_[point.index] == none) {
                first_[point.index] = element.region.index;
                continue;
            }
            std::vector<RegionId>& others = others_[point];
            if (std::ranges::find(others, element.region) == others.end()) others.push_back(element.region);
        }
    }
}

std::vector<RegionId> RegionsOfPoints::of(NodeId point) const
{
    std::vector<RegionId> all;
    if (is_empty(point)) return all;
    all.emplace_back(first_[point.index]);
    if (const auto others = others_.find(point); others != others_.end())
        all.insert(all.end(), others->second.begin(), others->second.end());
    return all;
}

PlaneChecker::PlaneChecker(const PlaneModel& model, const Unreadable& unreadable)
    : EntryChecker(model.units), model_(model), unreadable_(unreadable), geometry_checks_(model.analysis)
{
    together([&] { edges_.emplace(model_); }, [&] { regions_of_point_.emplace(model_); });
}

/// Two works on a mesh, at once where that pays.
template <class First, class Second> void PlaneChecker::together(const First& first, const Second& second) const
{
    if (model_.elements.size() >= elements_checked_at_once) return at_once(first, second);
    first();
    second();
}

bool PlaneChecker::has_errors() const { return std::ranges::any_of(faults_, is_error); }

std::vector<Fault> PlaneChecker::run()
{
    if (unreadable_.header) return {};
    if (model_.elements.size() > most_elements)
        return {{FaultKind::TooManyElements, {std::to_string(model_.elements.size()), std::to_string(most_elements)}}};
    check_ids();
    check_materials();
    check_points();
    check_regions();
    if (model_.is_drawn) {
        check_drawn_regions();
        check_drawn_curves();
    } else {
        check_elements();
        check_curves();
    }
    const bool is_mesh_sound = !model_.is_drawn && !has_errors() && !unreadable_.is_incomplete;
    if (is_mesh_sound) {
        curves_.emplace(model_, *edges_);
        supports_.emplace(model_, *curves_);
        check_ties();
    }
    check_load_cases();
    check_combinations(model_, unreadable_.combinations);
    check_expected();
    is_partial_ = false;
    if (!unreadable_.is_incomplete && !model_.elements.empty()) check_use();
    warn_of_locking();
    return std::move(faults_);
}

void PlaneChecker::check_ids()
{
    bool are_points_flawless = false, are_elements_flawless = false;
    together([&] { are_points_flawless = have_flawless_names(model_.points); },
             [&] { are_elements_flawless = have_flawless_names(model_.elements); });
    check_names("materials", model_.materials, unreadable_.materials);
    if (!are_points_flawless) check_names("points", model_.points, unreadable_.points);
    check_names("curves", model_.curves, unreadable_.curves);
    check_names("regions", model_.regions, unreadable_.regions);
    if (!are_elements_flawless) check_names("elements", model_.elements, unreadable_.elements);
    std::vector<Entry> cases; // load cases and combinations share one set of names
    collect_names(cases, "load_cases", model_.load_cases, unreadable_.load_cases);
    collect_names(cases, "combinations", model_.combinations, unreadable_.combinations);
    check_names(cases);
}

void PlaneChecker::check_materials()
{
    for (std::size_t i = 0; i < model_.materials.size(); ++i) {
        const Material& material = model_.materials[i];
        const Entry place{"materials", i, material.id};
        is_partial_ = !is_readable(MaterialId(i));
        check_material(material, place);
        if (material.G) add(FaultKind::ShearModulusInPlane, place, {});
        if (model_.analysis != StressState::PlaneStress && material.poisson() == 0.5)
            add(FaultKind::IncompressibleInPlane, place, {shown(*material.nu, dimension::none), analysis()});
    }
}

void PlaneChecker::check_points()
{
    for (std::size_t i = 0; i < model_.points.size(); ++i) {
        const PlanePoint& point = model_.points[i];
        const Entry place{"points", i, point.id};
        is_partial_ = flag(unreadable_.points, i);
        require_within_reach(place, "x", point.at[0]);
        require_within_reach(place, "y", point.at[1]);
        if (point.size) require_positive(place, "size", *point.size, dimension::length);
        if (model_.analysis == StressState::Axisymmetric && point.at[0] < 0.0)
            add(FaultKind::PointLeftOfAxis, place, {shown(point.at[0], dimension::length)});
        if (!point.support) continue;
        check_support(*point.support, false, place);
        if (has_no_elements(NodeId(i))) add(FaultKind::PointWithoutElements, place, {point.id});
    }
}

void PlaneChecker::check_support(const PlaneSupport& support, bool is_on_curve, const Entry& place)
{
    if (support.has_curve_axes() && !is_on_curve)
        add(FaultKind::CurveAxesOfPoint, place, {support.is_local ? "axes" : "symmetry"});
    require_finite(place, "angle", support.angle);
    const auto require_known = [&](Dof dof, FaultKind lacking) {
        if (!plane_displacements.contains(dof))
            add(lacking, place, {std::string(name(dof)), analysis(), names_of(plane_displacements)});
    };
    for (const Dof dof : all_dofs)
        if (support.fixed.contains(dof)) require_known(dof, FaultKind::FixedDofLacking);
    for (const Spring& spring : support.springs) {
        const std::string dof(name(spring.dof));
        require_known(spring.dof, FaultKind::SpringDofLacking);
        if (support.blocked().contains(spring.dof)) add(FaultKind::SpringOnFixedDof, place, {dof});
        require_stiffness(place, "spring " + dof, spring.stiffness,
                          is_on_curve ? foundation_dimension : dimension::force_per_length);
    }
}

void PlaneChecker::check_mesh_options(const MeshOptions& mesh, const Entry& place)
{
    constexpr double largest_min_angle = 33.0; // degrees; what Delaunay refinement reaches in practice
    constexpr std::size_t n_corners = 4, of_trilateral = 3;
    if (mesh.size) require_positive(place, "size", *mesh.size, dimension::length);
    if (mesh.min_angle && !(*mesh.min_angle > 0.0 && *mesh.min_angle <= largest_min_angle))
        add(FaultKind::MinAngleRange, place, {shown(*mesh.min_angle, dimension::none)});
    const std::size_t n = mesh.corners.size();
    if (n != 0 && n != n_corners && n != of_trilateral && !is_partial_)
        add(FaultKind::CornerCount, place, {std::to_string(n)});
    for (const NodeId corner : mesh.corners) require_entry(place, "points", corner.index, model_.points.size());
}

void PlaneChecker::check_regions()
{
    is_partial_ = unreadable_.is_incomplete;
    check_mesh_options(model_.mesh, {"mesh", {}, {}});
    for (std::size_t i = 0; i < model_.regions.size(); ++i) {
        const PlaneRegion& region = model_.regions[i];
        const Entry place{"regions", i, region.id};
        is_partial_ = flag(unreadable_.regions, i);
        check_mesh_options(region.mesh, place);
        if (region.is_hole) continue;
        require_entry(place, "materials", region.material.index, model_.materials.size());
        if (region.thickness) require_positive(place, "thickness", *region.thickness, dimension::length);
        if (region.thickness && model_.analysis == StressState::Axisymmetric)
            add(FaultKind::ThicknessOfRevolution, place, {});
        if (!region.thickness && !is_partial_ && model_.analysis == StressState::PlaneStress)
            add(FaultKind::RegionWithoutThickness, place, {});
        const std::optional<ShapeKind> asked = region.mesh.element ? region.mesh.element : model_.mesh.element;
        if (model_.is_drawn && asked) require_formulation(*asked, RegionId(i));
    }
}

void PlaneChecker::require_formulation(ShapeKind kind, RegionId region)
{
    const Formulation formulation = model_.formulation(region);
    if (!has_formulation(kind, formulation, model_.analysis))
        add(FaultKind::FormulationLacking, {"regions", region.index, model_[region].id},
            {std::string(name(formulation)), std::string(femoop::name(kind)), analysis()});
}

bool PlaneChecker::is_flawless(const PlaneElement& element) const
{
    if (element.region.index >= model_.regions.size() || !has_points(model_, element)) return false;
    if (!has_formulation(element.kind, model_.formulation(element.region), model_.analysis)) return false;
    const NodePositions X = positions_of(model_, element);
    return X.allFinite() && !geometry_checks_.known(element.kind).fault(X);
}

std::vector<std::uint8_t> PlaneChecker::flawless_elements()
{
    for (const ShapeKind kind : shape_kinds())
        if (!shape_of(kind).edges().empty()) geometry_checks_.of(kind);
    std::vector<std::uint8_t> all(model_.elements.size());
    in_ranges(all.size(), elements_checked_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            all[i] = !flag(unreadable_.elements, i) && is_flawless(model_.elements[i]) ? 1 : 0;
    });
    return all;
}

void PlaneChecker::check_elements()
{
    if (model_.elements.empty() && !unreadable_.is_incomplete) faults_.push_back({FaultKind::NoElements, {}});
    std::vector<std::uint8_t> asked(model_.regions.size()); // a bit for each kind of element whose formulation was
    const std::vector<std::uint8_t> are_flawless = flawless_elements();
    for (std::size_t i = 0; i < model_.elements.size(); ++i) {
        if (are_flawless[i] != 0) continue;
        const PlaneElement& element = model_.elements[i];
        is_partial_ = flag(unreadable_.elements, i);
        check_element(element, {"elements", i, element.id});
        if (element.region.index >= model_.regions.size()) continue;
        const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(element.kind));
        std::uint8_t& of_region = asked[element.region.index];
        if ((of_region & bit) != 0) continue;
        of_region = static_cast<std::uint8_t>(of_region | bit);
        require_formulation(element.kind, element.region);
    }
}

void PlaneChecker::check_element(const PlaneElement& element, const Entry& place)
{
    for (const NodeId point : element.points) require_entry(place, "points", point.index, model_.points.size());
    require_entry(place, "regions", element.region.index, model_.regions.size());
    const Shape& shape = shape_of(element.kind);
    if (!is_partial_ && element.points.size() != static_cast<std::size_t>(shape.n_nodes()))
        add(FaultKind::ElementPointCount, place,
            {std::to_string(element.points.size()), std::to_string(shape.n_nodes()),
             std::string(femoop::name(element.kind))});
    if (is_partial_ || !has_points(model_, element)) return;
    const NodePositions X = positions_of(model_, element);
    if (!X.allFinite()) return;
    const auto fault = geometry_checks_.of(element.kind).fault(X);
    if (!fault) return;
    switch (fault->flaw) {
    case GeometryFlaw::NoArea: add(FaultKind::ElementNoArea, place, {}); break;
    case GeometryFlaw::Clockwise: add(FaultKind::ElementClockwise, place, {}); break;
    default:
        add(FaultKind::ElementDistorted, place,
            {number_text(fault->value), fault->node ? model_[element.points[static_cast<std::size_t>(*fault->node)]].id
                                                    : natural_text(fault->at)});
    }
}

void PlaneChecker::check_curves()
{
    for (std::size_t i = 0; i < model_.curves.size(); ++i) {
        const PlaneCurve& curve = model_.curves[i];
        const Entry place{"curves", i, curve.id};
        is_partial_ = flag(unreadable_.curves, i);
        for (const NodeId point : curve.points) require_entry(place, "points", point.index, model_.points.size());
        if (curve.support) check_support(*curve.support, true, place);
        check_tied(curve, place);
        if (is_partial_ || unreadable_.is_incomplete) continue;
        if (curve.points.size() < 2) add(FaultKind::CurveTooShort, place, {std::to_string(curve.points.size())});
        if (const auto gap = edges_along(model_, *edges_, curve).gap)
            add(FaultKind::CurveWithoutEdge, place, {model_[curve.points[*gap]].id, model_[curve.points[*gap + 1]].id});
    }
}

void PlaneChecker::check_tied(const PlaneCurve& curve, const Entry& place)
{
    for (const Dof dof : all_dofs)
        if (curve.tie.contains(dof) && !plane_displacements.contains(dof))
            add(FaultKind::FixedDofLacking, place, {std::string(name(dof)), analysis(), names_of(plane_displacements)});
}

void PlaneChecker::check_ties()
{
    is_partial_ = false;
    for (std::size_t i = 0; i < model_.curves.size(); ++i) {
        if (model_.curves[i].tie.is_empty()) continue;
        for (const CurveNode& node : curves_->geometry[i].nodes())
            if ((*supports_)[node.node].angle() != 0.0) {
                add(FaultKind::TieOfTurnedNode, {"curves", i, model_.curves[i].id}, {model_[node.node].id});
                break;
            }
    }
}

void PlaneChecker::check_use()
{
    std::vector<bool> has_elements(model_.regions.size());
    for (const PlaneElement& element : model_.elements)
        if (element.region.index < has_elements.size()) has_elements[element.region.index] = true;
    for (std::size_t i = 0; i < model_.points.size(); ++i)
        if (regions_of_point_->is_empty(NodeId(i)) && !model_.points[i].support)
            add(FaultKind::LonePoint, {"points", i, model_.points[i].id}, {});
    for (std::size_t i = 0; i < model_.regions.size(); ++i)
        if (!has_elements[i]) add(FaultKind::RegionWithoutElements, {"regions", i, model_.regions[i].id}, {});
}

void PlaneChecker::warn_of_locking()
{
    if (model_.analysis == StressState::PlaneStress) return;
    std::vector<bool> locks(model_.regions.size());
    for (const PlaneElement& element : model_.elements)
        if (element.region.index < locks.size() && element.kind != ShapeKind::Q9)
            locks[element.region.index] = model_.formulation(element.region) == Formulation::Standard;
    for (std::size_t i = 0; i < model_.regions.size(); ++i) {
        const MaterialId material = model_.regions[i].material;
        if (!locks[i] || !is_readable(material)) continue;
        const double nu = model_[material].poisson();
        if (nu <= locking_ratio || nu >= 0.5) continue;
        add(FaultKind::NearlyIncompressible, {"regions", i, model_.regions[i].id},
            {shown(*model_[material].nu, dimension::none)});
    }
}

std::vector<Fault> check(const PlaneModel& model, const Unreadable& unreadable)
{
    return PlaneChecker(model, unreadable).run();
}

void require_sound(const PlaneModel& model)
{
    std::vector<Fault> errors = errors_among(check(model));
    if (!errors.empty()) throw ModelError(std::move(errors));
}

} // namespace femoop::plane
