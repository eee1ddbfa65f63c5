#pragma once

#include "ui/paint/mesh/mesh.h"
#include "ui/paint/surface.h"
#include "ui/paint/surface/glyph_atlas.h"

#include <array>
#include <string_view>
#include <vector>

struct ImDrawList;

namespace ui {

/// How a sheet lies on the draw list: the place of its corner and the physical pixels of a logical one.
/// In this program a unit of Dear ImGui is a physical pixel.
struct DrawListPlace {
    Point origin{};
    double scale = 1.0;
};

/// Draws on a list of Dear ImGui's: in a window of an app, or off screen.
///
/// Lines and areas become triangles with soft edges. Level and upright lines are moved by up to half a pixel so that
/// they cover whole pixels and look crisp; so are level and upright strings. A layer takes one draw call before its
/// first string and one from there on, but for clips and pages of the atlas.
/// \pre the list and the atlas outlive the surface, and the atlas is not trimmed before the list is rendered
class DrawListSurface final : public Surface {
public:
    DrawListSurface(ImDrawList& list, GlyphAtlas& atlas, const DrawListPlace& place);
    ~DrawListSurface() override;
    DrawListSurface(const DrawListSurface&) = delete;
    DrawListSurface& operator=(const DrawListSurface&) = delete;

    void begin_layer(Layer layer) override;
    void clip(const Box& box) override;
    void stroke(const Path& path, const Stroke& stroke) override;
    void fill(std::span<const Point> polygon, Color color) override;
    /// With jagged borders: meant for pale areas.
    void fill_region(std::span<const std::vector<Point>> loops, Color color) override;
    void stroke_arc(const Arc& arc, const Stroke& stroke) override;
    void fill_disc(Point center, double radius, Color color) override;
    void image(const Photo& photo, const ImagePlace& place) override;
    void text(Point at, std::string_view utf8, const TextStyle& style) override;

private:
    Point on_list(Point p) const { return place_.origin + place_.scale * p; }
    std::vector<Point> crisp_outline(std::span<const Point> polygon) const;
    void use_page(const Image* page);
    void emit(Color color);
    void write(const Mesh::Vertex& vertex, Color color);
    void glyph(const GlyphPlace& place, const std::array<Point, 4>& corners, Color color);
    void set_text(Point at, Point base, std::u32string_view characters, const TextStyle& style);

    ImDrawList& list_;
    GlyphAtlas& atlas_;
    DrawListPlace place_;
    const Image* page_ = nullptr; ///< of the atlas; null before a layer's first string
    Box clip_{};
    bool has_clip_ = false;
    Mesh mesh_;
    std::vector<Point> line_; ///< the one that is drawn, in the list's pixels
};

} // namespace ui
