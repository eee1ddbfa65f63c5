#pragma once

#include "ui/paint/geometry.h"
#include "ui/paint/picture.h"
#include "ui/paint/style.h"
#include "ui/paint/text_measure.h"

#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace ui {

/// What views draw with: one vocabulary for the screen, SVG, PDF, PNG and golden texts.
///
/// A painter fills a Picture, and a picture is then drawn on any Surface; so a view runs once however many surfaces
/// there are, and cannot know which.
///
/// Places and lengths are logical pixels, y DOWN. Angles are radians, positive counter-clockwise AS SEEN, zero along
/// +x: a point at angle t on a circle is (cx + r cos t, cy - r sin t).
/// A shape with a place that is not finite, a radius or width that is negative or not finite, is left out and counted
/// in `picture().n_refused()`: a view of a broken model stays a picture.
class Painter {
public:
    Painter(Size size, const Fonts& fonts);

    Size size() const { return picture_.size(); }
    Box sheet() const { return {{0.0, 0.0}, {size().width, size().height}}; }
    const Fonts& fonts() const { return *fonts_; }

    Layer layer() const { return layer_; }
    void set_layer(Layer layer) { layer_ = layer; }

    /// From now on nothing is drawn outside the box nor outside those pushed before.
    void push_clip(const Box& box);
    /// \pre a clip was pushed and is not popped yet.
    void pop_clip();

    void line(Point a, Point b, const Stroke& stroke);
    void polyline(std::span<const Point> points, const Stroke& stroke, PathEnds ends = PathEnds::Open);
    void polyline(std::initializer_list<Point> points, const Stroke& stroke, PathEnds ends = PathEnds::Open);
    /// Filled; may be concave. Where its outline crosses itself, each of the loops is filled.
    void polygon(std::span<const Point> points, Color fill);
    void polygon(std::initializer_list<Point> points, Color fill);
    /// The area of the first loop without those of the others, which are its holes.
    void region(std::span<const std::vector<Point>> loops, Color fill);
    void rectangle(const Box& box, Color fill);
    void circle(Point center, double radius, const Stroke& stroke);
    void disc(Point center, double radius, Color fill);
    void arc(const Arc& arc, const Stroke& stroke);
    /// An image of pixels; the picture keeps it as long as it is there itself.
    /// \pre the photo has as many pixels as it says, in colours
    void photo(std::shared_ptr<const Photo> photo, const ImagePlace& place);
    void text(Point at, std::string_view utf8, const TextStyle& style);

    TextExtent measure(std::string_view utf8, const TextStyle& style) const { return fonts_->measure(utf8, style); }

    const Picture& picture() const { return picture_; }

private:
    template <class What> void add(What&& what);
    void refuse() { ++picture_.n_refused_; }
    void draw_plate(Point at, std::string_view utf8, const TextStyle& style);

    Picture picture_;
    const Fonts* fonts_;
    Layer layer_ = Layer::Lines;
    std::vector<Box> clips_;
};

/// Draws in another layer until the end of the scope.
class LayerScope {
public:
    LayerScope(Painter& painter, Layer layer) : painter_(painter), before_(painter.layer())
    {
        painter.set_layer(layer);
    }
    ~LayerScope() { painter_.set_layer(before_); }
    LayerScope(const LayerScope&) = delete;
    LayerScope& operator=(const LayerScope&) = delete;

private:
    Painter& painter_;
    Layer before_;
};

/// Clips to a box until the end of the scope.
class ClipScope {
public:
    ClipScope(Painter& painter, const Box& box) : painter_(painter) { painter.push_clip(box); }
    ~ClipScope() { painter_.pop_clip(); }
    ClipScope(const ClipScope&) = delete;
    ClipScope& operator=(const ClipScope&) = delete;

private:
    Painter& painter_;
};

} // namespace ui
