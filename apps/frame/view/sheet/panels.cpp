#include "apps/frame/view/sheet/panels.h"

#include <algorithm>
#include <array>

namespace frame {

namespace {

constexpr std::array results{Show::N, Show::V,  Show::Vy, Show::Vz,      Show::M,
                             Show::T, Show::My, Show::Mz, Show::Deformed};

// Room that a panel needs around the structure, in logical pixels: legend, loads, supports, diagrams.
constexpr double border_x = 170.0;
constexpr double border_y = 200.0;

std::vector<ShowSet> contents(const PanelRequest& request)
{
    std::vector<Show> shown;
    for (const Show item : results)
        if (request.show.contains(item)) shown.push_back(item);
    ShowSet base = request.show;
    for (const Show item : results) base.erase(item);
    const bool shows_forces = base.contains(Show::Loads) || base.contains(Show::Reactions);
    const std::size_t n_panels = shown.size() + (shows_forces ? 1 : 0);
    if (!request.has_results || shown.empty() || n_panels < 2 || request.layout == Layout::Overlay)
        return {request.show};
    std::vector<ShowSet> sets;
    if (shows_forces) sets.push_back(base);
    ShowSet plain = base;
    for (const Show item : {Show::Loads, Show::Reactions, Show::Dimensions, Show::LocalAxes, Show::MemberNames})
        plain.erase(item);
    for (const Show item : shown) {
        ShowSet set = plain;
        set.insert(item);
        sets.push_back(set);
    }
    return sets;
}

// Logical pixels that the structure's width would get.
double width_in(ui::Size panel, const PanelRequest& request)
{
    const double width = std::max(10.0, panel.width - request.border * border_x);
    const double height = std::max(10.0, panel.height - request.border * border_y);
    return std::min(width, height * request.aspect);
}

std::size_t best_columns(std::size_t n, const PanelRequest& request)
{
    const ui::Size area = request.area.size();
    std::size_t best = 1;
    double widest = -1.0;
    for (std::size_t columns = 1; columns <= n; ++columns) {
        const std::size_t rows = (n + columns - 1) / columns;
        const ui::Size panel{area.width / static_cast<double>(columns), area.height / static_cast<double>(rows)};
        const double width = width_in(panel, request);
        // Columns are added only where they make the picture clearly larger.
        if (width > 1.02 * widest) {
            widest = width;
            best = columns;
        }
    }
    return best;
}

} // namespace

std::vector<Panel> panels(const PanelRequest& request)
{
    const std::vector<ShowSet> sets = contents(request);
    const std::size_t columns = best_columns(sets.size(), request);
    const std::size_t rows = (sets.size() + columns - 1) / columns;
    const ui::Size size{request.area.width() / static_cast<double>(columns),
                        request.area.height() / static_cast<double>(rows)};
    std::vector<Panel> list;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const ui::Point corner{request.area.min.x + static_cast<double>(i % columns) * size.width,
                               request.area.min.y + static_cast<double>(i / columns) * size.height};
        list.push_back({ui::box_at(corner, size), sets[i]});
    }
    return list;
}

} // namespace frame
