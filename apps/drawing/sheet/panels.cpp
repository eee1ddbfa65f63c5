#include "apps/drawing/sheet/panels.h"

#include <algorithm>
#include <array>

namespace drawing {

namespace {

constexpr std::array results{Show::Influence, Show::N,  Show::V,  Show::Vy,       Show::Vz,    Show::M,
                             Show::T,         Show::My, Show::Mz, Show::Deformed, Show::Thrust};

/// The structure, and beside it a diagram of forces that says the rest.
std::vector<ShowSet> with_diagram(ShowSet structure, Show diagram)
{
    for (const Show item : results) structure.erase(item);
    for (const Show item : {Show::Reactions, diagram}) structure.erase(item);
    return {structure, (structure & ShowSet{Show::Values, Show::Legend}) | ShowSet{diagram}};
}

/// The truss with its names draws its forces itself.
std::vector<ShowSet> truss_contents(ShowSet show)
{
    show.erase(Show::Loads);
    return with_diagram(show, Show::Truss);
}

/// The same diagram of both loads, to be compared place by place.
std::vector<ShowSet> unit_load_contents(ShowSet show)
{
    ShowSet under_loads = show;
    under_loads.erase(Show::UnitLoad);
    return {under_loads, show};
}

} // namespace

std::vector<ShowSet> panel_contents(const PanelRequest& request)
{
    if (request.show.contains(Show::Truss)) return truss_contents(request.show);
    if (request.show.contains(Show::ForcePolygon)) return with_diagram(request.show, Show::ForcePolygon);
    if (request.show.contains(Show::UnitLoad)) return unit_load_contents(request.show);
    std::vector<Show> shown;
    for (const Show item : results)
        if (request.show.contains(item)) shown.push_back(item);
    ShowSet base = request.show;
    for (const Show item : results) base.erase(item);
    const bool shows_forces = base.contains(Show::Loads) || base.contains(Show::Reactions);
    const bool is_apart = shows_forces && request.layout != Layout::LoadsOnFirst;
    const std::size_t n_panels = shown.size() + (is_apart ? 1 : 0);
    if (!request.has_results || shown.empty() || n_panels < 2 || request.layout == Layout::Overlay)
        return {request.show};
    std::vector<ShowSet> sets;
    if (is_apart) sets.push_back(base);
    ShowSet plain = base;
    for (const Show item :
         {Show::Loads, Show::Reactions, Show::Dimensions, Show::LocalAxes, Show::MemberNames, Show::NodeNumbers})
        plain.erase(item);
    if (shows_forces) plain.erase(Show::Counting);
    for (const Show item : shown) {
        ShowSet set = sets.empty() && request.layout == Layout::LoadsOnFirst ? base : plain;
        set.insert(item);
        sets.push_back(set);
    }
    if (request.show.contains(Show::NodeNumbers)) sets.front().insert(Show::NodeNumbers);
    return sets;
}

std::vector<Panel> panels(const std::vector<ShowSet>& contents, const ui::Box& area, std::size_t columns)
{
    const std::size_t rows = (contents.size() + columns - 1) / columns;
    const ui::Size size{area.width() / static_cast<double>(columns), area.height() / static_cast<double>(rows)};
    std::vector<Panel> list;
    for (std::size_t i = 0; i < contents.size(); ++i) {
        const std::size_t row = i / columns, column = i % columns;
        const ui::Point corner{area.min.x + static_cast<double>(column) * size.width,
                               area.min.y + static_cast<double>(row) * size.height};
        list.push_back({ui::box_at(corner, size), contents[i]});
    }
    return list;
}

} // namespace drawing
