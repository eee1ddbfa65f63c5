#include "apps/euler/view/draw/name_places.h"

#include "apps/euler/view/shapes/outline.h"

#include <algorithm>

namespace euler {

namespace {

constexpr int n_cells = 9;              // of the grid, a side
constexpr std::size_t most_places = 10; // that are worth a try

struct Place {
    ui::Point at;
    double room;
};

double room_at(std::span<const ui::Point> outline, ui::Point p)
{
    double room = ui::distance(p, outline.front());
    for (std::size_t i = 0; i < outline.size(); ++i)
        room = std::min(room, distance_to_segment(p, outline[i], outline[(i + 1) % outline.size()]));
    return room;
}

} // namespace

NamePlaces places_inside(std::span<const ui::Point> outline)
{
    const ui::Box box = bounds_of(outline);
    std::vector<Place> places;
    for (int i = 1; i < 2 * n_cells; i += 2)
        for (int j = 1; j < 2 * n_cells; j += 2) {
            const ui::Point p{box.min.x + box.width() * j / (2 * n_cells),
                              box.min.y + box.height() * i / (2 * n_cells)};
            if (is_inside(outline, p)) places.push_back({p, room_at(outline, p)});
        }
    if (places.empty()) return {{box.center()}, 0.0};
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.room > b.room; });
    NamePlaces result{{}, places.front().room};
    for (const Place& place : places)
        if (result.all.size() < most_places) result.all.push_back(place.at);
    return result;
}

} // namespace euler
