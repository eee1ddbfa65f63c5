#include "apps/plane/view/probe_marks.h"

#include <algorithm>

#include "apps/plane/view/field_picture.h"
#include "apps/plane/view/probe_values.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using ui::Point;
using ui::Role;

constexpr double box_gap = 16.0, box_border = 6.0; // [px]
constexpr double most_hidden = 0.12;               // of the body by a box

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
    const auto state = probe_state(results, result, at);
    if (!state) return {};
    const bool is_on_border = !state->beyond.empty();
    std::vector<std::string> lines{units.place(at.x(), at.y()) + (is_on_border ? " " + state->region : "")};
    const bool is_of_element = options.reading == fp::StressReading::Element;
    for (const ProbeValue& value : state->values) {
        const double shown = is_of_element ? value.element.value_or(value.smoothed) : value.smoothed;
        lines.push_back(value.symbol + " = " + ui::with_minus_signs(units.text(shown, value.measure)));
    }
    for (const ProbeState::Beyond& beyond : state->beyond) lines.push_back(text_of(beyond, units));
    return lines;
}

namespace {

/// "2: σx = 12.3 MPa" of what the colours show, else of von Mises's stress; the number alone where no material is, or there are no results.
std::string short_text(const PlateScene& scene, const Eigen::Vector2d& at, std::size_t n)
{
    if (scene.result == nullptr) return std::to_string(n);
    const auto state = probe_state(*scene.input.results, *scene.result, at);
    if (!state || state->values.empty()) return std::to_string(n);
    const ProbeValue* shown = &state->values.back();
    for (const FieldShow& field : scene.options.show.fields)
        for (const ProbeValue& value : state->values)
            if (value.symbol == symbol_of(field.component)) shown = &value;
    const bool is_of_element = scene.options.reading == fp::StressReading::Element;
    const double value = is_of_element ? shown->element.value_or(shown->smoothed) : shown->smoothed;
    return std::to_string(n) + ": " + shown->symbol + " = " + scene.text(value, shown->measure);
}

/// The mark of a probe; hollow where nothing is to be read. Where one has a panel, with its number and one value.
void draw_probe(const PlateScene& scene, Point at, std::size_t n, bool has_state)
{
    const ui::Color ink = scene.sketch.theme().stroke(Role::Edge).color;
    const ui::Color ground = scene.sketch.theme().background();
    scene.sketch.disc(at, scene.sketch.px(5.5), ground);
    scene.sketch.ring(at, scene.sketch.px(5.5), scene.sketch.thin(Role::Edge));
    if (has_state) scene.sketch.disc(at, scene.sketch.px(2.5), ink);
    if (!scene.options.circle) return;
    scene.sketch.caption({.text = short_text(scene, scene.options.probes[n - 1], n),
                          .target = at,
                          .gap = scene.sketch.px(9.0),
                          .rank = drawing::Rank::Extreme,
                          .weight = ui::Weight::Bold});
}

} // namespace

void draw_probes(const PlateScene& scene, const ui::Box& room)
{
    ui::TextStyle style = scene.sketch.theme().text(Role::Label, ui::Anchor::TopLeft);
    style.size = scene.sketch.theme().type().small;
    ui::Painter& painter = scene.sketch.painter();
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    std::vector<ui::Box> taken;
    const ui::Box body = body_on_sheet(scene);
    for (std::size_t i = 0; i < scene.options.probes.size(); ++i) {
        const Eigen::Vector2d& at = scene.options.probes[i];
        std::vector<std::string> lines;
        if (scene.result != nullptr)
            lines = state_lines(*scene.input.results, *scene.result, at, scene.options, scene.units);
        if (lines.empty()) {
            draw_probe(scene, scene.place(at), i + 1, false);
            continue;
        }
        Eigen::Vector2d seen = at;
        if (scene.magnification != 0.0)
            seen += scene.magnification * scene.result->displacement(scene.input.results->locator().find(at).front());
        const Point target = scene.place(seen);
        if (scene.options.circle) { // all values of one of them stand in a panel
            draw_probe(scene, target, i + 1, true);
            continue;
        }
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
