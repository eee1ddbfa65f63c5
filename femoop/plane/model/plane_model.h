#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/material/stress_state.h"
#include "femoop/model/load.h"
#include "femoop/model/node.h"
#include "femoop/model/property.h"
#include "femoop/model/quantity/units.h"
#include "femoop/plane/model/drawn_curve.h"
#include "femoop/plane/model/plane_expected.h"
#include "femoop/plane/model/plane_load.h"
#include "femoop/shape/shape.h"

namespace femoop::plane {

/// How a support was written: by a keyword, or as the object form.
enum class PlaneSupportKind : std::uint8_t {
    Custom,
    Fixed,   ///< ux uy
    Pin,     ///< the same
    Roller,  ///< uy
    Symmetry ///< square to the curve
};

/// What holds a point, or every node of a curve. Directions are those of the support's own axes.
struct PlaneSupport {
    PlaneSupportKind kind = PlaneSupportKind::Custom;
    DofSet fixed;                ///< of a Custom support; for a keyword see blocked()
    Quantity angle;              ///< [degrees], its axes turned counter-clockwise
    bool is_local = false;       ///< on a curve: ux along it, uy to its left, at each node
    std::vector<Spring> springs; ///< on a point [force/length], on a curve [force/length^3]

    DofSet blocked() const;
    bool has_curve_axes() const { return is_local || kind == PlaneSupportKind::Symmetry; }
    friend bool operator==(const PlaneSupport&, const PlaneSupport&) = default;
};

/// A point of the file: a node of the mesh, or a place of the drawing.
struct PlanePoint {
    std::string id;
    std::array<Quantity, 2> at;
    std::optional<PlaneSupport> support;
    std::optional<Quantity> size; ///< of elements near it, where a mesh is to be made

    friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// Where elements lie along a curve that was drawn further than there is material: runs of its points, each with the
/// length at which it begins, and the length of the whole, which fields along the curve are given by.
struct CurveReach {
    struct Run {
        std::size_t first = 0; ///< of the curve's points
        double start = 0.0;
        friend bool operator==(const Run&, const Run&) = default;
    };
    std::vector<Run> runs; ///< one after the other; no edge leads from one to the next
    double length = 0.0;

    friend bool operator==(const CurveReach&, const CurveReach&) = default;
};

/// A curve: of a mesh, edges of elements one after the other, corner by corner; of a drawing, what it is drawn by.
struct PlaneCurve {
    std::string id;
    std::vector<NodeId> points;        ///< of a mesh, in its direction; middle nodes may be left out
    std::optional<DrawnShape> shape{}; ///< of a drawing
    std::optional<PlaneSupport> support;
    DofSet tie;                        ///< all its nodes have one displacement
    std::optional<CurveReach> reach{}; ///< of a mesh that was made of a drawing, where it is not all along the curve

    friend bool operator==(const PlaneCurve&, const PlaneCurve&) = default;
};

/// How an element's stiffness is made of its shape.
enum class Formulation : std::uint8_t { Standard, Reduced, BBar, Incompatible };

/// How a mesh is made. Of a mesh in the file only the formulation matters; the rest is kept.
struct MeshOptions {
    std::string method; ///< empty when absent, as the texts below
    std::optional<ShapeKind> element;
    std::optional<Formulation> formulation;
    std::optional<Quantity> size;
    std::optional<Quantity> min_angle; ///< [degrees]
    std::string diagonal;
    std::vector<NodeId> corners; ///< of a mapped region

    friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

/// A part of the body with one material and thickness.
struct PlaneRegion {
    std::string id;
    MaterialId material;                       ///< of no entry where it is a hole
    std::vector<std::array<Quantity, 2>> at{}; ///< of a drawing: a place in each of its faces; none: all the rest
    bool is_listed = false;                    ///< its places were a list
    bool is_hole = false;                      ///< of a drawing: it is left empty
    std::optional<Quantity> thickness;
    MeshOptions mesh; ///< over the model's, key by key

    friend bool operator==(const PlaneRegion&, const PlaneRegion&) = default;
};

struct PlaneElement {
    std::string id;
    ShapeKind kind = ShapeKind::T3;
    std::vector<NodeId> points; ///< corners counter-clockwise, then middle nodes, then the centre
    RegionId region;

    friend bool operator==(const PlaneElement&, const PlaneElement&) = default;
};

inline constexpr std::size_t most_elements = 5'000'000; ///< of a mesh

/// A plate, a slice of a long body or a body of revolution with its mesh, or with the drawing that a mesh is to be made
/// of, its loads and what is expected of it: a plain value, as `Model` is for members. `check`
/// (femoop/plane/check/plane_check.h) says what is wrong with it, `analyse` (femoop/plane/analysis/plane_analysis.h)
/// solves it.
///
/// Signs  x right, y up, tension positive. Axisymmetric: x is the radius, y the axis
/// Units  every Quantity is in `units`
struct PlaneModel {
    std::string title;
    std::string notes;
    bool is_drawn = false; ///< it has curves and faces, and no elements yet
    StressState analysis = StressState::PlaneStress;
    Units units;
    std::optional<Quantity> snap;
    MeshOptions mesh;
    std::vector<Material> materials;
    std::vector<PlanePoint> points;
    std::vector<PlaneCurve> curves;
    std::vector<PlaneRegion> regions;
    std::vector<PlaneElement> elements;
    std::vector<PlaneLoadCase> load_cases;
    std::vector<Combination> combinations;
    std::vector<PlaneExpected> expected;

    const PlanePoint& operator[](NodeId id) const { return points[id.index]; }
    const PlaneCurve& operator[](CurveId id) const { return curves[id.index]; }
    const PlaneRegion& operator[](RegionId id) const { return regions[id.index]; }
    const PlaneElement& operator[](ElementId id) const { return elements[id.index]; }
    const Material& operator[](MaterialId id) const { return materials[id.index]; }

    std::size_t n_cases() const { return load_cases.size() + combinations.size(); }
    const std::string& case_name(CaseId id) const; ///< load cases first, then combinations
    std::optional<CaseId> find_case(std::string_view id) const;

    Formulation formulation(RegionId region) const; ///< the region's own, else the model's, else standard
    double thickness(RegionId region) const;        ///< 1 where there is none

    friend bool operator==(const PlaneModel&, const PlaneModel&) = default;
};

std::string_view name(StressState analysis);    ///< "plane_stress"
std::string_view name(Formulation formulation); ///< "b_bar"

/// Which shapes have a formulation, in which analyses.
bool has_formulation(ShapeKind shape, Formulation formulation, StressState analysis);

} // namespace femoop::plane
