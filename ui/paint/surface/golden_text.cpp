#include "ui/paint/surface/golden_text.h"

#include <iomanip>
#include <numbers>
#include <sstream>

namespace ui {

namespace {

constexpr std::string_view anchor_names[] = {"top-left", "top",         "top-right", "left",        "center",
                                             "right",    "bottom-left", "bottom",    "bottom-right"};

std::string tenths(double value)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << std::round(10.0 * value) / 10.0 + 0.0; // + 0.0: never "-0.0"
    return text.str();
}

/// Without decimals where they are zero.
std::string brief(double value)
{
    const std::string text = tenths(value);
    return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
}

class GoldenTextSurface final : public Surface {
public:
    void clip(const Box&) override {}
    void stroke(const Path&, const Stroke&) override { ++n_lines_; }
    void fill(std::span<const Point>, Color) override { ++n_areas_; }
    void fill_region(std::span<const std::vector<Point>>, Color) override { ++n_areas_; }
    void stroke_arc(const Arc&, const Stroke&) override { ++n_lines_; }
    void fill_disc(Point, double, Color) override { ++n_areas_; }
    void image(const Photo& photo, const ImagePlace& place) override;
    void text(Point at, std::string_view utf8, const TextStyle& style) override;

    std::string result(const Picture& picture) const;

private:
    std::ostringstream strings_;
    int n_lines_ = 0;
    int n_areas_ = 0;
    int n_strings_ = 0;
};

void GoldenTextSurface::image(const Photo& photo, const ImagePlace& place)
{
    const auto pair = [](Point p) { return '(' + tenths(p.x) + ", " + tenths(p.y) + ')'; };
    strings_ << pair(place.corner) << " image of " << photo.image.width << " x " << photo.image.height
             << " pixels, right " << pair(place.right) << ", down " << pair(place.down) << ", opacity "
             << brief(100.0 * place.opacity) << "%\n";
}

void GoldenTextSurface::text(Point at, std::string_view utf8, const TextStyle& style)
{
    ++n_strings_;
    strings_ << '(' << tenths(at.x) << ", " << tenths(at.y) << ") "
             << anchor_names[static_cast<std::size_t>(style.anchor)] << ' ' << brief(style.size);
    if (style.weight == Weight::Bold) strings_ << " bold";
    const std::string degrees = brief(style.rotation * 180.0 / std::numbers::pi);
    if (degrees != "0") strings_ << " rotated " << degrees;
    strings_ << " \"" << utf8 << "\"\n";
}

std::string GoldenTextSurface::result(const Picture& picture) const
{
    std::ostringstream head;
    head << "sheet " << brief(picture.size().width) << " x " << brief(picture.size().height) << ", " << n_lines_
         << " lines, " << n_areas_ << " areas, " << n_strings_ << " strings, " << picture.n_refused() << " refused\n";
    return head.str() + strings_.str();
}

} // namespace

std::string golden_text(const Picture& picture)
{
    GoldenTextSurface surface;
    picture.draw_on(surface);
    return surface.result(picture);
}

} // namespace ui
