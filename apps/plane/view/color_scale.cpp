#include "apps/plane/view/color_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plane {

namespace {

constexpr ui::Color cold = ui::rgb(0x0B4F8A), warm = ui::rgb(0xB8430A), pale = ui::rgb(0xF3F1EC),
                    dim = ui::rgb(0x3D434A);
/// Lightness falls evenly from the first to the last.
constexpr std::array one_sided{ui::rgb(0xFFF3B8), ui::rgb(0xF6C667), ui::rgb(0xE08A4B),
                               ui::rgb(0xB8524E), ui::rgb(0x7C2F5B), ui::rgb(0x3D1C52)};
constexpr double lightest_gray = 0.96, darkest_gray = 0.30;

ui::Color along_one_side(double t)
{
    const double at = std::clamp(t, 0.0, 1.0) * (one_sided.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), one_sided.size() - 2);
    return ui::mixed(one_sided[i], one_sided[i + 1], at - static_cast<double>(i));
}

ui::Color gray(double t)
{
    return ui::mixed(ui::rgb(0x000000), ui::rgb(0xFFFFFF), lightest_gray + t * (darkest_gray - lightest_gray));
}

} // namespace

std::vector<ui::Color> band_colors(const std::vector<double>& levels, const ui::Theme& theme)
{
    const std::size_t n = levels.size() - 1;
    const double most = std::max(std::abs(levels.front()), std::abs(levels.back()));
    const bool has_both_signs = levels.front() < -1e-9 * most && levels.back() > 1e-9 * most;
    std::vector<ui::Color> colors;
    for (std::size_t i = 0; i < n; ++i) {
        const double rank = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.5;
        if (theme.name() == ui::ThemeName::Print) colors.push_back(gray(rank));
        else if (!has_both_signs) colors.push_back(along_one_side(theme.is_dark() ? 1.0 - rank : rank));
        else {
            const double value = 0.5 * (levels[i] + levels[i + 1]) / most;
            colors.push_back(ui::mixed(theme.is_dark() ? dim : pale, value < 0.0 ? cold : warm, std::abs(value)));
        }
    }
    return colors;
}

} // namespace plane
