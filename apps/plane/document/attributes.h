#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"

namespace plane {

using femoop::plane::PlaneSupport;
using femoop::plane::PlaneSupportKind;

/// Nothing: free. A keyword loses angle, axes and springs; one that becomes Custom keeps what it blocks.
void set_support(Document& document, NodeId point, std::optional<PlaneSupportKind> kind);
void set_support(Document& document, CurveId curve, std::optional<PlaneSupportKind> kind);

/// Of a support of the object form.
enum class Hold : bool { Free, Blocked };
void set_hold(PlaneSupport& support, femoop::Dof dof, Hold hold);
/// Nothing: no spring there. A spring takes the place of a block.
void set_spring(PlaneSupport& support, femoop::Dof dof, const std::optional<femoop::Quantity>& stiffness);

/// How every piece of a curve is divided; nothing: by the size of the mesh.
void set_division(Document& document, CurveId curve, const std::optional<femoop::plane::Division>& division);

/// All regions are meshed by this kind of element, in its standard formulation. A method that does not make it is left to
/// the app; what is mapped stays so.
void mesh_by(Document& document, femoop::ShapeKind kind);

/// Puts what a field of sizes wants into the drawing, as far as it can hold it: at its points, with its largest size as
/// that of the mesh, three digits each. Divisions of curves go, and what is mapped of itself is meshed freely.
void keep_sizes(Document& document, const topology::SizeField& sizes);

/// The case at this place, made where there is none yet.
std::size_t some_case(Document& document, std::size_t load_case);

enum class RegionLoadKind : std::uint8_t { Body, Temperature, Rotation }; ///< in the order of RegionLoad's forms

/// The loads of a case on a curve or a region, by their places in the case's list. One that names no region is of all.
std::vector<std::size_t> loads_on(const PlaneModel& model, std::size_t load_case, CurveId curve);
std::vector<std::size_t> loads_on(const PlaneModel& model, std::size_t load_case, RegionId region);
/// A load that all of several parts have, of one kind: for each part which one it is of those on it, from 0.
using LoadPlaces = std::vector<std::size_t>;
std::vector<LoadPlaces> loads_of_all(const PlaneModel& model, std::size_t load_case,
                                     const std::vector<CurveId>& curves);
std::vector<LoadPlaces> loads_of_all(const PlaneModel& model, std::size_t load_case,
                                     const std::vector<RegionId>& regions);
/// Adds a load of no value: of a pressure 0, of the others qx and qy 0. \returns its place in the case's list
std::size_t add_load(Document& document, std::size_t load_case, const std::vector<CurveId>& curves,
                     femoop::plane::CurveLoadKind kind);
std::size_t add_load(Document& document, std::size_t load_case, const std::vector<RegionId>& regions,
                     RegionLoadKind kind);
/// A part's load, the first of which is 0.
const femoop::plane::CurveLoad& load_on(const PlaneModel& model, std::size_t load_case, std::size_t nth, CurveId curve);
const femoop::plane::RegionLoad& load_on(const PlaneModel& model, std::size_t load_case, std::size_t nth,
                                         RegionId region);
/// That load for this part alone: one that other parts have too is parted from theirs.
femoop::plane::CurveLoad& own_load(Document& document, std::size_t load_case, std::size_t nth, CurveId curve);
femoop::plane::RegionLoad& own_load(Document& document, std::size_t load_case, std::size_t nth, RegionId region);
void erase_load(Document& document, std::size_t load_case, std::size_t nth, CurveId curve);
void erase_load(Document& document, std::size_t load_case, std::size_t nth, RegionId region);

/// How a support moves in a direction of its axes; nothing: not at all.
std::optional<femoop::plane::Field> settlement_of(const PlaneModel& model, std::size_t load_case, NodeId point,
                                                  femoop::Dof dof);
std::optional<femoop::plane::Field> settlement_of(const PlaneModel& model, std::size_t load_case, CurveId curve,
                                                  femoop::Dof dof);
using FieldEdit = std::function<void(std::optional<femoop::plane::Field>&)>;
/// Edits it for this part alone: one that other curves have too is parted from theirs.
void change_settlement(Document& document, std::size_t load_case, NodeId point, femoop::Dof dof, const FieldEdit& edit);
void change_settlement(Document& document, std::size_t load_case, CurveId curve, femoop::Dof dof,
                       const FieldEdit& edit);

/// The force on a point in a direction, the sum where a file has several; nothing takes it away.
std::optional<femoop::Quantity> force_on(const PlaneModel& model, std::size_t load_case, NodeId point, femoop::Dof dof);
void set_force(Document& document, std::size_t load_case, NodeId point, femoop::Dof dof,
               const std::optional<femoop::Quantity>& force);

} // namespace plane
