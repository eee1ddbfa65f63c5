#include "apps/plane/document/attributes.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "apps/plane/document/load_cases.h"

namespace plane {

using femoop::Dof;
using femoop::DofSet;
using femoop::Quantity;
using femoop::plane::CurveLoad;
using femoop::plane::CurveLoadKind;
using femoop::plane::Field;
using femoop::plane::RegionLoad;

namespace {

void set_kind(std::optional<PlaneSupport>& support, std::optional<PlaneSupportKind> kind)
{
    if (!kind) return support.reset();
    PlaneSupport made{.kind = *kind, .fixed = {}, .angle = {}, .springs = {}};
    if (*kind == PlaneSupportKind::Custom && support) {
        made.fixed = support->blocked();
        made.is_local = support->has_curve_axes();
        if (support->kind == PlaneSupportKind::Custom) made = *support;
    }
    if (*kind == PlaneSupportKind::Custom && !support) made.fixed = DofSet{Dof::ux};
    support = made;
}

} // namespace

void set_support(Document& document, NodeId point, std::optional<PlaneSupportKind> kind)
{
    set_kind(document.model.points.at(point.index).support, kind);
}

void set_support(Document& document, CurveId curve, std::optional<PlaneSupportKind> kind)
{
    set_kind(document.model.curves.at(curve.index).support, kind);
}

void set_hold(PlaneSupport& support, Dof dof, Hold hold)
{
    if (hold == Hold::Free) {
        support.fixed.erase(dof);
        return;
    }
    support.fixed.insert(dof);
    std::erase_if(support.springs, [dof](const femoop::Spring& spring) { return spring.dof == dof; });
}

void set_spring(PlaneSupport& support, Dof dof, const std::optional<Quantity>& stiffness)
{
    std::erase_if(support.springs, [dof](const femoop::Spring& spring) { return spring.dof == dof; });
    if (!stiffness) return;
    support.fixed.erase(dof);
    support.springs.push_back({dof, *stiffness});
    std::ranges::sort(support.springs, {}, &femoop::Spring::dof);
}

void set_division(Document& document, CurveId curve, const std::optional<femoop::plane::Division>& division)
{
    auto& shape = document.model.curves.at(curve.index).shape.value();
    shape.divide.clear();
    shape.is_divided_by_piece = false;
    if (division) shape.divide.push_back(*division);
}

void mesh_by(Document& document, femoop::ShapeKind kind)
{
    const auto change = [&](femoop::plane::MeshOptions& mesh) {
        const bool makes_triangles = mesh.method == "delaunay" || mesh.method == "front" || mesh.method == "quadtree";
        if (is_triangle(kind) ? mesh.method == "quads" : makes_triangles) mesh.method.clear();
        mesh.element.reset();
        mesh.formulation.reset();
    };
    change(document.model.mesh);
    document.model.mesh.element = kind;
    for (auto& region : document.model.regions) change(region.mesh);
}

namespace {

double three_digits(double value)
{
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return step * std::round(value / step);
}

/// A method of its own in place of none, or of the app's choice.
void mesh_freely(femoop::plane::MeshOptions& mesh, const femoop::plane::MeshOptions& usual)
{
    const std::string& method = mesh.method.empty() ? usual.method : mesh.method;
    if (!method.empty() && method != "auto") return;
    const femoop::ShapeKind kind = mesh.element.value_or(usual.element.value_or(femoop::ShapeKind::T6));
    mesh.method = is_triangle(kind) ? "delaunay" : "quads";
}

} // namespace

void keep_sizes(Document& document, const topology::SizeField& sizes)
{
    PlaneModel& model = document.model;
    for (auto& point : model.points) point.size = three_digits(sizes.at({point.at[0], point.at[1]}));
    for (auto& curve : model.curves)
        if (curve.shape) curve.shape->divide.clear();
    model.mesh.size = three_digits(sizes.greatest());
    for (auto& region : model.regions) {
        region.mesh.size.reset();
        if (!region.is_hole) mesh_freely(region.mesh, model.mesh);
    }
}

std::size_t some_case(Document& document, std::size_t load_case)
{
    if (document.model.load_cases.empty()) add_load_case(document);
    return std::min(load_case, document.model.load_cases.size() - 1);
}

namespace {

/// Those of a list that have a part among theirs.
template <class Loads, class Has> std::vector<std::size_t> places_where(const Loads& loads, Has has)
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < loads.size(); ++i)
        if (has(loads[i])) places.push_back(i);
    return places;
}

template <class Id> bool is_among(const std::vector<Id>& ids, Id id) { return std::ranges::find(ids, id) != ids.end(); }

/// What several parts have becomes that of one of them, and behind it in the list that of the others.
template <class Load, class Id>
Load& parted(std::vector<Load>& loads, std::size_t load, std::vector<Id> Load::*parts, Id part)
{
    Load& there = loads.at(load);
    if ((there.*parts).size() < 2) return there;
    Load others = there;
    std::erase(others.*parts, part);
    there.*parts = {part};
    loads.insert(loads.begin() + static_cast<std::ptrdiff_t>(load) + 1, std::move(others));
    return loads[load];
}

std::vector<RegionId> regions_of_material(const PlaneModel& model)
{
    std::vector<RegionId> all;
    for (std::size_t i = 0; i < model.regions.size(); ++i)
        if (!model.regions[i].is_hole) all.emplace_back(i);
    return all;
}

} // namespace

std::vector<std::size_t> loads_on(const PlaneModel& model, std::size_t load_case, CurveId curve)
{
    if (load_case >= model.load_cases.size()) return {};
    return places_where(model.load_cases[load_case].curves,
                        [curve](const CurveLoad& load) { return is_among(load.curves, curve); });
}

std::vector<std::size_t> loads_on(const PlaneModel& model, std::size_t load_case, RegionId region)
{
    if (load_case >= model.load_cases.size()) return {};
    return places_where(model.load_cases[load_case].regions, [region](const RegionLoad& load) {
        return load.regions.empty() || is_among(load.regions, region);
    });
}

namespace {

std::size_t kind_of(const CurveLoad& load) { return static_cast<std::size_t>(load.kind); }
std::size_t kind_of(const RegionLoad& load) { return load.load.index(); }

/// The kinds of the loads on a part, one after the other.
template <class Id> std::vector<std::size_t> kinds_on(const PlaneModel& model, std::size_t load_case, Id part)
{
    std::vector<std::size_t> kinds;
    for (std::size_t nth = 0; nth < loads_on(model, load_case, part).size(); ++nth)
        kinds.push_back(kind_of(load_on(model, load_case, nth, part)));
    return kinds;
}

/// The first load of a kind on each part is one load that all have, so is the second.
template <class Id>
std::vector<LoadPlaces> common_loads(const PlaneModel& model, std::size_t load_case, const std::vector<Id>& parts)
{
    std::vector<LoadPlaces> all;
    if (parts.empty()) return all;
    const std::vector<std::size_t> of_first = kinds_on(model, load_case, parts.front());
    for (std::size_t i = 0; i < of_first.size(); ++i) {
        const auto n_before = std::count(of_first.begin(), of_first.begin() + static_cast<std::ptrdiff_t>(i),
                                         of_first[i]);
        LoadPlaces places;
        for (const Id part : parts) {
            const std::vector<std::size_t> kinds = kinds_on(model, load_case, part);
            auto n_to_pass = n_before;
            const auto it = std::ranges::find_if(
                kinds, [&](std::size_t kind) { return kind == of_first[i] && n_to_pass-- == 0; });
            if (it != kinds.end()) places.push_back(static_cast<std::size_t>(it - kinds.begin()));
        }
        if (places.size() == parts.size()) all.push_back(std::move(places));
    }
    return all;
}

} // namespace

std::vector<LoadPlaces> loads_of_all(const PlaneModel& model, std::size_t load_case, const std::vector<CurveId>& curves)
{
    return common_loads(model, load_case, curves);
}

std::vector<LoadPlaces> loads_of_all(const PlaneModel& model, std::size_t load_case,
                                     const std::vector<RegionId>& regions)
{
    return common_loads(model, load_case, regions);
}

std::size_t add_load(Document& document, std::size_t load_case, const std::vector<CurveId>& curves, CurveLoadKind kind)
{
    CurveLoad load{.curves = curves, .kind = kind, .qx = {}, .qy = {}, .value = {}};
    if (kind == CurveLoadKind::Pressure) load.value = Field{Quantity(0.0)};
    else load.qx = load.qy = Field{Quantity(0.0)};
    auto& loads = document.model.load_cases[some_case(document, load_case)].curves;
    loads.push_back(std::move(load));
    return loads.size() - 1;
}

std::size_t add_load(Document& document, std::size_t load_case, const std::vector<RegionId>& regions,
                     RegionLoadKind kind)
{
    const Field nothing{Quantity(0.0)};
    RegionLoad load{.regions = regions, .load = femoop::plane::BodyForce{.bx = nothing, .by = nothing}};
    if (kind == RegionLoadKind::Temperature) load.load = femoop::plane::TemperatureRise{.rise = nothing};
    if (kind == RegionLoadKind::Rotation)
        load.load = femoop::plane::SteadyRotation{.omega = Quantity(0.0), .about = {}};
    auto& loads = document.model.load_cases[some_case(document, load_case)].regions;
    loads.push_back(std::move(load));
    return loads.size() - 1;
}

const CurveLoad& load_on(const PlaneModel& model, std::size_t load_case, std::size_t nth, CurveId curve)
{
    return model.load_cases[load_case].curves[loads_on(model, load_case, curve).at(nth)];
}

const RegionLoad& load_on(const PlaneModel& model, std::size_t load_case, std::size_t nth, RegionId region)
{
    return model.load_cases[load_case].regions[loads_on(model, load_case, region).at(nth)];
}

CurveLoad& own_load(Document& document, std::size_t load_case, std::size_t nth, CurveId curve)
{
    return parted(document.model.load_cases.at(load_case).curves, loads_on(document.model, load_case, curve).at(nth),
                  &CurveLoad::curves, curve);
}

RegionLoad& own_load(Document& document, std::size_t load_case, std::size_t nth, RegionId region)
{
    auto& loads = document.model.load_cases.at(load_case).regions;
    const std::size_t load = loads_on(document.model, load_case, region).at(nth);
    const std::vector<RegionId> all = regions_of_material(document.model);
    if (loads[load].regions.empty() && all.size() > 1) loads[load].regions = all;
    return parted(loads, load, &RegionLoad::regions, region);
}

void erase_load(Document& document, std::size_t load_case, std::size_t nth, CurveId curve)
{
    auto& loads = document.model.load_cases.at(load_case).curves;
    loads.erase(loads.begin() + (&own_load(document, load_case, nth, curve) - loads.data()));
}

void erase_load(Document& document, std::size_t load_case, std::size_t nth, RegionId region)
{
    auto& loads = document.model.load_cases.at(load_case).regions;
    loads.erase(loads.begin() + (&own_load(document, load_case, nth, region) - loads.data()));
}

namespace {

using femoop::plane::PlaneSettlement;

bool moves(const PlaneSettlement& settlement, NodeId point) { return settlement.point == point; }
bool moves(const PlaneSettlement& settlement, CurveId curve) { return is_among(settlement.curves, curve); }

auto along(Dof dof) { return dof == Dof::ux ? &PlaneSettlement::ux : &PlaneSettlement::uy; }

template <class Id> std::optional<Field> settlement_at(const PlaneModel& model, std::size_t load_case, Id part, Dof dof)
{
    if (load_case >= model.load_cases.size()) return std::nullopt;
    for (const PlaneSettlement& settlement : model.load_cases[load_case].settlements)
        if (moves(settlement, part) && settlement.*along(dof)) return settlement.*along(dof);
    return std::nullopt;
}

/// Where the part's settlement in a direction stands, else one of its own to which it can be given.
template <class Id> std::size_t place_of_settlement(std::vector<PlaneSettlement>& all, Id part, Dof dof)
{
    const auto is_it = [&](const PlaneSettlement& one) { return moves(one, part) && one.*along(dof); };
    const auto is_own = [&](const PlaneSettlement& one) { return moves(one, part) && one.curves.size() < 2; };
    auto found = std::ranges::find_if(all, is_it);
    if (found == all.end()) found = std::ranges::find_if(all, is_own);
    if (found == all.end()) {
        PlaneSettlement made;
        if constexpr (std::is_same_v<Id, NodeId>) made.point = part;
        else made.curves = {part};
        found = all.insert(all.end(), std::move(made));
    }
    return static_cast<std::size_t>(found - all.begin());
}

template <class Id>
void edit_settlement(Document& document, std::size_t load_case, Id part, Dof dof, const FieldEdit& edit)
{
    auto& all = document.model.load_cases[some_case(document, load_case)].settlements;
    const std::size_t place = place_of_settlement(all, part, dof);
    if constexpr (std::is_same_v<Id, CurveId>) parted(all, place, &PlaneSettlement::curves, part);
    edit(all[place].*along(dof));
    if (!all[place].ux && !all[place].uy) all.erase(all.begin() + static_cast<std::ptrdiff_t>(place));
}

} // namespace

std::optional<Field> settlement_of(const PlaneModel& model, std::size_t load_case, NodeId point, Dof dof)
{
    return settlement_at(model, load_case, point, dof);
}

std::optional<Field> settlement_of(const PlaneModel& model, std::size_t load_case, CurveId curve, Dof dof)
{
    return settlement_at(model, load_case, curve, dof);
}

void change_settlement(Document& document, std::size_t load_case, NodeId point, Dof dof, const FieldEdit& edit)
{
    edit_settlement(document, load_case, point, dof, edit);
}

void change_settlement(Document& document, std::size_t load_case, CurveId curve, Dof dof, const FieldEdit& edit)
{
    edit_settlement(document, load_case, curve, dof, edit);
}

std::optional<Quantity> force_on(const PlaneModel& model, std::size_t load_case, NodeId point, Dof dof)
{
    if (load_case >= model.load_cases.size()) return std::nullopt;
    std::optional<Quantity> sum;
    for (const auto& load : model.load_cases[load_case].points)
        for (const femoop::Component& part : load.components)
            if (load.node == point && part.dof == dof) sum = sum ? Quantity(*sum + part.value) : part.value;
    return sum;
}

void set_force(Document& document, std::size_t load_case, NodeId point, Dof dof, const std::optional<Quantity>& force)
{
    auto& loads = document.model.load_cases[some_case(document, load_case)].points;
    for (auto& load : loads)
        if (load.node == point)
            std::erase_if(load.components, [dof](const femoop::Component& part) { return part.dof == dof; });
    if (force) {
        auto load = std::ranges::find(loads, point, &femoop::NodeLoad::node);
        if (load == loads.end()) load = loads.insert(loads.end(), {point, {}});
        load->components.push_back({dof, *force});
        std::ranges::sort(load->components, {}, &femoop::Component::dof);
    }
    std::erase_if(loads, [](const auto& load) { return load.components.empty(); });
}

} // namespace plane
