#pragma once

#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/sketch/sketch.h"

#include <numbers>
#include <optional>
#include <vector>

namespace drawing {

/// Which end of a straight arrow touches the place that it acts on.
enum class ArrowAt : std::uint8_t { Head, Tail };

/// A filled triangular head whose tip is at `tip`, pointing along `direction`.
void arrow_head(Sketch& sketch, ui::Point tip, ui::Point direction, double length, ui::Color color);
/// A straight arrow. Seen end on it becomes a dot in a circle (towards the eye) or a cross in a circle (away from it);
/// `facing` is the cosine between its direction and that to the eye.
struct Arrow {
    ui::Point tail;
    ui::Point head;
    ui::Role role = ui::Role::Load;
    double head_size = 9.0; ///< in symbol pixels
    double facing = 0.0;
    int n_heads = 1;                    ///< 2 for a moment shown as a vector
    std::optional<ui::Stroke> stroke{}; ///< the role's when absent
};
void draw(Sketch& sketch, const Arrow& arrow);

/// A moment as a curved arrow about the frame's origin, counter-clockwise in the frame when `sense` > 0.
struct CurvedArrow {
    SymbolFrame frame;
    double radius = 15.0;
    double sense = 1.0;
    ui::Role role = ui::Role::LoadMoment;
    double start = -0.75 * std::numbers::pi; ///< angle of the tail of a counter-clockwise one; mirrored else
    double sweep = 1.5 * std::numbers::pi;
    ui::DashPattern dash{};
};
void draw(Sketch& sketch, const CurvedArrow& arrow);
/// All that a hand takes for it: a band along its line, from the tail to the tip of its head.
std::vector<ui::Point> area_of(const Sketch& sketch, const CurvedArrow& arrow);

/// Points of an arc in a frame, which on the sheet may be part of an ellipse.
std::vector<ui::Point> arc_in(const SymbolFrame& frame, double radius, double start, double sweep);

/// Ground: a line from (-half, 0) to (half, 0) of the frame with short strokes below it.
void draw_ground(Sketch& sketch, const SymbolFrame& frame, double half);
/// A zigzag spring along the frame's x from 0 to `length`.
void draw_zigzag(Sketch& sketch, const SymbolFrame& frame, double length, double half_width);
/// A spiral spring about the frame's origin, ending at `radius` on the frame's x axis.
void draw_spiral(Sketch& sketch, const SymbolFrame& frame, double radius);

} // namespace drawing
