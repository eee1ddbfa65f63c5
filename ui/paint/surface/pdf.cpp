#include "ui/paint/surface/pdf.h"

#include "ui/paint/surface/write_file.h"

#include <cairo-ft.h>
#include <cairo-pdf.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace ui {

namespace {

constexpr double points_per_pixel = 72.0 / 96.0;

struct CloseCairo {
    void operator()(cairo_t* c) const { cairo_destroy(c); }
    void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
    void operator()(cairo_font_face_t* f) const { cairo_font_face_destroy(f); }
    void operator()(cairo_font_options_t* o) const { cairo_font_options_destroy(o); }
};
using Cairo = std::unique_ptr<cairo_t, CloseCairo>;
using CairoTarget = std::unique_ptr<cairo_surface_t, CloseCairo>;
using CairoFont = std::unique_ptr<cairo_font_face_t, CloseCairo>;

/// What a Cairo font needs as long as Cairo keeps it, which may be longer than the document: the bytes and FreeType.
struct FontSource {
    std::vector<unsigned char> bytes;
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    explicit FontSource(std::span<const unsigned char> file) : bytes(file.begin(), file.end())
    {
        if (FT_Init_FreeType(&library) != 0 ||
            FT_New_Memory_Face(library, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &face) != 0)
            throw FontError("font reader: FreeType does not read the font DejaVu Sans");
    }
    ~FontSource()
    {
        if (face) FT_Done_Face(face);
        if (library) FT_Done_FreeType(library);
    }
    FontSource(const FontSource&) = delete;
    FontSource& operator=(const FontSource&) = delete;
};

CairoFont cairo_font(std::span<const unsigned char> file)
{
    static const cairo_user_data_key_t key{};
    auto source = std::make_unique<FontSource>(file);
    CairoFont font(cairo_ft_font_face_create_for_ft_face(source->face, FT_LOAD_NO_HINTING));
    const auto close = [](void* data) { delete static_cast<FontSource*>(data); };
    if (cairo_font_face_set_user_data(font.get(), &key, source.get(), close) == CAIRO_STATUS_SUCCESS) [[maybe_unused]]
        const FontSource* kept_by_cairo = source.release();
    return font;
}

/// Cairo keeps a pixel as one number of 32 bits, 0xAARRGGBB, with colours multiplied by the opacity.
CairoTarget cairo_image(const Image& image)
{
    CairoTarget target(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
    unsigned char* const data = cairo_image_surface_get_data(target.get());
    const int stride = cairo_image_surface_get_stride(target.get());
    if (data == nullptr) throw std::runtime_error("the pages cannot be drawn: an image is too large");
    const std::uint8_t* pixel = image.pixels.data();
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x, pixel += 4) {
            const auto part = [&](int k) { return static_cast<std::uint32_t>((pixel[k] * pixel[3] + 127) / 255); };
            const std::uint32_t argb = static_cast<std::uint32_t>(pixel[3]) << 24 | part(0) << 16 | part(1) << 8 |
                                       part(2);
            std::memcpy(data + static_cast<std::ptrdiff_t>(y) * stride + 4 * static_cast<std::ptrdiff_t>(x), &argb, 4);
        }
    cairo_surface_mark_dirty(target.get());
    return target;
}

void attach(cairo_surface_t* pixels, const Photo& photo)
{
    auto file = std::make_unique<std::string>(photo.file); // Cairo reads it when the page ends
    const auto close = [](void* data) { delete static_cast<std::string*>(data); };
    const auto* const bytes = reinterpret_cast<const unsigned char*>(file->data());
    if (cairo_surface_set_mime_data(pixels, CAIRO_MIME_TYPE_JPEG, bytes, file->size(), close, file.get()) ==
        CAIRO_STATUS_SUCCESS) [[maybe_unused]]
        const std::string* kept_by_cairo = file.release();
}

class CairoPage final : public Surface {
public:
    CairoPage(cairo_t* cairo, const Fonts& fonts)
        : cairo_(cairo),
          fonts_(fonts),
          regular_(cairo_font(fonts.file(Weight::Regular))),
          bold_(cairo_font(fonts.file(Weight::Bold)))
    {}

    void clip(const Box& box) override;
    void stroke(const Path& path, const Stroke& stroke) override;
    void fill(std::span<const Point> polygon, Color color) override;
    void fill_region(std::span<const std::vector<Point>> loops, Color color) override;
    void stroke_arc(const Arc& arc, const Stroke& stroke) override;
    void fill_disc(Point center, double radius, Color color) override;
    void text(Point at, std::string_view utf8, const TextStyle& style) override;
    void image(const Photo& photo, const ImagePlace& place) override;
    void fill_page(Color color);

private:
    void set_color(Color color);
    void set_stroke(const Stroke& stroke, double dash_offset);
    void trace(std::span<const Point> points);
    void show(std::string_view utf8, const TextStyle& style);

    cairo_t* cairo_;
    const Fonts& fonts_;
    CairoFont regular_;
    CairoFont bold_;
};

void CairoPage::set_color(Color color)
{
    cairo_set_source_rgba(cairo_, color.r / 255.0, color.g / 255.0, color.b / 255.0, color.a / 255.0);
}

void CairoPage::set_stroke(const Stroke& stroke, double dash_offset)
{
    set_color(stroke.color);
    cairo_set_line_width(cairo_, stroke.width);
    const auto dash = stroke.dash.lengths();
    cairo_set_dash(cairo_, dash.data(), static_cast<int>(dash.size()), dash_offset);
    cairo_set_line_cap(cairo_, stroke.cap == Cap::Butt    ? CAIRO_LINE_CAP_BUTT
                               : stroke.cap == Cap::Round ? CAIRO_LINE_CAP_ROUND
                                                          : CAIRO_LINE_CAP_SQUARE);
    cairo_set_line_join(cairo_, stroke.join == Join::Miter   ? CAIRO_LINE_JOIN_MITER
                                : stroke.join == Join::Round ? CAIRO_LINE_JOIN_ROUND
                                                             : CAIRO_LINE_JOIN_BEVEL);
    cairo_set_miter_limit(cairo_, 4.0);
}

void CairoPage::trace(std::span<const Point> points)
{
    cairo_new_path(cairo_);
    for (const Point p : points) cairo_line_to(cairo_, p.x, p.y);
}

void CairoPage::clip(const Box& box)
{
    cairo_reset_clip(cairo_);
    cairo_new_path(cairo_);
    cairo_rectangle(cairo_, box.min.x, box.min.y, box.width(), box.height());
    cairo_clip(cairo_);
}

void CairoPage::stroke(const Path& path, const Stroke& stroke)
{
    trace(path.points);
    if (path.ends == PathEnds::Closed) cairo_close_path(cairo_);
    set_stroke(stroke, path.dash_offset);
    cairo_stroke(cairo_);
}

void CairoPage::fill(std::span<const Point> polygon, Color color)
{
    trace(polygon);
    set_color(color);
    cairo_fill(cairo_);
}

void CairoPage::fill_region(std::span<const std::vector<Point>> loops, Color color)
{
    cairo_new_path(cairo_);
    for (const std::vector<Point>& loop : loops) {
        cairo_new_sub_path(cairo_);
        for (const Point p : loop) cairo_line_to(cairo_, p.x, p.y);
        cairo_close_path(cairo_);
    }
    set_color(color);
    cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill(cairo_);
    cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_WINDING);
}

void CairoPage::stroke_arc(const Arc& arc, const Stroke& stroke)
{
    cairo_new_path(cairo_);
    const double begin = -arc.start, end = -arc.start - arc.sweep; // Cairo's angles are clockwise as seen
    if (arc.sweep > 0.0) cairo_arc_negative(cairo_, arc.center.x, arc.center.y, arc.radius, begin, end);
    else cairo_arc(cairo_, arc.center.x, arc.center.y, arc.radius, begin, end);
    if (std::abs(arc.sweep) >= 2.0 * std::numbers::pi - 1e-9) cairo_close_path(cairo_);
    set_stroke(stroke, 0.0);
    cairo_stroke(cairo_);
}

void CairoPage::fill_disc(Point center, double radius, Color color)
{
    cairo_new_path(cairo_);
    cairo_arc(cairo_, center.x, center.y, radius, 0.0, 2.0 * std::numbers::pi);
    set_color(color);
    cairo_fill(cairo_);
}

void CairoPage::text(Point at, std::string_view utf8, const TextStyle& style)
{
    cairo_save(cairo_);
    cairo_translate(cairo_, at.x, at.y);
    cairo_rotate(cairo_, -style.rotation);
    show(utf8, style);
    cairo_restore(cairo_);
}

/// Draws each glyph at its measured place, with the characters beside it so that readers can search for them.
void CairoPage::show(std::string_view utf8, const TextStyle& style)
{
    Point pen = baseline_offset(fonts_.measure(utf8, style), fonts_.cap_height() * style.size, style.anchor);
    std::vector<cairo_glyph_t> glyphs;
    std::vector<cairo_text_cluster_t> clusters;
    const std::u32string characters = decode_utf8(utf8);
    const std::string clean = encode_utf8(characters);
    for (const char32_t c : characters) {
        glyphs.push_back({fonts_.glyph_index(c, style.weight), pen.x, pen.y});
        clusters.push_back({n_utf8_bytes(c), 1});
        pen.x += fonts_.advance(c, style.weight) * style.size;
    }
    cairo_set_font_face(cairo_, style.weight == Weight::Bold ? bold_.get() : regular_.get());
    cairo_set_font_size(cairo_, style.size);
    set_color(style.color);
    cairo_show_text_glyphs(cairo_, clean.data(), static_cast<int>(clean.size()), glyphs.data(),
                           static_cast<int>(glyphs.size()), clusters.data(), static_cast<int>(clusters.size()),
                           static_cast<cairo_text_cluster_flags_t>(0));
}

/// Paper takes a photograph's file as it is; pixels are what is drawn where that cannot be.
void CairoPage::image(const Photo& photo, const ImagePlace& place)
{
    const CairoTarget pixels = cairo_image(photo.image);
    if (photo.media_type == CAIRO_MIME_TYPE_JPEG) attach(pixels.get(), photo);
    const double across = photo.image.width, high = photo.image.height;
    const Point right = place.right / across, down = place.down / high;
    const cairo_matrix_t matrix{right.x, right.y, down.x, down.y, place.corner.x, place.corner.y};
    cairo_save(cairo_);
    cairo_transform(cairo_, &matrix);
    cairo_set_source_surface(cairo_, pixels.get(), 0.0, 0.0);
    cairo_rectangle(cairo_, 0.0, 0.0, across, high);
    cairo_clip(cairo_);
    cairo_paint_with_alpha(cairo_, place.opacity);
    cairo_restore(cairo_);
}

void CairoPage::fill_page(Color color)
{
    if (color.a == 0) return;
    set_color(color);
    cairo_paint(cairo_);
}

void use_unhinted_type(cairo_t* cairo)
{
    const std::unique_ptr<cairo_font_options_t, CloseCairo> options(cairo_font_options_create());
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cairo, options.get());
}

void require(cairo_status_t status)
{
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(std::string("the pages cannot be drawn: ") + cairo_status_to_string(status));
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count)
{
    static_cast<std::string*>(text)->append(bytes, bytes + count);
    return CAIRO_STATUS_SUCCESS;
}

void draw_page(cairo_surface_t* target, const PdfPage& page, const Fonts& fonts, Color background)
{
    const Cairo cairo(cairo_create(target));
    cairo_scale(cairo.get(), points_per_pixel, points_per_pixel);
    use_unhinted_type(cairo.get());
    CairoPage paper(cairo.get(), fonts);
    paper.fill_page(background);
    for (const PlacedPicture& placed : page.pictures) {
        cairo_save(cairo.get());
        cairo_translate(cairo.get(), placed.corner.x, placed.corner.y);
        cairo_scale(cairo.get(), placed.scale, placed.scale);
        placed.picture.draw_on(paper);
        cairo_restore(cairo.get());
    }
    cairo_show_page(cairo.get());
}

} // namespace

void write_pdf(const std::filesystem::path& path, std::span<const PdfPage> pages, const Fonts& fonts,
               const PdfLook& look)
{
    const Size first = pages.empty() ? Size{1.0, 1.0} : points_per_pixel * pages.front().size;
    std::string document; // Cairo does not tell what it could not write to a file
    const CairoTarget target(cairo_pdf_surface_create_for_stream(append, &document, first.width, first.height));
    require(cairo_surface_status(target.get()));
    if (!look.title.empty()) cairo_pdf_surface_set_metadata(target.get(), CAIRO_PDF_METADATA_TITLE, look.title.c_str());
    for (const PdfPage& page : pages) {
        const Size size = points_per_pixel * page.size;
        cairo_pdf_surface_set_size(target.get(), size.width, size.height);
        draw_page(target.get(), page, fonts, look.background);
        require(cairo_surface_status(target.get()));
    }
    cairo_surface_finish(target.get());
    require(cairo_surface_status(target.get()));
    write_file(path, document);
}

void write_pdf(const std::filesystem::path& path, const Picture& picture, const Fonts& fonts, const PdfLook& look)
{
    const PdfPage page{picture.size(), {{picture, {}, 1.0}}};
    write_pdf(path, std::span(&page, 1), fonts, look);
}

} // namespace ui
