#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "apps/mohr/view/circle_picture.h"
#include "apps/mohr/view/construction_picture.h"
#include "apps/mohr/view/curves_picture.h"
#include "apps/mohr/view/element_picture.h"
#include "apps/mohr/view/locus_picture.h"
#include "apps/mohr/view/scene.h"
#include "apps/mohr/view/section_picture.h"
#include "apps/mohr/view/space_picture.h"

namespace mohr {

namespace fm = femoop::mohr;

namespace {

/// The circles' extent, with the origin where that is not far.
void fit_normals(Frame& frame, double low, double high)
{
    const double size = std::max({high - low, 1e-3 * std::max(std::abs(low), std::abs(high)), 1e-100});
    frame.low = low;
    frame.high = high;
    if (low > 0.0 && low < 3.0 * size) frame.low = 0.0;
    if (high < 0.0 && high > -3.0 * size) frame.high = 0.0;
    if (high - low < 0.2 * size || high == low) { // a point
        const double about = std::max(std::abs(high), 1e-100);
        frame.low = std::min(0.0, low - 0.3 * about);
        frame.high = std::max(0.0, high + 0.3 * about);
    }
}

/// The circle under the rule that is set, and beside it under the other one, which no hand takes hold of.
void draw_both_rules(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn)
{
    const double middle = box.center().x, half = 8.0;
    draw_circle(painter, scene, {box.min, {middle - half, box.max.y}}, drawn);
    Solution other = scene.solution;
    other.rule = scene.solution.rule == fm::ShearRule::ClockwiseUp ? fm::ShearRule::TensorDown
                                                                   : fm::ShearRule::ClockwiseUp;
    const Scene beside{scene.document, other, scene.look, scene.frame, scene.eye};
    Drawn not_held;
    draw_circle(painter, beside, {{middle + half, box.min.y}, box.max}, not_held);
}

bool shows_both_rules(const Scene& scene)
{
    return scene.look.both_rules && !scene.steps_shown && scene.document.subject != Subject::Inertia;
}

constexpr double gap = 10.0; ///< between the pictures

ui::Box without_gap(const ui::Box& box)
{
    return {box.min + ui::Point{gap, 0.5 * gap}, box.max - ui::Point{gap, 0.5 * gap}};
}

/// Where the pictures of a plane state stand: side by side, or one below another on a sheet that is high.
struct PlaneRooms {
    ui::Box element, circle;
    std::optional<ui::Box> below{}; ///< of the curves or the section
    std::optional<ui::Box> locus{};
};

/// What stands below is left out where it would tell an answer, and where large type and a construction's caption leave
/// little for the circle.
bool has_below(const Scene& scene)
{
    return !scene.conceals && !(scene.steps_shown && scene.look.theme == ui::ThemeName::Projector);
}

/// Curves and a section are flat in less height, and a locus is hardly more than its words. [em]
constexpr double least_below = 7.5, flattest_below = 6.0, least_locus = 11.0;

double em(const Scene& scene) { return scene.look.full_theme().type().normal; }

/// The locus stands at the end of the row of the curves, where that is high enough for it.
bool shares_row(PlaneRooms& rooms, const Scene& scene)
{
    const ui::Box row = *rooms.below;
    if (row.height() < least_locus * em(scene)) return false;
    const double right_of_curves = row.min.x + 0.66 * row.width();
    rooms.below = ui::Box{row.min, {right_of_curves, row.max.y}};
    rooms.locus = ui::Box{{right_of_curves + gap, row.min.y}, row.max};
    return true;
}

/// One below another; a locus that has no room in the row of the curves stands beside the element.
PlaneRooms rooms_of_high_sheet(const ui::Size& sheet, const Scene& scene)
{
    const double w = sheet.width, h = sheet.height;
    const bool is_whole = !has_below(scene), is_projected = scene.look.theme == ui::ThemeName::Projector;
    const double middle = (is_whole ? 0.4 : is_projected ? 0.31 : 0.36) * h, foot = (is_whole ? 1.0 : 0.78) * h;
    PlaneRooms rooms{without_gap({{0.0, 0.0}, {w, middle}}), without_gap({{0.0, middle}, {w, foot}})};
    if (is_whole) return rooms;
    rooms.below = without_gap({{0.0, foot}, {w, h}});
    if (!has_locus(scene) || shares_row(rooms, scene)) return rooms;
    const double beside = 0.6 * w;
    rooms.element = without_gap({{0.0, 0.0}, {beside, middle}});
    rooms.locus = without_gap({{beside, 0.0}, {w, middle}});
    return rooms;
}

/// What would be small in a row of that height below the circle stands below the element: the locus, else the curves.
/// Curves that are flat are left out beside the locus.
PlaneRooms rooms_of_flat_row(const ui::Size& sheet, double middle, double foot, const Scene& scene)
{
    const double top = 0.5 * gap, bottom = sheet.height - 0.5 * gap, below_element = 0.58 * sheet.height;
    PlaneRooms rooms{without_gap({{0.0, top}, {middle, below_element}}),
                     without_gap({{middle, top}, {sheet.width, bottom}})};
    const ui::Box corner = without_gap({{0.0, below_element}, {middle, bottom}});
    if (!has_locus(scene)) {
        rooms.below = corner;
        return rooms;
    }
    rooms.locus = corner;
    const ui::Box below_circle = without_gap({{middle, foot}, {sheet.width, bottom}});
    if (below_circle.height() < least_below * em(scene)) return rooms;
    rooms.circle.max.y = foot - 0.5 * gap;
    rooms.below = below_circle;
    return rooms;
}

/// Down to where the circle has room. Two circles side by side are narrow, and leave height for what stands below.
double foot_of_circle(double height, const Scene& scene)
{
    if (!has_below(scene)) return height;
    const bool is_projected = scene.look.theme == ui::ThemeName::Projector; // large type takes room from the circle
    const double most = std::max(0.70 * height, height - flattest_below * em(scene));
    const double foot = is_projected ? std::min(0.78 * height, most) : 0.70 * height;
    return shows_both_rules(scene) ? std::min(foot, height - least_below * em(scene) - gap) : foot;
}

PlaneRooms rooms_of_wide_sheet(const ui::Size& sheet, const Scene& scene)
{
    constexpr double least_width = 15.0; // em: for curves or a section below the element
    const double beside_two_circles = scene.look.theme == ui::ThemeName::Projector ? 0.31 : 0.28;
    const double middle = (shows_both_rules(scene) ? beside_two_circles : 0.42) * sheet.width,
                 foot = foot_of_circle(sheet.height, scene) + 0.5 * gap;
    PlaneRooms rooms{without_gap({{0.0, 0.5 * gap}, {middle, foot}}),
                     without_gap({{middle, 0.5 * gap}, {sheet.width, foot}})};
    if (!has_below(scene)) return rooms;
    rooms.below = without_gap({{0.0, foot}, {sheet.width, sheet.height - 0.5 * gap}});
    const bool is_flat = rooms.below->height() < least_below * em(scene) &&
                         rooms.element.width() > least_width * em(scene);
    const bool has_room = has_locus(scene) ? shares_row(rooms, scene) : !is_flat;
    return has_room ? rooms : rooms_of_flat_row(sheet, middle, foot, scene);
}

void draw_plane(ui::Painter& painter, const Scene& scene, Drawn& drawn)
{
    const ui::Size sheet{painter.sheet().width(), painter.sheet().height()};
    const bool is_high = sheet.width < 0.8 * sheet.height;
    const PlaneRooms rooms = is_high ? rooms_of_high_sheet(sheet, scene) : rooms_of_wide_sheet(sheet, scene);
    draw_element(painter, scene, rooms.element, drawn);
    if (scene.steps_shown) draw_construction(painter, scene, rooms.circle, drawn);
    else if (shows_both_rules(scene)) draw_both_rules(painter, scene, rooms.circle, drawn);
    else draw_circle(painter, scene, rooms.circle, drawn);
    if (rooms.below && scene.solution.section) draw_section(painter, scene, *rooms.below, drawn);
    else if (rooms.below) draw_curves(painter, scene, *rooms.below, drawn);
    if (rooms.locus) draw_locus(painter, scene, *rooms.locus);
}

/// Cube, sphere and perhaps a criterion below one another at the left, or side by side on top of a sheet that is high.
void draw_space(ui::Painter& painter, const Scene& scene, Drawn& drawn)
{
    const double w = painter.sheet().width(), h = painter.sheet().height();
    const double n = has_locus(scene) ? 3.0 : 2.0;
    const bool is_high = w < 0.8 * h;
    const double middle = is_high ? 0.33 * h : 0.38 * w;
    const auto room = [&](double i) {
        if (is_high) return without_gap({{w * i / n, 0.0}, {w * (i + 1.0) / n, middle}});
        return without_gap({{0.0, h * i / n}, {middle, h * (i + 1.0) / n}});
    };
    draw_cube(painter, scene, room(0.0), drawn);
    draw_sphere(painter, scene, room(1.0), drawn);
    if (has_locus(scene)) draw_locus(painter, scene, room(2.0));
    const ui::Box right = is_high ? without_gap({{0.0, middle}, {w, h}})
                                  : without_gap({{middle, 0.5 * gap}, {w, h - 0.5 * gap}});
    if (scene.steps_shown) draw_construction(painter, scene, right, drawn);
    else draw_three_circles(painter, scene, right, drawn);
}

} // namespace

Frame fitting_frame(const Document& document, const Solution& s, Content content)
{
    Frame frame;
    const bool is_space = is_in_space(document.subject);
    const auto& v = s.space_principal.values;
    double low = is_space ? v[2] : s.principal.second, high = is_space ? v[0] : s.principal.first;
    frame.largest = std::max({std::abs(low), std::abs(high), std::numeric_limits<double>::min()});
    const bool has_all = content == Content::All;
    if (has_all && s.safety && s.safety->factor && fm::is_stress(s.state.kind)) { // the circle at failure, if not far
        const double k = std::clamp(*s.safety->factor, 0.3, 2.5);
        low = std::min(low, k * v[2]);
        high = std::max(high, k * v[0]);
    }
    for (const fm::PlaneState& state : has_all ? s.path : fm::LoadingPath()) {
        low = std::min(low, fm::principal(state).second);
        high = std::max(high, fm::principal(state).first);
    }
    fit_normals(frame, low, high);
    frame.reach = std::max(0.5 * (high - low), 0.2 * (frame.high - frame.low));
    return frame;
}

Drawn draw(ui::Painter& painter, const Scene& scene)
{
    Drawn drawn;
    constexpr double least = 160.0; // px: there is room for no picture in less
    if (painter.size().width < least || painter.size().height < least) return drawn;
    if (is_in_space(scene.document.subject)) draw_space(painter, scene, drawn);
    else draw_plane(painter, scene, drawn);
    return drawn;
}

std::optional<Handle> pick(const Drawn& drawn, ui::Point at, double reach)
{
    std::optional<Handle> found;
    double nearest = reach;
    for (const Place& place : drawn.places) {
        const double distance = ui::distance(place.at, at);
        if (distance >= nearest) continue;
        nearest = distance;
        found = place.handle;
    }
    return found;
}

} // namespace mohr
