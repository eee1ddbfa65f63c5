#pragma once

#include "ui/paint/geometry.h"
#include "ui/paint/image.h"
#include "ui/paint/style.h"

#include <span>
#include <string_view>
#include <vector>

namespace ui {

enum class PathEnds { Open, Closed };

/// Part of a circle, from angle `start` on through `sweep` (positive counter-clockwise as seen) [rad].
struct Arc {
    Point center;
    double radius = 0.0;
    double start = 0.0;
    double sweep = 0.0;

    Point at(double angle) const { return {center.x + radius * std::cos(angle), center.y - radius * std::sin(angle)}; }
};

/// A stretch of a line: its points, how it is drawn, and where in the dash pattern it begins [logical pixel].
struct Path {
    std::span<const Point> points;
    PathEnds ends = PathEnds::Open;
    double dash_offset = 0.0;
};

/// Where an image of pixels lies, turned, stretched or mirrored as one likes.
struct ImagePlace {
    Point corner;         ///< of its first pixel, at the top left of the image itself
    Point right;          ///< along the whole of its top side
    Point down;           ///< along the whole of its left side
    double opacity = 1.0; ///< 0 to 1
};

/// What a picture can be drawn on. Implementations get shapes in their final order, finite, clipped to the
/// neighbourhood of the sheet, in logical pixels with y down.
class Surface {
public:
    virtual ~Surface() = default;

    virtual void begin_layer(Layer) {}     ///< what follows belongs to this layer
    virtual void clip(const Box& box) = 0; ///< replaces the clip that was in force
    virtual void stroke(const Path& path, const Stroke& stroke) = 0;
    virtual void fill(std::span<const Point> polygon, Color color) = 0;
    /// The first loop without the others, which lie inside it. As one polygon with slits, unless a surface knows
    /// better.
    virtual void fill_region(std::span<const std::vector<Point>> loops, Color color);
    virtual void stroke_arc(const Arc& arc, const Stroke& stroke) = 0;
    virtual void fill_disc(Point center, double radius, Color color) = 0;
    virtual void image(const Photo&, const ImagePlace&) {} ///< left out by one that looks for lines or words alone
    virtual void text(Point at, std::string_view utf8, const TextStyle& style) = 0;
};

} // namespace ui
