#include "ui/paint/picture.h"

#include "ui/paint/trim.h"

#include <array>

namespace ui {

namespace {

/// How far a line may run out of sight before it is cut: farther than its own width and mitres reach.
double margin_of(const Stroke& stroke) { return 64.0 + 4.0 * stroke.width; }

constexpr double fill_margin = 64.0;

} // namespace

Picture::Range Picture::store(std::span<const Point> points)
{
    const Range range{points_.size(), points.size()};
    points_.insert(points_.end(), points.begin(), points.end());
    return range;
}

std::vector<Box> Picture::text_boxes(const Fonts& fonts) const
{
    std::vector<Box> boxes;
    for (const Shape& shape : shapes_)
        if (const auto* text = std::get_if<Text>(&shape.what))
            boxes.push_back(text_box(fonts, text->at, words(*text), text->style));
    return boxes;
}

void Picture::draw_on(Surface& surface) const
{
    std::array<std::vector<const Shape*>, n_layers> by_layer;
    for (const Shape& shape : shapes_) by_layer[static_cast<std::size_t>(shape.layer)].push_back(&shape);
    const Box* clip = nullptr;
    for (std::size_t layer = 0; layer < n_layers; ++layer) {
        if (!by_layer[layer].empty()) surface.begin_layer(static_cast<Layer>(layer));
        for (const Shape* shape : by_layer[layer]) {
            const Box& wanted = clips_[shape->clip];
            if (wanted.is_empty()) continue;
            if (!clip || *clip != wanted) surface.clip(wanted);
            clip = &wanted;
            draw(*shape, surface);
        }
    }
}

void Picture::draw(const Shape& shape, Surface& surface) const
{
    const Box& clip = clips_[shape.clip];
    if (const auto* line = std::get_if<Line>(&shape.what)) {
        const Path path{points(line->points), line->ends, 0.0};
        stroke_trimmed(path, line->stroke, clip.grown(margin_of(line->stroke)), surface);
    } else if (const auto* polygon = std::get_if<Polygon>(&shape.what)) {
        fill_trimmed(points(polygon->points), polygon->fill, clip.grown(fill_margin), surface);
    } else if (const auto* region = std::get_if<Region>(&shape.what)) {
        std::vector<std::vector<Point>> loops;
        for (const Range range : region->loops) loops.emplace_back(points(range).begin(), points(range).end());
        fill_region_trimmed(std::move(loops), region->fill, clip.grown(fill_margin), surface);
    } else if (const auto* arc = std::get_if<ArcLine>(&shape.what)) {
        stroke_arc_trimmed(arc->arc, arc->stroke, clip.grown(margin_of(arc->stroke)), surface);
    } else if (const auto* disc = std::get_if<Disc>(&shape.what)) {
        fill_disc_trimmed(disc->center, disc->radius, disc->fill, clip.grown(fill_margin), surface);
    } else if (const auto* placed = std::get_if<PlacedPhoto>(&shape.what)) {
        surface.image(*placed->photo, placed->place);
    } else {
        const auto& text = std::get<Text>(shape.what);
        surface.text(text.at, words(text), text.style);
    }
}

} // namespace ui
