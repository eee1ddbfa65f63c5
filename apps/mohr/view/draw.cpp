#include <algorithm>
#include <cmath>
#include <limits>

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
    ui::Box row; ///< of the curves or the section, and the locus
};

/// What stands below is left out where it would tell an answer, and where large type and a construction's caption leave
/// little for the circle.
bool has_row(const Scene& scene)
{
    return !scene.conceals && !(scene.steps_shown && scene.look.theme == ui::ThemeName::Projector);
}

/// What stands below is flat there, and alone it has the width for another place: below the element.
bool is_flat(const PlaneRooms& rooms, const Scene& scene)
{
    constexpr double least_height = 7.5, least_width = 15.0;
    const double em = scene.look.full_theme().type().normal;
    return !has_locus(scene) && rooms.row.height() < least_height * em && rooms.element.width() > least_width * em;
}

/// The circle has the whole height, and what else would lie flat below it stands below the element.
PlaneRooms rooms_of_large_type(const ui::Size& sheet, double middle)
{
    const double top = 0.5 * gap, foot = sheet.height - 0.5 * gap, below = 0.58 * sheet.height;
    return {without_gap({{0.0, top}, {middle, below}}), without_gap({{middle, top}, {sheet.width, foot}}),
            without_gap({{0.0, below}, {middle, foot}})};
}

PlaneRooms plane_rooms(const ui::Box& sheet, const Scene& scene)
{
    const double w = sheet.width(), h = sheet.height();
    const bool is_whole = !has_row(scene);
    const bool is_projected = scene.look.theme == ui::ThemeName::Projector; // large type takes room from the circle
    const double foot = is_whole ? 1.0 : is_projected ? 0.78 : 0.70;
    if (w < 0.8 * h) {
        const double below = is_whole ? 1.0 : 0.78, middle = is_whole ? 0.4 : 0.36;
        return {without_gap({{0.0, 0.0}, {w, middle * h}}), without_gap({{0.0, middle * h}, {w, below * h}}),
                without_gap({{0.0, below * h}, {w, h}})};
    }
    const double middle = (shows_both_rules(scene) ? 0.28 : 0.42) * w;
    const PlaneRooms rooms{without_gap({{0.0, 0.5 * gap}, {middle, foot * h + 0.5 * gap}}),
                           without_gap({{middle, 0.5 * gap}, {w, foot * h + 0.5 * gap}}),
                           without_gap({{0.0, foot * h + 0.5 * gap}, {w, h - 0.5 * gap}})};
    return is_whole || !is_flat(rooms, scene) ? rooms : rooms_of_large_type({w, h}, middle);
}

void draw_plane(ui::Painter& painter, const Scene& scene, Drawn& drawn)
{
    const PlaneRooms rooms = plane_rooms(painter.sheet(), scene);
    draw_element(painter, scene, rooms.element, drawn);
    if (scene.steps_shown) draw_construction(painter, scene, rooms.circle, drawn);
    else if (shows_both_rules(scene)) draw_both_rules(painter, scene, rooms.circle, drawn);
    else draw_circle(painter, scene, rooms.circle, drawn);
    const ui::Box& row = rooms.row;
    if (!has_row(scene)) return;
    if (scene.solution.section) return draw_section(painter, scene, row, drawn);
    const double right_of_curves = has_locus(scene) ? row.min.x + 0.66 * row.width() : row.max.x;
    draw_curves(painter, scene, {row.min, {right_of_curves, row.max.y}}, drawn);
    if (has_locus(scene)) draw_locus(painter, scene, {{right_of_curves + gap, row.min.y}, row.max});
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
