#include "apps/cross/view/sheet_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "ui/paint/text_measure.h"
#include "ui/paint/wrapped_lines.h"
#include "ui/text/shortened.h"

namespace cross {

namespace {

constexpr double support_breadth = 0.8; // half the breadth of a support, of its reach

/// A chain of small boxes along a member.
void cover(const Panel& panel, const drawing::MemberShape& member, std::vector<ui::Box>& taken)
{
    const ui::Point a = panel.at(member.start_node), b = panel.at(member.end_node);
    const int n = std::max(1, static_cast<int>(ui::distance(a, b) / 6.0));
    const bool is_along_axis = std::abs(a.x - b.x) < 1.0 || std::abs(a.y - b.y) < 1.0;
    for (int i = 0; i < (is_along_axis ? 1 : n); ++i) {
        const ui::Point p = a + (static_cast<double>(i) / n) * (b - a);
        const ui::Point q = is_along_axis ? b : a + (static_cast<double>(i + 1) / n) * (b - a);
        taken.push_back(ui::united({p, p}, {q, q}).grown(2.0));
    }
}

} // namespace

namespace {

/// Of a joint whose columns stand on the other side than its neighbours'.
BeamSide side_in_turn(const drawing::StructureShape& shape, femoop::NodeId node)
{
    constexpr double one_place = 1e-6;
    std::vector<double> before;
    for (const Eigen::Vector3d& other : shape.nodes)
        if (other.x() < shape[node].x() - one_place) before.push_back(other.x());
    std::ranges::sort(before);
    const auto are_one = [](double a, double b) { return b - a <= one_place; };
    before.erase(std::unique(before.begin(), before.end(), are_one), before.end());
    return before.size() % 2 == 1 ? BeamSide::Below : BeamSide::Above;
}

} // namespace

double support_reach(const ui::Theme& theme) { return support_breadth * 15.0 * theme.symbol_scale(); }

EndPlace place_of_end(const Panel& panel, const drawing::StructureShape& shape, const femoop::cross::Problem& problem,
                      femoop::cross::EndId id, const ui::Theme& theme)
{
    const femoop::cross::End& end = problem[id];
    const ui::Point joint = panel.at(shape[end.node]);
    const BeamSide side = panel.columns == BeamColumns::InTurn ? side_in_turn(shape, end.node) : BeamSide::Either;
    if (!end.member) return {.end = id, .joint = joint, .along = {0.0, 1.0}, .length = 4.0 * theme.type().normal};
    const drawing::MemberShape& member = shape[*end.member];
    const ui::Point a = panel.at(member.start_node), b = panel.at(member.end_node);
    const ui::Point along = end.which == 0 ? ui::direction(b - a) : ui::direction(a - b);
    return {.end = id, .joint = joint, .along = along, .length = ui::distance(a, b), .side = side};
}

std::vector<ui::Box> walls_in(const Panel& panel, const drawing::StructureShape& shape)
{
    std::vector<ui::Box> taken;
    for (const drawing::MemberShape& member : shape.members) cover(panel, member, taken);
    return taken;
}

std::vector<ui::Box> obstacles_in(const Panel& panel, const drawing::StructureShape& shape, const femoop::Model& model,
                                  const ui::Theme& theme)
{
    std::vector<ui::Box> taken = walls_in(panel, shape);
    const double reach = support_reach(theme) / support_breadth;
    for (std::size_t n = 0; n < shape.nodes.size(); ++n) {
        const ui::Point at = panel.at(shape.nodes[n]);
        const bool has_support = model.nodes[n].support.has_value();
        const double below = has_support ? 2.0 * reach : 0.4 * reach,
                     side = has_support ? support_breadth * reach : 0.4 * reach;
        taken.push_back({at + ui::Point{-side, -0.4 * reach}, at + ui::Point{side, below}});
    }
    return taken;
}

ui::Point middle_of(const Panel& panel, const drawing::StructureShape& shape)
{
    ui::Box around{panel.at(shape.nodes.front()), panel.at(shape.nodes.front())};
    for (const auto& node : shape.nodes) around = ui::united(around, {panel.at(node), panel.at(node)});
    return around.center();
}

std::string head_within(const ui::Painter& painter, const femoop::Model& model, const femoop::cross::End& end,
                        const ui::TextStyle& style, double width)
{
    constexpr std::size_t most = 16, fewest = 2; // letters of a name
    const auto is_within = [&](const std::string& text) { return painter.measure(text, style).width <= width; };
    std::string head = end.label;
    for (std::size_t n = most; n >= fewest && !is_within(head); --n) {
        head = ui::shortened(model[end.node].id, n);
        if (!end.member) continue;
        const auto& nodes = model[*end.member].nodes;
        head += "-" + ui::shortened(model[nodes[1 - end.which]].id, n);
    }
    return head;
}

ui::Box sight_below(const ui::Box& title, const Panel& panel, const ui::Theme& theme)
{
    ui::Box sight = panel.box.grown(-0.5 * theme.type().normal);
    sight.min.y = std::max(sight.min.y + 1.5 * theme.type().normal, title.max.y);
    return sight;
}

std::optional<ui::Point> way_into_sight(const ui::Box& box, const ui::Box& sight)
{
    const auto way = [](double low, double high, double least, double most) {
        return low < least ? least - low : std::min(0.0, std::max(most - high, least - low));
    };
    const ui::Point by{way(box.min.x, box.max.x, sight.min.x, sight.max.x),
                       way(box.min.y, box.max.y, sight.min.y, sight.max.y)};
    return ui::distance({}, by) > 0.0 ? std::optional(by) : std::nullopt;
}

namespace {

struct NoteBelow {
    struct Line {
        ui::Point at; // its lower right
        std::string words;
    };
    ui::TextStyle style;
    std::vector<Line> lines; // the last one first
};

NoteBelow note_below(const ui::Painter& painter, const Panel& panel, const ui::Theme& theme, const std::string& words)
{
    NoteBelow note{.style = theme.text(ui::Role::Warning, ui::Anchor::BottomRight)};
    const double size = theme.type().small;
    note.style.size = size;
    note.style.plate = theme.background();
    ui::Point at = panel.box.max - ui::Point{0.5 * size, 0.5 * size};
    const auto lines = ui::wrapped_lines(painter.fonts(), words, note.style, 0.96 * panel.box.width());
    for (auto line = lines.rbegin(); line != lines.rend(); ++line, at.y -= 1.2 * size)
        note.lines.push_back({at, *line});
    return note;
}

} // namespace

ui::Box box_below(const ui::Painter& painter, const Panel& panel, const ui::Theme& theme, const std::string& words)
{
    const NoteBelow note = note_below(painter, panel, theme, words);
    ui::Box box{note.lines.front().at, note.lines.front().at};
    for (const auto& [at, line] : note.lines)
        box = ui::united(box, ui::text_box(painter.fonts(), at, line, note.style));
    return box;
}

void write_below(ui::Painter& painter, const Panel& panel, const ui::Theme& theme, const std::string& words)
{
    const NoteBelow note = note_below(painter, panel, theme, words);
    for (const auto& [at, line] : note.lines) painter.text(at, line, note.style);
}

} // namespace cross
