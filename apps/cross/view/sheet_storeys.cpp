#include "apps/cross/view/sheet_storeys.h"

#include <algorithm>
#include <numeric>

#include "apps/cross/view/block_layout.h"

namespace cross {

namespace {

double gap(const StoreyNeeds& needs) { return column_gap * needs.type; }

double column_height(const StoreyNeeds& needs)
{
    return needs.type * (head_height + line_height * static_cast<double>(needs.n_lines) + total_height);
}

std::vector<double> levels_of(const drawing::StructureShape& shape)
{
    std::vector<double> levels;
    for (const Eigen::Vector3d& node : shape.nodes) levels.push_back(node.y());
    std::ranges::sort(levels);
    const double least = levels.empty() ? 0.0 : 1e-9 * (levels.back() - levels.front());
    const auto are_one = [least](double a, double b) { return b - a <= least; };
    levels.erase(std::unique(levels.begin(), levels.end(), are_one), levels.end());
    return levels;
}

/// From the lowest storey up. Under a beam whose columns stand above it those of a storey's two ends stand side by side;
/// a foot has no factor.
std::vector<double> heights_needed(std::size_t n_storeys, const StoreyNeeds& needs)
{
    constexpr double line = 4.0; // [px] that members take
    const double column = column_height(needs), between = gap(needs);
    const double one = column + 2.0 * between + line, two = 2.0 * column + 2.0 * between + line;
    std::vector<double> heights(n_storeys, two);
    heights.front() -= (head_height - bare_head_height) * needs.type;
    if (needs.top == TopColumns::Above && n_storeys > 1) heights.back() = one;
    return heights;
}

} // namespace

BayScale storeys_to_scale(const drawing::StructureShape& shape)
{
    const std::vector<double> levels = levels_of(shape);
    return {levels, levels};
}

SheetRoom tight_room(const StoreyNeeds& needs, const ui::Theme& theme)
{
    constexpr double border = 0.35, heading = 3.2, support = 1.5; // ems: two lines
    const double em = theme.type().normal;
    const double above = needs.top == TopColumns::Above ? (column_height(needs) + gap(needs)) / em : 0.6;
    return {.beside = border + (needs.width + gap(needs)) / em, .above = heading + above, .below = support};
}

BayScale storey_scale_for(const drawing::StructureShape& shape, const Panel& sheet, const StoreyNeeds& needs)
{
    const std::vector<double> levels = levels_of(shape);
    if (levels.size() < 2) return {};
    const double scale = sheet.stretch * sheet.camera.scale(), total = scale * (levels.back() - levels.front());
    const std::vector<double> needed = heights_needed(levels.size() - 1, needs);
    if (std::accumulate(needed.begin(), needed.end(), 0.0) > total) return {};
    std::vector<double> natural, drawn{levels.front()};
    for (std::size_t i = 1; i < levels.size(); ++i) natural.push_back(scale * (levels[i] - levels[i - 1]));
    for (const double height : breadths(natural, needed, total)) drawn.push_back(drawn.back() + height / scale);
    return {levels, std::move(drawn)};
}

} // namespace cross
