#include "apps/plane/view/probe_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "femoop/plane/result/triangulated_field.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using ui::Point;
using ui::Role;

constexpr double box_gap = 16.0, box_border = 6.0; // [px]
constexpr double most_hidden = 0.12;               // of the body by a box

fp::PlaneStress stress_at(const fp::PlaneCase& result, const fp::PlaneModel& mesh,
                          const std::vector<fp::Location>& places, fp::StressReading reading)
{
    if (reading != fp::StressReading::Element) return result.smoothed_stress(places.front());
    return result.element_stress(places, mesh[places.front().element].region);
}

/// Where a box may stand beside a place, best first: near it, or where it would hide much of the body beside that.
std::vector<ui::Box> choices_beside(Point at, ui::Size size, const ui::Box& body)
{
    std::vector<ui::Box> near, beside;
    for (const double x : {box_gap, -box_gap - size.width})
        for (const double y : {-box_gap - size.height, box_gap}) near.push_back(ui::box_at(at + Point{x, y}, size));
    const double top = at.y - 0.5 * size.height;
    beside.push_back(ui::box_at({body.max.x + 3.0 * box_gap, top}, size));
    beside.push_back(ui::box_at({body.min.x - 3.0 * box_gap - size.width, top}, size));
    const bool hides_much = size.width * size.height > most_hidden * body.width() * body.height();
    std::vector<ui::Box>& first = hides_much ? beside : near;
    std::vector<ui::Box>& then = hides_much ? near : beside;
    first.insert(first.end(), then.begin(), then.end());
    return first;
}

/// The first of them that lies in the room and on none of the others, moved up or down into it where that is enough.
ui::Box place_beside(const std::vector<ui::Box>& choices, const ui::Box& room, const std::vector<ui::Box>& taken)
{
    const auto into_room = [&](const ui::Box& box) {
        const double y = std::clamp(box.min.y, room.min.y, std::max(room.min.y, room.max.y - box.height()));
        return ui::box_at({box.min.x, y}, box.size());
    };
    for (const ui::Box& choice : choices) {
        const ui::Box box = into_room(choice);
        const auto overlaps = [&](const ui::Box& other) { return other.overlaps(box); };
        if (room.contains(box) && std::ranges::none_of(taken, overlaps)) return box;
    }
    const ui::Box last = into_room(choices.front());
    const double x = std::clamp(last.min.x, room.min.x, std::max(room.min.x, room.max.x - last.width()));
    return ui::box_at({x, last.min.y}, last.size());
}

ui::Box body_on_sheet(const PlateScene& scene)
{
    ui::Box box{{1.0, 1.0}, {0.0, 0.0}};
    for (const OutlinedPiece& piece : scene.outline.pieces)
        for (const Point p : scene.on_sheet(piece.line)) box = box.is_empty() ? ui::Box{p, p} : ui::united(box, {p, p});
    return box;
}

} // namespace

std::vector<std::string> state_lines(const fp::PlaneResults& results, const fp::PlaneCase& result,
                                     const Eigen::Vector2d& at, const PlateOptions& options,
                                     const ui::DisplayUnits& units)
{
    const auto places = results.locator().find(at);
    if (places.empty()) return {};
    const fp::PlaneStress stress = stress_at(result, results.model(), places, options.reading);
    const fp::PrincipalStress principal = fp::principal(stress);
    const double size = std::max({std::abs(principal.s1), std::abs(principal.s2), std::abs(stress.sz)});
    const auto value = [&](const char* name, double v, ui::Measure measure) {
        if (measure == ui::Measure::Stress && std::abs(v) < 1e-9 * size) v = 0.0;
        return std::string(name) + " = " + ui::with_minus_signs(units.text(v, measure));
    };
    const auto number = [&](double v) { return ui::with_minus_signs(units.number(v, ui::Measure::Length)); };
    const char* const comma = options.numbers.mark == ui::DecimalMark::Comma ? "; " : ", ";
    const Eigen::Vector2d u = result.displacement(places.front());
    std::vector<std::string> lines{"(" + number(at.x()) + comma + number(at.y()) + ")"};
    lines.push_back(value("ux", u.x(), ui::Measure::Displacement));
    lines.push_back(value("uy", u.y(), ui::Measure::Displacement));
    lines.push_back(value("σx", stress.sx, ui::Measure::Stress));
    lines.push_back(value("σy", stress.sy, ui::Measure::Stress));
    if (results.model().analysis != femoop::StressState::PlaneStress)
        lines.push_back(value("σz", stress.sz, ui::Measure::Stress));
    lines.push_back(value("τxy", stress.txy, ui::Measure::Stress));
    lines.push_back(value("σ1", principal.s1, ui::Measure::Stress));
    lines.push_back(value("σ2", principal.s2, ui::Measure::Stress));
    lines.push_back(value("θ1", principal.angle * 180.0 / std::numbers::pi, ui::Measure::Angle));
    lines.push_back(value("σ Mises", fp::von_mises(stress), ui::Measure::Stress));
    return lines;
}

void draw_probes(const PlateScene& scene, const ui::Box& room)
{
    if (scene.result == nullptr) return;
    ui::TextStyle style = scene.sketch.theme().text(Role::Label, ui::Anchor::TopLeft);
    style.size = scene.sketch.theme().type().small;
    ui::Painter& painter = scene.sketch.painter();
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    std::vector<ui::Box> taken;
    const ui::Box body = body_on_sheet(scene);
    for (const Eigen::Vector2d& at : scene.options.probes) {
        const auto lines = state_lines(*scene.input.results, *scene.result, at, scene.options, scene.units);
        if (lines.empty()) continue;
        Eigen::Vector2d seen = at;
        if (scene.magnification != 0.0)
            seen += scene.magnification * scene.result->displacement(scene.input.results->locator().find(at).front());
        const Point target = scene.place(seen);
        double width = 0.0;
        for (const std::string& line : lines) width = std::max(width, painter.measure(line, style).width);
        const ui::Size size{width + 2.0 * box_border,
                            1.35 * style.size * static_cast<double>(lines.size()) + 2.0 * box_border};
        const ui::Box box = place_beside(choices_beside(target, size, body), room.grown(-4.0), taken);
        taken.push_back(box);
        scene.sketch.reserve(box);
        painter.line(target, {std::clamp(target.x, box.min.x, box.max.x), std::clamp(target.y, box.min.y, box.max.y)},
                     scene.sketch.theme().stroke(Role::Leader));
        painter.rectangle(box, ui::with_opacity(scene.sketch.theme().background(), 0.92));
        painter.polyline({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}},
                         {.color = scene.sketch.theme().stroke(Role::Dimension).color, .width = 0.8},
                         ui::PathEnds::Closed);
        scene.sketch.disc(target, scene.sketch.px(3.0), scene.sketch.theme().stroke(Role::Edge).color);
        double y = box.min.y + box_border;
        for (const std::string& line : lines) {
            painter.text({box.min.x + box_border, y}, line, style);
            y += 1.35 * style.size;
        }
    }
}

} // namespace plane
