#include "apps/plane/view/singular_notice.h"

#include <algorithm>
#include <vector>

#include "apps/plane/discretize/singular_corners.h"
#include "apps/plane/view/plate_scene.h"

namespace plane {

namespace {

constexpr std::size_t most_corners = 3; // that are named

std::string place_of(const discretize::SingularCorner& corner, const ui::DisplayUnits& units)
{
    return ui::with_minus_signs(units.place(corner.at.x, corner.at.y));
}

std::string and_more(std::size_t n_corners, const ui::Catalogue& tr)
{
    if (n_corners <= most_corners) return "";
    return " " + tr("and {n} more", {{"n", std::to_string(n_corners - most_corners)}});
}

} // namespace

std::optional<std::string> singular_notice(const discretize::Drawing& drawing, const PlateOptions& options)
{
    const std::vector<discretize::SingularCorner> corners = singular_corners(drawing);
    if (corners.empty()) return std::nullopt;
    const ui::Catalogue& tr = options.tr;
    const ui::DisplayUnits units = display_units(drawing.model(), options);
    std::string places;
    for (std::size_t i = 0; i < std::min(most_corners, corners.size()); ++i) {
        const std::string degrees = ui::number_text(corners[i].angle, {.digits = 4, .mark = options.numbers.mark});
        places += (i > 0 ? ", " : "") +
                  tr("{place} with {angle}° of material", {{"place", place_of(corners[i], units)}, {"angle", degrees}});
    }
    return tr("stresses grow without bound, the more the finer the mesh, at the re-entrant corner {places}; a fillet "
              "bounds them",
              {{"places", places + and_more(corners.size(), tr)}});
}

std::optional<std::string> singular_note(const discretize::Drawing& drawing, const PlateOptions& options)
{
    const std::vector<discretize::SingularCorner> corners = singular_corners(drawing);
    if (corners.empty()) return std::nullopt;
    const ui::DisplayUnits units = display_units(drawing.model(), options);
    std::string places;
    for (std::size_t i = 0; i < std::min(most_corners, corners.size()); ++i)
        places += (i > 0 ? ", " : "") + place_of(corners[i], units);
    return options.tr("grows with the mesh at {places}", {{"places", places + and_more(corners.size(), options.tr)}});
}

bool shows_stresses(const PlateOptions& options)
{
    const PlateShown& show = options.show;
    return show.set.contains(PlateShow::Principal) || show.set.contains(PlateShow::Trajectories) ||
           std::ranges::any_of(show.fields, [](const FieldShow& field) {
               return field.component != femoop::plane::PlaneComponent::ux &&
                      field.component != femoop::plane::PlaneComponent::uy;
           });
}

} // namespace plane
