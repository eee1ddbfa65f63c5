#include "apps/frame/view/solver/solver_picture.h"

#include <algorithm>
#include <array>
#include <utility>

#include "apps/frame/view/solver/solver_scene.h"
#include "femoop/io/results/solver_trace_text.h"
#include "ui/paint/wrapped_lines.h"

namespace frame {

using femoop::SolverTrace;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

constexpr double margin = 14.0;
constexpr double broad = 2.0; // a sheet this much broader than high has its pictures in one row

/// Why there is no step to draw; nothing where there is one.
std::string why_no_steps(const SolverTrace& trace, const ui::Catalogue& tr)
{
    if (trace.n_unknowns() == 0) return tr("Every displacement is held by a support: there is nothing to eliminate.");
    if (trace.has_details()) return {};
    return tr("The system has {count} unknowns; the walk of the front is shown of {most} or fewer.",
              {{"count", std::to_string(trace.n_unknowns())}, {"most", std::to_string(SolverTrace::most_unknowns)}});
}

void draw_sentence(ui::Painter& painter, const std::string& sentence, const SolverLook& look)
{
    const ui::TextStyle style = look.theme.text(Role::Label, Anchor::Top);
    double y = 0.4 * painter.size().height;
    for (const std::string& line :
         wrapped_lines(painter.fonts(), sentence, style, painter.size().width - 2.0 * margin)) {
        painter.text({0.5 * painter.size().width, y}, line, style);
        y += 1.4 * style.size;
    }
}

/// The order, the step and what it does; returns where the next thing may stand.
double draw_head(const SolverScene& scene)
{
    const ui::Catalogue& tr = scene.tr();
    ui::Painter& painter = scene.painter();
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    ui::TextStyle title = scene.theme().text(Role::Label, Anchor::TopLeft);
    title.weight = ui::Weight::Bold;
    title.size = scene.theme().type().large;
    const std::string words = tr("Front {n} of {total}, {order}",
                                 {{"n", std::to_string(scene.step() + 1)},
                                  {"total", std::to_string(scene.walk().fronts.size())},
                                  {"order", femoop::ordering_text(scene.look().ordering, tr)}});
    painter.text({margin, margin}, words, title);
    const auto left = scene.walk().left(scene.front());
    const std::string eliminated = scene.names(scene.front().first, scene.front().end);
    const std::string sentence = tr("Eliminated: {blocks}; left: {left}",
                                    {{"blocks", eliminated}, {"left", left.empty() ? "–" : scene.names(left)}});
    const double after = 2.0 * margin + painter.measure(words, title).width;
    const ui::TextStyle style = scene.theme().text(Role::Label, Anchor::TopLeft);
    const bool fits = after + painter.measure(sentence, style).width < painter.size().width - margin;
    if (fits) {
        painter.text({after, margin + title.size - style.size}, sentence, style);
        return margin + 1.9 * title.size;
    }
    painter.text({margin, margin + 1.4 * title.size}, sentence,
                 scene.fitted(sentence, style, painter.size().width - 2.0 * margin));
    return margin + 1.9 * title.size + 1.3 * style.size;
}

/// What the marks mean, at the foot of the sheet; returns where it begins.
class Legend {
public:
    explicit Legend(const SolverScene& scene) : scene_(scene), style_(scene.small(Role::Label, Anchor::Left)) {}

    double draw()
    {
        const ui::Catalogue& tr = scene_.tr();
        const std::array<std::pair<BlockState, std::string>, 6> states{
            {{BlockState::Eliminated, tr("eliminated now")},
             {BlockState::Left, tr("left in the front")},
             {BlockState::Waiting, tr("in an update matrix that waits")},
             {BlockState::Done, tr("eliminated before")},
             {BlockState::Untouched, tr("not met yet")},
             {BlockState::Held, tr("held by a support")}}};
        const std::array<std::string, 3> entries{tr("from K"), tr("from children"), tr("made by elimination")};
        double width = 0.0;
        for (const auto& [state, words] : states) width += width_of(words);
        for (const std::string& words : entries) width += width_of(words);
        // A little smaller where that saves a line.
        const double room = scene_.painter().size().width - 2.0 * margin;
        const double lines = std::ceil(width / (1.15 * room));
        style_.size *= std::min(1.0, 0.93 * lines * room / width);
        top_ = scene_.painter().size().height - margin - lines * 1.5 * style_.size;
        pen_ = {margin, top_ + 0.75 * style_.size};
        for (const auto& [state, words] : states) {
            begin(words);
            scene_.draw_mark(state, pen_ + Point{0.5 * style_.size, 0.0}, 0.42 * style_.size);
            write(words);
        }
        const ui::Theme& theme = scene_.theme();
        const std::array<ui::Color, 3> colors{theme.stroke(Role::Member).color, scene_.left().stroke.color,
                                              scene_.fill_color()};
        for (std::size_t i = 0; i < entries.size(); ++i) {
            begin(entries[i]);
            const ui::Box box = ui::Box{pen_, pen_}.grown(0.4 * style_.size);
            const ui::Box mark{box.min + Point{0.5 * style_.size, 0.0}, box.max + Point{0.5 * style_.size, 0.0}};
            scene_.painter().rectangle(mark, colors[i]);
            if (i == 1)
                scene_.painter().line({mark.min.x, mark.max.y}, {mark.max.x, mark.min.y},
                                      {.color = theme.background(), .width = 2.0});
            if (i == 2) scene_.painter().rectangle(mark.grown(-0.2 * style_.size), theme.background());
            write(entries[i]);
        }
        return top_;
    }

private:
    double width_of(const std::string& words) const
    {
        return scene_.painter().measure(words, style_).width + 2.7 * style_.size;
    }
    void begin(const std::string& words)
    {
        if (pen_.x + width_of(words) <= scene_.painter().size().width - 0.5 * margin) return;
        pen_ = {margin, pen_.y + 1.5 * style_.size};
    }
    void write(const std::string& words)
    {
        scene_.painter().text(pen_ + Point{1.3 * style_.size, 0.0}, words, style_);
        pen_.x += width_of(words);
    }

    const SolverScene& scene_;
    ui::TextStyle style_;
    double top_ = 0.0;
    Point pen_;
};

void draw_pictures(const SolverScene& scene, const ui::Box& room)
{
    const double gap = scene.px(18.0);
    if (room.width() > broad * room.height()) {
        const std::array<double, 4> shares{0.29, 0.23, 0.18, 0.30};
        double x = room.min.x;
        const auto next = [&](double share) {
            const double width = share * (room.width() - 3.0 * gap);
            const ui::Box box{{x, room.min.y}, {x + width, room.max.y}};
            x += width + gap;
            return box;
        };
        draw_walk_on_structure(scene, next(shares[0]));
        draw_elimination_tree(scene, next(shares[1]));
        draw_front_matrix(scene, next(shares[2]));
        draw_factors(scene, next(shares[3]));
        return;
    }
    const Point middle{room.min.x + 0.52 * room.width(), room.min.y + 0.47 * room.height()};
    const double half = 0.5 * gap;
    draw_walk_on_structure(scene, {room.min, {middle.x - half, middle.y - half}});
    draw_elimination_tree(scene, {{middle.x + half, room.min.y}, {room.max.x, middle.y - half}});
    draw_front_matrix(scene, {{room.min.x, middle.y + half}, {room.min.x + 0.36 * room.width() - half, room.max.y}});
    draw_factors(scene, {{room.min.x + 0.36 * room.width() + half, middle.y + half}, room.max});
}

} // namespace

void draw_solver(ui::Painter& painter, const SolverTrace& trace, const SolverLook& look)
{
    painter.set_layer(ui::Layer::Labels);
    if (const std::string reason = why_no_steps(trace, look.tr); !reason.empty())
        return draw_sentence(painter, reason, look);
    const SolverScene scene(painter, trace, look);
    const double top = draw_head(scene);
    const double bottom = Legend(scene).draw() - 0.5 * margin;
    const ui::Box room{{margin, top}, {painter.size().width - margin, bottom}};
    const double least = 12.0 * look.theme.type().normal;
    if (room.width() > 2.0 * least && room.height() > least) draw_pictures(scene, room);
}

} // namespace frame
