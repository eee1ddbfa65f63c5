#include "apps/euler/view/shapes/name_places.h"

#include <algorithm>

namespace euler {

namespace {

constexpr int n_cells = 9;              // of the grid, a side
constexpr std::size_t most_places = 10; // that are worth a try

struct Place {
    ui::Point at;
    double room;
};

double room_at(const Region& area, ui::Point p)
{
    double room = ui::distance(p, area.front().front());
    for_each_side(area, [&](ui::Point a, ui::Point b) { room = std::min(room, distance_to_segment(p, a, b)); });
    return room;
}

} // namespace

NamePlaces places_inside(const Region& area)
{
    const ui::Box box = bounds_of(area);
    std::vector<Place> places;
    for (int i = 1; i < 2 * n_cells; i += 2)
        for (int j = 1; j < 2 * n_cells; j += 2) {
            const ui::Point p{box.min.x + box.width() * j / (2 * n_cells),
                              box.min.y + box.height() * i / (2 * n_cells)};
            if (is_inside(area, p)) places.push_back({p, room_at(area, p)});
        }
    if (places.empty()) return {{box.center()}, 0.0};
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.room > b.room; });
    NamePlaces result{{}, places.front().room};
    for (const Place& place : places)
        if (result.all.size() < most_places) result.all.push_back(place.at);
    return result;
}

} // namespace euler
