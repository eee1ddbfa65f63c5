#include "apps/plane/backdrop/backdrop.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "ui/files/ending.h"

namespace plane {

FlatVector Backdrop::up() const
{
    const double height_of_width = static_cast<double>(photo->image.height) / photo->image.width;
    return {-height_of_width * across.y, height_of_width * across.x};
}

std::array<FlatPoint, 4> Backdrop::corners() const
{
    const FlatVector left = up();
    return {corner, corner + across, corner + across + left, corner + left};
}

Backdrop backdrop_within(std::shared_ptr<const ui::Photo> photo, std::filesystem::path file, const FlatPoint& low,
                         const FlatPoint& high)
{
    const double height_of_width = static_cast<double>(photo->image.height) / photo->image.width;
    const double width = std::min(high.x - low.x, (high.y - low.y) / height_of_width);
    const FlatVector half{0.5 * width, 0.5 * width * height_of_width};
    return {.photo = std::move(photo),
            .file = std::move(file),
            .corner = middle(low, high) + -half,
            .across = {width, 0.0}};
}

bool is_image_file(const std::filesystem::path& path)
{
    constexpr std::array<std::string_view, 3> endings{".png", ".jpg", ".jpeg"};
    return std::ranges::any_of(endings, [&](std::string_view ending) { return ui::has_ending(path, ending); });
}

// In the plane of complex numbers z becomes to0 + (to1 - to0) (z - from0) / (from1 - from0).
Backdrop aligned(const Backdrop& backdrop, const Alignment& alignment)
{
    const auto& [from, to] = alignment;
    const FlatVector was = from[1] - from[0], is = to[1] - to[0];
    const double square = dot(was, was), along = dot(was, is) / square, aside = cross(was, is) / square;
    const auto turned = [&](const FlatVector& a) {
        return FlatVector{along * a.x - aside * a.y, aside * a.x + along * a.y};
    };
    Backdrop result = backdrop;
    result.corner = to[0] + turned(backdrop.corner - from[0]);
    result.across = turned(backdrop.across);
    return result;
}

} // namespace plane
