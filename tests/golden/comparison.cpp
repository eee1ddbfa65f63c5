#include "tests/golden/comparison.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace golden {

namespace {

int difference(const std::uint8_t* a, const std::uint8_t* b)
{
    int largest = 0;
    for (int channel = 0; channel < 3; ++channel) largest = std::max(largest, std::abs(a[channel] - b[channel]));
    return largest;
}

void set_red(std::uint8_t* pixel)
{
    pixel[0] = 220;
    pixel[1] = pixel[2] = 0;
}

struct Corners {
    int x0, y0, x1, y1;

    void add(int x, int y)
    {
        x0 = std::min(x0, x);
        y0 = std::min(y0, y);
        x1 = std::max(x1, x);
        y1 = std::max(y1, y);
    }
};

void draw_frame(ui::Pixels& picture, const Corners& c)
{
    constexpr int margin = 6;
    const int x0 = std::max(c.x0 - margin, 0), x1 = std::min(c.x1 + margin, picture.size.width - 1);
    const int y0 = std::max(c.y0 - margin, 0), y1 = std::min(c.y1 + margin, picture.size.height - 1);
    for (int x = x0; x <= x1; ++x) {
        set_red(picture.at(x, y0));
        set_red(picture.at(x, y1));
    }
    for (int y = y0; y <= y1; ++y) {
        set_red(picture.at(x0, y));
        set_red(picture.at(x1, y));
    }
}

} // namespace

Comparison compare(const ui::Pixels& found, const ui::Pixels& wanted)
{
    Comparison result;
    result.has_same_size = found.size == wanted.size;
    if (!result.has_same_size) return result;
    for (int y = 0; y < found.size.height; ++y) {
        for (int x = 0; x < found.size.width; ++x) {
            const int off = difference(found.at(x, y), wanted.at(x, y));
            result.largest = std::max(result.largest, off);
            if (off > tolerance) ++result.n_differing;
        }
    }
    return result;
}

ui::Pixels difference_picture(const ui::Pixels& found, const ui::Pixels& wanted)
{
    ui::Pixels picture = wanted;
    Corners corners{picture.size.width, picture.size.height, -1, -1};
    for (int y = 0; y < picture.size.height; ++y) {
        for (int x = 0; x < picture.size.width; ++x) {
            std::uint8_t* pixel = picture.at(x, y);
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] = static_cast<std::uint8_t>(191 + pixel[channel] / 4);
            if (difference(found.at(x, y), wanted.at(x, y)) <= tolerance) continue;
            set_red(pixel);
            corners.add(x, y);
        }
    }
    if (corners.x1 >= 0) draw_frame(picture, corners);
    return picture;
}

std::string first_difference(std::string_view found, std::string_view wanted)
{
    std::istringstream a{std::string(found)}, b{std::string(wanted)};
    for (int number = 1;; ++number) {
        std::string line_a, line_b;
        const bool has_a = static_cast<bool>(std::getline(a, line_a)),
                   has_b = static_cast<bool>(std::getline(b, line_b));
        if (!has_a && !has_b) return {};
        if (has_a && has_b && line_a == line_b) continue;
        return "line " + std::to_string(number) + ": found " + (has_a ? line_a : "nothing more") + ", wanted " +
               (has_b ? line_b : "nothing more");
    }
}

} // namespace golden
