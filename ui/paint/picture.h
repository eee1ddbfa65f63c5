#pragma once

#include "ui/paint/geometry.h"
#include "ui/paint/style.h"
#include "ui/paint/surface.h"
#include "ui/paint/text_measure.h"

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace ui {

/// What a painter recorded: shapes by layer, a plain value that can be drawn on any surface, any number of times.
class Picture {
public:
    explicit Picture(Size size) : size_(size) {}

    Size size() const { return size_; }
    /// Layer by layer, in each the order of the calls. Lines that leave the sheet far behind are cut first, so a
    /// surface never meets a million dashes out of sight.
    void draw_on(Surface& surface) const;

    /// Of all strings, in the order of the calls.
    std::vector<Box> text_boxes(const Fonts& fonts) const;

    std::size_t n_shapes() const { return shapes_.size(); }
    /// Shapes that were left out because a number in them is not finite or out of its range.
    std::size_t n_refused() const { return n_refused_; }

private:
    friend class Painter;

    struct Range {
        std::size_t begin;
        std::size_t count;
    };
    struct Line {
        Range points;
        PathEnds ends;
        Stroke stroke;
    };
    struct Polygon {
        Range points;
        Color fill;
    };
    struct Region {
        std::vector<Range> loops;
        Color fill;
    };
    struct ArcLine {
        Arc arc;
        Stroke stroke;
    };
    struct Disc {
        Point center;
        double radius;
        Color fill;
    };
    struct PlacedPhoto {
        std::shared_ptr<const Photo> photo;
        ImagePlace place;
    };
    struct Text {
        Point at;
        Range bytes;
        TextStyle style;
    };
    struct Shape {
        Layer layer;
        std::size_t clip;
        std::variant<Line, Polygon, Region, ArcLine, Disc, PlacedPhoto, Text> what;
    };

    Range store(std::span<const Point> points);
    std::span<const Point> points(Range range) const { return {points_.data() + range.begin, range.count}; }
    std::string_view words(const Text& text) const
    {
        return std::string_view(bytes_).substr(text.bytes.begin, text.bytes.count);
    }
    void draw(const Shape& shape, Surface& surface) const;

    Size size_;
    std::vector<Shape> shapes_;
    std::vector<Point> points_;
    std::string bytes_;
    std::vector<Box> clips_;
    std::size_t n_refused_ = 0;
};

} // namespace ui
