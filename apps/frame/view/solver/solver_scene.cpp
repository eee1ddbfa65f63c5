#include "apps/frame/view/solver/solver_scene.h"

#include <algorithm>

#include "femoop/solver/index.h"
#include "ui/paint/wrapped_lines.h"
#include "ui/text/shortened.h"

namespace frame {

using femoop::EliminationWalk;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

constexpr std::size_t most_names = 8, most_letters = 12;

ui::Box square_at(Point center, double half) { return ui::Box{center, center}.grown(half); }

} // namespace

SolverScene::SolverScene(ui::Painter& painter, const femoop::SolverTrace& trace, const SolverLook& look)
    : painter_(painter),
      trace_(trace),
      look_(look),
      walk_(trace.walk(look.ordering)),
      step_(std::min(look.step, walk_.fronts.size() - 1)),
      states_(trace.blocks.size(), BlockState::Held)
{
    for (const std::int32_t block : walk_.order) states_[femoop::at(block)] = BlockState::Untouched;
    for (std::size_t f = 0; f < step_; ++f)
        for (const EliminationWalk::Entry& entry : walk_.left(walk_.fronts[f]))
            states_[femoop::at(block_at(entry.row))] = BlockState::Waiting;
    for (const EliminationWalk::Entry& entry : walk_.left(front()))
        states_[femoop::at(block_at(entry.row))] = BlockState::Left;
    for (std::int32_t place = 0; place < front().end; ++place)
        states_[femoop::at(block_at(place))] = place < front().first ? BlockState::Done : BlockState::Eliminated;
}

std::string SolverScene::joined(const std::vector<std::string>& names) const
{
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most_names); ++i) text += (i > 0 ? ", " : "") + names[i];
    return names.size() > most_names ? text + " …" : text;
}

std::string SolverScene::names(std::int32_t first, std::int32_t end) const
{
    std::vector<std::string> list;
    for (std::int32_t place = first; place < end; ++place) list.push_back(name_at(place));
    return joined(list);
}

std::string SolverScene::names(std::span<const EliminationWalk::Entry> entries) const
{
    std::vector<std::string> list;
    for (const EliminationWalk::Entry& entry : entries) list.push_back(name_at(entry.row));
    return joined(list);
}

std::string SolverScene::name_of(std::int32_t block) const
{
    return ui::shortened(trace_.blocks[femoop::at(block)].name, most_letters);
}

ui::TextStyle SolverScene::fitted(const std::string& words, ui::TextStyle style, double width) const
{
    style.size *= std::clamp(width / std::max(painter_.measure(words, style).width, 1.0), 0.1, 1.0);
    return style;
}

ui::TextStyle SolverScene::small(Role role, Anchor anchor) const
{
    ui::TextStyle style = theme().text(role, anchor);
    style.size = theme().type().small;
    return style;
}

void SolverScene::draw_mark(BlockState state, Point at, double radius) const
{
    const ui::LayerScope layer(painter_, ui::Layer::Symbols);
    const ui::Color ink = theme().stroke(Role::Member).color, faint = theme().stroke(Role::FaintLabel).color;
    const double line = std::max(0.3 * radius, 1.0);
    switch (state) {
    case BlockState::Held: {
        const double arm = 0.55 * radius;
        const ui::Stroke cross{.color = faint, .width = 0.7 * line};
        painter_.line(at + Point{-arm, -arm}, at + Point{arm, arm}, cross);
        painter_.line(at + Point{-arm, arm}, at + Point{arm, -arm}, cross);
        return;
    }
    case BlockState::Untouched: painter_.disc(at, 0.5 * radius, ink); return;
    case BlockState::Waiting: painter_.rectangle(square_at(at, 0.5 * radius), ink); return;
    case BlockState::Left:
        painter_.rectangle(square_at(at, radius), left().stroke.color);
        painter_.rectangle(square_at(at, radius - line), theme().background());
        painter_.rectangle(square_at(at, 0.4 * radius), left().stroke.color);
        return;
    case BlockState::Eliminated: painter_.disc(at, 1.15 * radius, eliminated().stroke.color); return;
    case BlockState::Done:
        painter_.disc(at, 0.75 * radius, theme().background());
        painter_.circle(at, 0.65 * radius, {.color = faint, .width = 0.7 * line});
        return;
    }
}

ui::Box SolverScene::draw_title(const ui::Box& box, const std::string& title, const std::string& note) const
{
    const ui::LayerScope layer(painter_, ui::Layer::Labels);
    ui::TextStyle head = theme().text(Role::Label, Anchor::TopLeft);
    head.weight = ui::Weight::Bold;
    painter_.text(box.min, title, head);
    const ui::TextStyle below = small(Role::FaintLabel, Anchor::TopLeft);
    double y = box.min.y + 1.35 * head.size;
    for (const std::string& line : wrapped_lines(painter_.fonts(), note, below, box.width())) {
        painter_.text({box.min.x, y}, line, below);
        y += 1.3 * below.size;
    }
    return {{box.min.x, y + 0.3 * below.size}, box.max};
}

} // namespace frame
