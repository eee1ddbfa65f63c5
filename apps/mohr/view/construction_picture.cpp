#include "apps/mohr/view/construction_picture.h"

#include <algorithm>

#include "apps/mohr/view/circle_picture.h"
#include "apps/mohr/view/construction_words.h"
#include "apps/mohr/view/labels.h"
#include "apps/mohr/view/sentence.h"
#include "apps/mohr/view/space_picture.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::Role;
using Step = fm::ConstructionStep;
using Stage = fm::ConstructionStage;

namespace {

/// Draws steps, old ones as they stay, the newest in colour.
class Board {
public:
    Board(ui::Painter& painter, const Scene& scene, const ui::PlaneCamera& camera, Labels& labels)
        : painter_(painter), scene_(scene), camera_(camera), labels_(labels), theme_(scene.look.full_theme())
    {}

    void draw(const Step& step, bool is_newest) const
    {
        const bool is_helper = step.stage == Stage::FromFirst || step.stage == Stage::FromThird;
        const Role role = is_newest ? Role::Created : is_helper ? Role::LocalAxes : Role::Bar;
        for (const Step::Arc& arc : step.arcs) draw_arc(arc, role, is_newest);
        for (const Step::Line& line : step.lines) draw_line(line, is_newest ? Role::Created : Role::Dimension);
        for (const Step::Point& point : step.points) draw_point(point, is_newest);
    }

private:
    ui::Point at(const fm::CirclePoint& p) const { return camera_.to_sheet({p.normal, p.shear}); }

    /// A line drawn with a ruler goes a little beyond both ends.
    void draw_line(const Step::Line& line, Role role) const
    {
        const ui::Point a = at(line.from), b = at(line.to), beyond = 16.0 * ui::direction(b - a);
        if (ui::distance(a, b) < 1.0) return;
        painter_.line(a - beyond, b + beyond, theme_.stroke(role));
    }

    /// The compass leaves its prick in the centre, and its opening is seen as a thin radius.
    void draw_arc(const Step::Arc& arc, Role role, bool is_newest) const
    {
        const ui::Point centre = at(arc.centre);
        const double radius = camera_.scale() * arc.radius;
        painter_.arc({centre, radius, arc.start, arc.sweep}, theme_.stroke(role));
        if (!is_newest) return;
        painter_.line(centre, opened_to(arc), theme_.stroke(Role::Undeformed));
        const double prick = 6.0 * theme_.symbol_scale();
        painter_.line(centre - ui::Point{prick, prick}, centre + ui::Point{prick, prick}, theme_.stroke(Role::Created));
        painter_.line(centre - ui::Point{prick, -prick}, centre + ui::Point{prick, -prick},
                      theme_.stroke(Role::Created));
    }

    bool is_space() const { return is_in_space(scene_.document.subject); }

    /// Where the compass's pencil begins.
    ui::Point opened_to(const Step::Arc& arc) const
    {
        if (!is_space()) return at(fm::face_point(scene_.solution.plane, 0.0, fm::ShearRule::ClockwiseUp));
        return ui::Arc{at(arc.centre), camera_.scale() * arc.radius, 0.0, 0.0}.at(arc.start);
    }

    /// What labels stand around.
    ui::Point middle() const
    {
        const Solution& s = scene_.solution;
        return camera_.to_sheet({is_space() ? fm::circles(s.space_principal)[0].centre : s.circle.centre, 0.0});
    }

    void draw_point(const Step::Point& point, bool is_newest) const
    {
        const Role role = is_newest ? Role::Created : Role::Label;
        draw_mark(painter_, scene_, at(point.at), std::nullopt, role);
        ui::Point away = at(point.at) - middle();
        if (is_space() && point.at.shear == 0.0) away.y = 0.5 * ui::length(away) + 1.0; // names stand below the axis
        const bool is_centre = ui::length(away) < 1.0;
        std::string words = mark_name(point.mark, scene_.document);
        if (words.empty()) return;
        if (is_newest && point.mark != fm::ConstructionMark::C) words += coordinates(point.at);
        labels_.add(at(point.at), is_centre ? ui::Point{0.0, 1.0} : away, words, theme_.text(role),
                    is_newest ? 9.0 : 5.0);
    }

    std::string coordinates(const fm::CirclePoint& p) const
    {
        const double sense = scene_.solution.rule == fm::ShearRule::ClockwiseUp ? 1.0 : -1.0;
        return " (" + scene_.look.number(p.normal) + "; " + scene_.look.number(sense * p.shear) + ")";
    }

    ui::Painter& painter_;
    const Scene& scene_;
    ui::PlaneCamera camera_;
    Labels& labels_;
    ui::Theme theme_;
};

std::string caption_of(const Scene& scene, const std::vector<Step>& steps, std::size_t i)
{
    return std::to_string(i + 1) + ". " + caption(steps[i].stage, scene.document, scene.solution, scene.look);
}

/// Of the longest caption: the room is always that high, so that the circle rests.
std::size_t most_lines(const ui::Painter& painter, const Scene& scene, const std::vector<Step>& steps,
                       const ui::TextStyle& style, double width)
{
    std::size_t most = 3;
    for (std::size_t i = 0; i < steps.size(); ++i)
        most = std::max(most, lines_of(painter, caption_of(scene, steps, i), style, width).size());
    return most;
}

/// Below the box.
void write_caption(ui::Painter& painter, const ui::Box& box, const std::string& words, const ui::TextStyle& style)
{
    double y = box.max.y + 0.5 * style.size;
    for (const std::string& line : lines_of(painter, words, style, box.width())) {
        painter.text({box.min.x, y}, line, style);
        y += 1.5 * style.size;
    }
}

} // namespace

void draw_construction(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn)
{
    const ui::Theme theme = scene.look.full_theme();
    const auto steps = construction_of(scene.document, scene.solution);
    const std::size_t n = std::clamp<std::size_t>(*scene.steps_shown, 1, steps.size());
    const std::string words = caption_of(scene, steps, n - 1);
    const ui::TextStyle style = theme.text(Role::Label, ui::Anchor::TopLeft);
    ui::Box board = box;
    const auto n_lines = static_cast<double>(most_lines(painter, scene, steps, style, box.width()));
    board.max.y -= (1.5 * n_lines + 0.5) * style.size;
    write_caption(painter, board, words, style);
    board = write_rule(painter, scene, board);
    Labels labels(board, painter.fonts());
    drawn.circle = circle_camera(scene.frame, board, scene.look);
    draw_axes(painter, scene, board, drawn.circle, labels);
    if (std::ranges::find(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(n), Stage::LowerCircle,
                          &Step::stage) != steps.begin() + static_cast<std::ptrdiff_t>(n))
        draw_region(painter, scene, drawn.circle);
    const Board on_board(painter, scene, drawn.circle, labels);
    for (std::size_t i = 0; i < n; ++i) on_board.draw(steps[i], i + 1 == n);
    labels.draw(painter, theme);
}

} // namespace mohr
