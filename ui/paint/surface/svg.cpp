#include "ui/paint/surface/svg.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace ui {

namespace {

/// Shortest text with at most two decimals (three would be below a thousandth of a millimetre on paper).
std::string number(double value)
{
    std::array<char, 64> buffer;
    const double hundredths = std::round(value * 100.0) / 100.0 + 0.0;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), hundredths);
    return error == std::errc{} ? std::string(buffer.data(), end) : "0";
}

std::string escaped(std::string_view utf8)
{
    std::string text;
    for (const char c : utf8) {
        if (c == '&') text += "&amp;";
        else if (c == '<') text += "&lt;";
        else if (c == '>') text += "&gt;";
        else if (c == '"') text += "&quot;";
        else if (static_cast<unsigned char>(c) >= 0x20) text += c;
        else text += ' '; // control characters are not allowed in XML
    }
    return text;
}

std::string attribute(std::string_view name, std::string_view value)
{
    std::string text = " ";
    text.append(name).append("=\"").append(value).append("\"");
    return text;
}

std::string attribute(std::string_view name, double value) { return attribute(name, number(value)); }

std::string paint_attributes(std::string_view what, Color color)
{
    std::string text = attribute(what, hex_text({color.r, color.g, color.b, 255}));
    if (color.a != 255) text += attribute(std::string(what) + "-opacity", color.a / 255.0);
    return text;
}

std::string dash_attributes(const DashPattern& dash, double offset)
{
    if (dash.is_solid()) return {};
    std::string lengths;
    for (const double length : dash.lengths()) lengths += (lengths.empty() ? "" : " ") + number(length);
    std::string text = attribute("stroke-dasharray", lengths);
    if (offset != 0.0) text += attribute("stroke-dashoffset", std::fmod(offset, dash.period()));
    return text;
}

std::string stroke_attributes(const Stroke& stroke, double dash_offset)
{
    std::string text = attribute("fill", "none") + paint_attributes("stroke", stroke.color);
    text += attribute("stroke-width", stroke.width) + dash_attributes(stroke.dash, dash_offset);
    if (stroke.cap != Cap::Butt) text += attribute("stroke-linecap", stroke.cap == Cap::Round ? "round" : "square");
    if (stroke.join != Join::Miter)
        text += attribute("stroke-linejoin", stroke.join == Join::Round ? "round" : "bevel");
    return text;
}

std::string path_data(std::span<const Point> points, PathEnds ends)
{
    std::string data;
    for (const Point p : points) data += (data.empty() ? "M" : "L") + number(p.x) + " " + number(p.y);
    if (ends == PathEnds::Closed) data += "Z";
    return data;
}

std::string arc_data(const Arc& arc)
{
    const auto to = [&](Point p) {
        const std::string r = number(arc.radius);
        const bool is_large = std::abs(arc.sweep) > std::numbers::pi;
        return "A" + r + " " + r + " 0 " + (is_large ? "1 " : "0 ") + (arc.sweep > 0.0 ? "0 " : "1 ") + number(p.x) +
               " " + number(p.y);
    };
    const Point begin = arc.at(arc.start);
    return "M" + number(begin.x) + " " + number(begin.y) + to(arc.at(arc.start + arc.sweep));
}

std::string base64(std::string_view bytes)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(4 * ((bytes.size() + 2) / 3));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::string_view group = bytes.substr(i, 3);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= group.size() ? digits[bits >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

class SvgSurface final : public Surface {
public:
    SvgSurface(Size size, const Fonts& fonts) : sheet_{{0.0, 0.0}, {size.width, size.height}}, fonts_(fonts) {}

    void clip(const Box& box) override;
    void stroke(const Path& path, const Stroke& stroke) override;
    void fill(std::span<const Point> polygon, Color color) override;
    void fill_region(std::span<const std::vector<Point>> loops, Color color) override;
    void stroke_arc(const Arc& arc, const Stroke& stroke) override;
    void fill_disc(Point center, double radius, Color color) override;
    void image(const Photo& photo, const ImagePlace& place) override;
    void text(Point at, std::string_view utf8, const TextStyle& style) override;

    std::string document(Color background);

private:
    void close_clip();
    std::string circle(Point center, double radius, const std::string& attributes) const;

    Box sheet_;
    const Fonts& fonts_;
    std::string body_;
    int n_clips_ = 0;
    bool in_clip_ = false;
};

void SvgSurface::close_clip()
{
    if (in_clip_) body_ += "</g>\n";
    in_clip_ = false;
}

void SvgSurface::clip(const Box& box)
{
    close_clip();
    if (box.contains(sheet_)) return; // the document's own border clips
    const std::string id = "clip" + std::to_string(++n_clips_);
    body_ += "<clipPath" + attribute("id", id) + "><rect" + attribute("x", box.min.x) + attribute("y", box.min.y) +
             attribute("width", box.width()) + attribute("height", box.height()) + "/></clipPath>\n";
    body_ += "<g" + attribute("clip-path", "url(#" + id + ")") + ">\n";
    in_clip_ = true;
}

void SvgSurface::stroke(const Path& path, const Stroke& stroke)
{
    body_ += "<path" + attribute("d", path_data(path.points, path.ends)) + stroke_attributes(stroke, path.dash_offset) +
             "/>\n";
}

void SvgSurface::fill(std::span<const Point> polygon, Color color)
{
    body_ += "<path" + attribute("d", path_data(polygon, PathEnds::Closed)) + paint_attributes("fill", color) + "/>\n";
}

void SvgSurface::fill_region(std::span<const std::vector<Point>> loops, Color color)
{
    std::string data;
    for (const std::vector<Point>& loop : loops)
        if (!loop.empty()) data += path_data(loop, PathEnds::Closed);
    body_ += "<path" + attribute("d", data) + attribute("fill-rule", "evenodd") + paint_attributes("fill", color) +
             "/>\n";
}

std::string SvgSurface::circle(Point center, double radius, const std::string& attributes) const
{
    return "<circle" + attribute("cx", center.x) + attribute("cy", center.y) + attribute("r", radius) + attributes +
           "/>\n";
}

void SvgSurface::stroke_arc(const Arc& arc, const Stroke& stroke)
{
    const std::string look = stroke_attributes(stroke, 0.0);
    if (std::abs(arc.sweep) >= 2.0 * std::numbers::pi - 1e-9) body_ += circle(arc.center, arc.radius, look);
    else body_ += "<path" + attribute("d", arc_data(arc)) + look + "/>\n";
}

void SvgSurface::fill_disc(Point center, double radius, Color color)
{
    body_ += circle(center, radius, paint_attributes("fill", color));
}

/// One unit of the image is all of it, so that its matrix is its two sides.
void SvgSurface::image(const Photo& photo, const ImagePlace& place)
{
    std::string matrix;
    for (const Point p : {place.right, place.down, place.corner})
        matrix += (matrix.empty() ? "matrix(" : " ") + number(p.x) + " " + number(p.y);
    body_ += "<image" + attribute("width", "1") + attribute("height", "1") + attribute("preserveAspectRatio", "none") +
             attribute("transform", matrix + ")");
    if (place.opacity < 1.0) body_ += attribute("opacity", place.opacity);
    body_ += attribute("href", "data:" + photo.media_type + ";base64," + base64(photo.file)) + "/>\n";
}

void SvgSurface::text(Point at, std::string_view utf8, const TextStyle& style)
{
    const TextExtent extent = fonts_.measure(utf8, style);
    const Point base = at + baseline_offset(extent, fonts_.cap_height() * style.size, style.anchor);
    body_ += "<text" + attribute("x", base.x) + attribute("y", base.y) + attribute("font-size", style.size);
    if (style.weight == Weight::Bold) body_ += attribute("font-weight", "bold");
    body_ += paint_attributes("fill", style.color);
    body_ += attribute("textLength", extent.width) + attribute("lengthAdjust", "spacingAndGlyphs");
    if (style.rotation != 0.0) {
        const double degrees = -style.rotation * 180.0 / std::numbers::pi; // SVG turns clockwise
        body_ += attribute("transform", "rotate(" + number(degrees) + " " + number(at.x) + " " + number(at.y) + ")");
    }
    body_ += ">" + escaped(encode_utf8(decode_utf8(utf8))) + "</text>\n";
}

std::string SvgSurface::document(Color background)
{
    close_clip();
    const std::string width = number(sheet_.width()), height = number(sheet_.height());
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
    text += attribute("width", width) + attribute("height", height);
    text += attribute("viewBox", "0 0 " + width + " " + height);
    text += attribute("font-family", "'DejaVu Sans', 'Bitstream Vera Sans', Verdana, sans-serif");
    text += attribute("xml:space", "preserve") + ">\n";
    if (background.a != 0)
        text += "<rect" + attribute("width", width) + attribute("height", height) +
                paint_attributes("fill", background) + "/>\n";
    return text + body_ + "</svg>\n";
}

} // namespace

std::string svg_document(const Picture& picture, const Fonts& fonts, Color background)
{
    SvgSurface surface(picture.size(), fonts);
    picture.draw_on(surface);
    return surface.document(background);
}

} // namespace ui
