#include "ui/context/draw_list_surface.h"

#include "ui/paint/mesh/polygon_mesh.h"
#include "ui/paint/mesh/simplified.h"
#include "ui/paint/mesh/stroke_mesh.h"
#include "ui/paint/trim.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

namespace ui {

namespace {

constexpr double unseen = 0.06;               // [px] by which a curve may be off
constexpr double flatness = 0.12;             // [px] of circles
constexpr std::uint8_t palest_alpha = 72;     // up to which jagged borders of areas go unnoticed
constexpr std::size_t most_vertices = 60'000; // that a draw list takes at a time, with indices of 16 bits

ImTextureID texture_of(const Image* image) { return static_cast<ImTextureID>(const_cast<Image*>(image)); }

ImVec2 vec(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

ImU32 packed(Color c, float coverage)
{
    const auto alpha = static_cast<std::uint32_t>(std::lround(static_cast<float>(c.a) * coverage));
    return IM_COL32(c.r, c.g, c.b, alpha);
}

/// A line of this width [px] looks crisp with its middle on a pixel's middle when odd, on a border when even.
/// Halfway between two such places the last bit of a result must not decide, so all of them go the same way.
double crisp_middle(double place, double width)
{
    constexpr double rounding = 1e-6; // [px]
    const bool is_odd = std::lround(std::max(1.0, width)) % 2 == 1;
    return is_odd ? std::floor(place + rounding) + 0.5 : std::floor(place + 0.5 + rounding);
}

/// Moves level and upright edges onto the pixel grid; `snap` gives the new place of a coordinate.
template <class Snap> void snap_edges(std::vector<Point>& points, PathEnds ends, const Snap& snap)
{
    constexpr double straight = 1e-3; // [px]
    const std::size_t n = points.size(), n_edges = ends == PathEnds::Closed ? n : n - 1;
    const Point first = points.front();
    Point given = first;
    for (std::size_t i = 0; i < n_edges; ++i) {
        const std::size_t j = (i + 1) % n;
        const Point next = j == 0 ? first : points[j];
        if (std::abs(given.x - next.x) < straight) points[i].x = points[j].x = snap(given.x);
        if (std::abs(given.y - next.y) < straight) points[i].y = points[j].y = snap(given.y);
        given = next;
    }
}

/// The quarter turns of a rotation, where it is a whole number of them.
std::optional<int> quarter_turns(double rotation)
{
    const double quarters = rotation / (0.5 * std::numbers::pi);
    const double whole = std::round(quarters);
    if (std::abs(quarters - whole) > 1e-6) return std::nullopt;
    return static_cast<int>(static_cast<long long>(whole) & 3);
}

/// v turned counter-clockwise as seen.
Point turned_by_quarters(Point v, int quarters)
{
    for (int i = 0; i < quarters; ++i) v = left_normal(v);
    return v;
}

} // namespace

DrawListSurface::DrawListSurface(ImDrawList& list, GlyphAtlas& atlas, const DrawListPlace& place)
    : list_(list), atlas_(atlas), place_(place)
{
    list_.PushTextureID(texture_of(page_));
}

DrawListSurface::~DrawListSurface()
{
    if (has_clip_) list_.PopClipRect();
    list_.PopTextureID();
}

/// Lines and areas are drawn faster without an image; a layer begins with them as a rule.
void DrawListSurface::begin_layer(Layer) { use_page(nullptr); }

void DrawListSurface::clip(const Box& box)
{
    if (has_clip_) list_.PopClipRect();
    const auto whole = [](Point p) { return Point{std::round(p.x), std::round(p.y)}; };
    list_.PushClipRect(vec(whole(on_list(box.min))), vec(whole(on_list(box.max))), true);
    has_clip_ = true;
    clip_ = box;
}

void DrawListSurface::use_page(const Image* page)
{
    if (page == page_) return;
    list_.PopTextureID();
    list_.PushTextureID(texture_of(page));
    page_ = page;
}

/// Hands the mesh to the draw list, in portions that its short indices can count.
void DrawListSurface::emit(Color color)
{
    const bool is_small = mesh_.vertices.size() <= most_vertices;
    const std::size_t n_indices = mesh_.indices.size();
    if (is_small && n_indices > 0) {
        list_.PrimReserve(static_cast<int>(n_indices), static_cast<int>(mesh_.vertices.size()));
        const auto first = list_._VtxCurrentIdx;
        for (const std::uint32_t i : mesh_.indices) list_.PrimWriteIdx(static_cast<ImDrawIdx>(first + i));
        for (const auto& v : mesh_.vertices) write(v, color);
    }
    for (std::size_t begin = 0; !is_small && begin < n_indices; begin += most_vertices) {
        const std::size_t n = std::min(most_vertices, n_indices - begin);
        list_.PrimReserve(static_cast<int>(n), static_cast<int>(n));
        const auto first = list_._VtxCurrentIdx;
        for (std::size_t k = 0; k < n; ++k) {
            list_.PrimWriteIdx(static_cast<ImDrawIdx>(first + k));
            write(mesh_.vertices[mesh_.indices[begin + k]], color);
        }
    }
    mesh_.clear();
}

void DrawListSurface::write(const Mesh::Vertex& v, Color color)
{
    constexpr auto full = static_cast<float>(GlyphAtlas::full_pixel());
    const ImVec2 uv = v.reach > 0.0F ? ImVec2(v.across, -v.reach) : ImVec2(full, full); // see DrawListRenderer
    list_.PrimWriteVtx({v.x, v.y}, uv, packed(color, v.coverage));
}

void DrawListSurface::stroke(const Path& path, const Stroke& stroke)
{
    std::vector<Point>& points = line_;
    points.resize(path.points.size());
    std::transform(path.points.begin(), path.points.end(), points.begin(), [&](Point p) { return on_list(p); });
    const StrokeShape shape{.width = stroke.width * place_.scale, .cap = stroke.cap, .join = stroke.join};
    snap_edges(points, path.ends, [&](double x) { return crisp_middle(x, shape.width); });
    if (points.size() > 2) points = simplified(points, unseen);
    if (stroke.dash.is_solid()) {
        add_stroke(mesh_, points, path.ends, shape);
    } else {
        const Path snapped{points, path.ends, path.dash_offset * place_.scale};
        for (const auto& dash : dashes_of(snapped, stroke.dash.scaled(place_.scale)))
            add_stroke(mesh_, dash, PathEnds::Open, shape);
    }
    emit(stroke.color);
}

std::vector<Point> DrawListSurface::crisp_outline(std::span<const Point> polygon) const
{
    std::vector<Point> points(polygon.size());
    std::transform(polygon.begin(), polygon.end(), points.begin(), [&](Point p) { return on_list(p); });
    if (!points.empty()) snap_edges(points, PathEnds::Closed, [](double x) { return std::round(x); });
    return points;
}

void DrawListSurface::fill(std::span<const Point> polygon, Color color)
{
    const std::vector<Point> points = simplified(crisp_outline(polygon), unseen);
    add_fill(mesh_, points, color.a <= palest_alpha ? Border::Hard : Border::Soft);
    emit(color);
}

/// Each loop is moved onto the pixel grid for itself, before slits join them.
void DrawListSurface::fill_region(std::span<const std::vector<Point>> loops, Color color)
{
    std::vector<std::vector<Point>> crisp;
    for (const std::vector<Point>& loop : loops) crisp.push_back(crisp_outline(loop));
    add_region(mesh_, crisp);
    emit(color);
}

void DrawListSurface::stroke_arc(const Arc& arc, const Stroke& stroke)
{
    const bool is_whole = std::abs(arc.sweep) >= 2.0 * std::numbers::pi - 1e-9;
    std::vector<Point> points = arc_points(arc, flatness / place_.scale);
    if (is_whole) points.pop_back();
    for (Point& p : points) p = on_list(p);
    const StrokeShape shape{.width = stroke.width * place_.scale, .cap = stroke.cap, .join = Join::Miter};
    const PathEnds ends = is_whole ? PathEnds::Closed : PathEnds::Open;
    if (stroke.dash.is_solid()) {
        add_stroke(mesh_, points, ends, shape);
    } else {
        for (const auto& dash : dashes_of({points, ends, 0.0}, stroke.dash.scaled(place_.scale)))
            add_stroke(mesh_, dash, PathEnds::Open, shape);
    }
    emit(stroke.color);
}

void DrawListSurface::fill_disc(Point center, double radius, Color color)
{
    add_disc(mesh_, on_list(center), radius * place_.scale);
    emit(color);
}

void DrawListSurface::glyph(const GlyphPlace& place, const std::array<Point, 4>& corners, Color color)
{
    use_page(place.page);
    constexpr float texel = 1.0F / GlyphAtlas::page_side;
    const float u0 = static_cast<float>(place.x) * texel, v0 = static_cast<float>(place.y) * texel;
    const float u1 = static_cast<float>(place.x + place.width) * texel;
    const float v1 = static_cast<float>(place.y + place.height) * texel;
    list_.PrimReserve(6, 4);
    list_.PrimQuadUV(vec(corners[0]), vec(corners[1]), vec(corners[2]), vec(corners[3]), {u0, v0}, {u1, v0}, {u1, v1},
                     {u0, v1}, packed(color, 1.0F));
}

/// The part within the clip alone: the numbers of a list are too short for an image that is far larger than the sheet.
void DrawListSurface::image(const Photo& photo, const ImagePlace& place)
{
    const Point right = place.right, down = place.down;
    const double area = cross(right, down);
    const std::array corners{place.corner, place.corner + right, place.corner + right + down, place.corner + down};
    const std::vector<Point> seen = polygon_inside(corners, clip_.grown(1.0));
    if (seen.size() < 3) return;
    const Color ink{255, 255, 255, static_cast<std::uint8_t>(std::lround(255.0 * place.opacity))};
    use_page(&photo.image);
    const auto n = static_cast<int>(seen.size());
    list_.PrimReserve(3 * (n - 2), n);
    const auto first = list_._VtxCurrentIdx;
    for (int i = 1; i + 1 < n; ++i)
        for (const int k : {0, i, i + 1}) list_.PrimWriteIdx(static_cast<ImDrawIdx>(first + static_cast<unsigned>(k)));
    for (const Point p : seen) {
        const Point at = p - place.corner;
        const Point share{std::clamp(cross(at, down) / area, 0.0, 1.0), std::clamp(cross(right, at) / area, 0.0, 1.0)};
        list_.PrimWriteVtx(vec(on_list(p)), vec(share), packed(ink, 1.0F));
    }
    use_page(nullptr); // the next string takes its own
}

void DrawListSurface::text(Point at, std::string_view utf8, const TextStyle& style)
{
    const Fonts& fonts = atlas_.fonts();
    const Point base = place_.scale *
                       baseline_offset(fonts.measure(utf8, style), fonts.cap_height() * style.size, style.anchor);
    const std::u32string characters = decode_utf8(utf8);
    set_text(on_list(at), base, characters, style);
}

/// Quarter turns put each glyph's pixels on the screen's pixels: as sharp as level text.
void DrawListSurface::set_text(Point at, Point base, std::u32string_view characters, const TextStyle& style)
{
    const auto quarters = quarter_turns(style.rotation);
    const Point right = quarters ? turned_by_quarters({1.0, 0.0}, *quarters)
                                 : Point{std::cos(style.rotation), -std::sin(style.rotation)};
    const Point down = -left_normal(right);
    const double em = style.size * place_.scale;
    const double stretch = em / std::clamp(em, 1.0, GlyphAtlas::largest_em);
    Point pen = at + base.x * right + base.y * down;
    if (quarters) // the baseline lies on a border between pixels
        pen = pen + (std::round(dot(pen, down)) - dot(pen, down)) * down;
    for (const char32_t c : characters) {
        GlyphLook look{.character = c, .weight = style.weight, .size = em, .phase = 0, .fit = GlyphFit::None};
        Point corner = pen;
        if (quarters) {
            const double along = dot(pen, right);
            const double steps = std::round(along * GlyphAtlas::n_phases);
            const double whole = std::floor(steps / GlyphAtlas::n_phases);
            look.phase = static_cast<int>(steps - whole * GlyphAtlas::n_phases);
            look.fit = GlyphFit::Pixels;
            corner = pen + (whole - along) * right;
        }
        const GlyphPlace place = atlas_.glyph(look);
        corner = corner + (stretch * place.left) * right + (stretch * place.top) * down;
        const Point across = (stretch * place.width) * right, below = (stretch * place.height) * down;
        if (place.width > 0)
            glyph(place, {corner, corner + across, corner + across + below, corner + below}, style.color);
        pen = pen + (atlas_.fonts().advance(c, style.weight) * em) * right;
    }
}

} // namespace ui
