#pragma once

#include <optional>
#include <vector>

#include "apps/mohr/document/solution.h"
#include "apps/mohr/view/look.h"
#include "ui/canvas/orbit_camera.h"
#include "ui/canvas/plane_camera.h"
#include "ui/paint/painter.h"

namespace mohr {

/// What can be dragged.
enum class Handle : std::uint8_t {
    FaceX,      ///< the circle's point of the face x
    FaceY,      ///< of the face y
    Plane,      ///< of the plane that is looked at
    Centre,     ///< of the circle
    First,      ///< its point of the largest value
    Second,     ///< of the least value; in space of the middle one
    Third,      ///< in space, of the least one
    ArrowX,     ///< the element's arrow along x', at the tip
    ArrowY,     ///< along y'
    ArrowShear, ///< along the face x'
    Turn,       ///< the end of the axis x'
    Cursor,     ///< on the curves
    Fibre,      ///< of the section, on the distribution over its depth
    Normal,     ///< of the plane in space, on the sphere
    CubeX,      ///< the cube's arrow of the normal stress on the face x, at the tip
    CubeY,      ///< likewise
    CubeZ,      ///< likewise
    CubeXY,     ///< of the shear along y on the face x
    CubeYZ,     ///< along z on the face y
    CubeZX      ///< along x on the face z
};

/// A handle and where it is on the sheet.
struct Place {
    Handle handle;
    ui::Point at;
};

/// The scales of a picture: kept while a hand drags, so that the picture rests under it.
struct Frame {
    double low = -1.0, high = 1.0; ///< normal components of the circle's diagram
    double reach = 1.0;            ///< shear up to there, on both sides
    double largest = 1.0;          ///< the component of the longest arrow

    friend bool operator==(const Frame&, const Frame&) = default;
};
/// What a frame must hold: everything, or the circles of the state without that at failure and those of a path.
enum class Content : std::uint8_t { All, Circles };
Frame fitting_frame(const Document& document, const Solution& solution, Content content = Content::All);

/// What a picture is drawn of.
struct Scene {
    const Document& document;
    const Solution& solution;
    const Look& look;
    Frame frame;
    ui::OrbitCamera eye{};                    ///< of the pictures in space
    std::optional<std::size_t> steps_shown{}; ///< of the construction, from 1; absent: the whole circle
    std::optional<Handle> hover{};            ///< lies under the pointer, or is dragged
    bool conceals = false; ///< an exercise: only what is given, and the construction as far as it is answered
};

/// The element: its middle, half its side and how long an arrow of the largest component is [px].
struct ElementMap {
    ui::Point middle;
    double half = 0.0, arrow = 0.0;
};
/// The curves: where -90 and +90 degrees lie.
struct CurvesMap {
    double left = 0.0, right = 0.0;
};
/// The section: heights of its axis, y' up. [mm]
struct SectionMap {
    double middle = 0.0, scale = 1.0; ///< where y' = 0 lies, and pixels of a mm
};
struct SphereMap {
    ui::Point middle;
    double radius = 0.0;
    ui::OrbitCamera eye{};
};

/// An arrow of the cube: its component, and where its tip goes as that grows by 1.
struct CubeArrow {
    Handle handle;
    double value = 0.0;
    ui::Point tip, growth;
};

/// What a picture is made of, for the hand: where the handles are and what a place of the sheet means.
struct Drawn {
    std::vector<Place> places;
    ui::PlaneCamera circle; ///< normal to the right, shear up the sheet
    ElementMap element;
    CurvesMap curves;
    SectionMap section;
    SphereMap sphere;
    std::vector<CubeArrow> cube;
};

/// Draws everything; the sheet is the painter's.
Drawn draw(ui::Painter& painter, const Scene& scene);

/// The handle at a point of the sheet.
std::optional<Handle> pick(const Drawn& drawn, ui::Point at, double reach);

} // namespace mohr
