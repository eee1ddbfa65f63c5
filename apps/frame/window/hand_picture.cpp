#include "apps/frame/window/hand_picture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/grid.h"
#include "apps/drawing/hand_marks.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/frame/window/aim.h"
#include "ui/text/number_format.h"

namespace frame {

using Eigen::Vector2d;
using ui::Point;
using ui::Role;

namespace {

drawing::SnapGlyph glyph_of(SnapKind kind)
{
    switch (kind) {
    case SnapKind::Node: return drawing::SnapGlyph::Square;
    case SnapKind::Intersection: return drawing::SnapGlyph::Cross;
    case SnapKind::Midpoint: return drawing::SnapGlyph::Triangle;
    case SnapKind::Perpendicular: return drawing::SnapGlyph::Corner;
    case SnapKind::OnMember: return drawing::SnapGlyph::Hourglass;
    case SnapKind::Grid: return drawing::SnapGlyph::Plus;
    case SnapKind::Ray: return drawing::SnapGlyph::Circle;
    case SnapKind::Free: break;
    }
    return drawing::SnapGlyph::Dot;
}

class HandPicture {
public:
    HandPicture(ui::Painter& painter, const Session& session, const Projection& projection, const ui::Theme& theme)
        : painter_(painter), projection_(projection), theme_(theme), units_(session.units())
    {}

    /// Every line of it, or every tenth, hundredth ... where they would lie too near.
    void grid(double step)
    {
        const ui::LayerScope layer(painter_, ui::Layer::Grid);
        step = drawing::wide_enough(step, projection_.scale());
        const auto least = place_in_plane(projection_, {0.0, painter_.size().height});
        const auto most = place_in_plane(projection_, {painter_.size().width, 0.0});
        if (!least || !most || !projection_.is_plane()) return;
        const ui::Color ink = ui::with_opacity(theme_[Role::FaintLabel].text, 0.4);
        const std::vector<double> rows = drawing::multiples_between(least->y(), most->y(), step);
        for (const double x : drawing::multiples_between(least->x(), most->x(), step))
            for (const double y : rows) painter_.rectangle(dot(at({x, y})), ink);
    }

    /// Of the working plane in space: its lines as far as the structure goes.
    void grid_in_space(const WorkingPlane& plane, const std::vector<Eigen::Vector3d>& nodes, double step)
    {
        const ui::LayerScope layer(painter_, ui::Layer::Grid);
        constexpr double beyond = 8.0; // lines
        step = drawing::wide_enough(step, projection_.scale());
        Vector2d least(0.0, 0.0), most(8.0, 8.0);
        if (!nodes.empty()) least = most = plane.in_plane(nodes.front());
        for (const Eigen::Vector3d& node : nodes) {
            least = least.cwiseMin(plane.in_plane(node));
            most = most.cwiseMax(plane.in_plane(node));
        }
        least.array() = ((least.array() / step).floor() - beyond) * step;
        most.array() = ((most.array() / step).ceil() + beyond) * step;
        const ui::Stroke line{.color = ui::with_opacity(theme_[Role::FaintLabel].text, 0.35), .width = 0.75};
        const auto place = [&](double u, double v) { return projection_(plane.in_space({u, v})); };
        for (const double u : drawing::multiples_between(least.x(), most.x(), step))
            painter_.line(place(u, least.y()), place(u, most.y()), line);
        for (const double v : drawing::multiples_between(least.y(), most.y(), step))
            painter_.line(place(least.x(), v), place(most.x(), v), line);
    }

    void glyph(Point p, SnapKind kind) { drawing::draw_snap(painter_, theme_, p, glyph_of(kind)); }

    /// Its length beside its end, and in the plane its angle.
    void line(const Eigen::Vector3d& start, const Eigen::Vector3d& end, bool is_in_space)
    {
        constexpr double least = 0.5; // [px]; the pointer drawn to where the line begins differs from it by rounding
        if (ui::distance(projection_(start), projection_(end)) < least) return;
        cut(start, end);
        const Eigen::Vector3d arm = end - start;
        std::string text = units_.text(arm.norm(), ui::Measure::Length);
        if (!is_in_space)
            text += "   " + with_minus(ui::number_text(direction_of(arm.head<2>()), units_.format())) + "°";
        note(projection_(end), text);
    }

    void cut(const Eigen::Vector3d& start, const Eigen::Vector3d& end)
    {
        const ui::Stroke stroke{.color = theme_.stroke(Role::Selection).color, .width = 2.5, .dash = {8.0, 5.0}};
        painter_.line(projection_(start), projection_(end), stroke);
    }

    /// Members that are carried, and as a point a node.
    void carried(const Preview::Carried& part)
    {
        const ui::Color ink = theme_.stroke(Role::Selection).color;
        if (part.start == part.end) painter_.disc(projection_(part.start), 3.5 * theme_.symbol_scale(), ink);
        else painter_.line(projection_(part.start), projection_(part.end), {.color = ink, .width = 2.5});
    }

    /// Its name, where names are shown: of a node at its upper right, of a member upon its middle.
    void name(const Preview::Carried& part, const ShowSet& shown)
    {
        const bool is_node = part.start == part.end;
        if (!shown.contains(is_node ? Show::NodeNames : Show::MemberNames)) return;
        ui::TextStyle style = theme_.text(Role::Label, is_node ? ui::Anchor::BottomLeft : ui::Anchor::Center);
        style.plate = theme_.background();
        constexpr double away = 6.0; // [px]
        const Point middle = projection_(0.5 * (part.start + part.end));
        painter_.text(is_node ? middle + Point{away, -away} : middle, part.name, style);
    }

    void window(Point a, Point b)
    {
        const ui::Color color = theme_.stroke(Role::Selection).color;
        const bool touches = b.x < a.x;
        const ui::Stroke stroke{
            .color = color, .width = 1.5, .dash = touches ? ui::DashPattern{6.0, 4.0} : ui::DashPattern{}};
        const std::initializer_list<Point> corners{a, {b.x, a.y}, b, {a.x, b.y}};
        painter_.polygon(corners, ui::with_opacity(color, 0.10));
        painter_.polyline(corners, stroke, ui::PathEnds::Closed);
    }

    /// A dimension line that is being drawn, each length beside it.
    void dimension(const DimensionLayout& layout)
    {
        const ui::Stroke stroke{.color = theme_.stroke(Role::Selection).color, .width = 1.5};
        for (const DimensionLayout::Mark& mark : layout.marks) painter_.line(at(mark.node), at(mark.foot), stroke);
        painter_.line(at(layout.marks.front().foot), at(layout.marks.back().foot), stroke);
        for (std::size_t i = 1; i < layout.marks.size(); ++i) {
            const DimensionLayout::Mark &a = layout.marks[i - 1], &b = layout.marks[i];
            note(at(0.5 * (a.foot + b.foot)), units_.text(b.level - a.level, ui::Measure::Length));
        }
    }

    /// The path of a pencil.
    void stroke(std::span<const Vector2d> path, bool is_on_sheet)
    {
        std::vector<Point> points;
        for (const Vector2d& place : path) points.push_back(is_on_sheet ? Point{place.x(), place.y()} : at(place));
        if (points.size() > 1) painter_.polyline(points, theme_.stroke(Role::Guess));
    }

    void note(Point beside, const std::string& text) { drawing::draw_note(painter_, theme_, beside, text); }

    /// The coordinates that are meant, below the pointer.
    void coordinates(const Eigen::Vector3d& place)
    {
        std::string text;
        for (const Eigen::Index i : {0, 1, 2})
            text += (i > 0 ? "; " : "(") +
                    with_minus(ui::number_text(units_.shown(place[i], ui::Measure::Length), units_.format()));
        note(projection_(place) + Point{0.0, 40.0}, text + ") " + units_.unit(ui::Measure::Length).name);
    }

    Point at(const Vector2d& place) const { return projection_({place.x(), place.y(), 0.0}); }

private:
    static ui::Box dot(Point p) { return {p - Point{0.75, 0.75}, p + Point{0.75, 0.75}}; }
    ui::Painter& painter_;
    const Projection& projection_;
    const ui::Theme& theme_;
    ui::DisplayUnits units_;
};

} // namespace

void draw_hand(ui::Painter& painter, const Session& session, const ToolController& tool_controller,
               const Projection& projection, const ui::Theme& theme)
{
    HandPicture picture(painter, session, projection, theme);
    const bool is_in_space = femoop::is_3d(session.model().analysis);
    if (tool_controller.can_type() && tool_controller.settings().draws_to_grid) {
        const ToolSettings& settings = tool_controller.settings();
        if (is_in_space) picture.grid_in_space(settings.plane, shape_of(session.model()).nodes, settings.grid);
        else picture.grid(settings.grid);
    }
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const Preview preview = tool_controller.tool().preview();
    for (const auto& [start, end] : preview.lines) picture.line(start, end, is_in_space);
    for (const Preview::Carried& part : preview.carried) picture.carried(part);
    for (const Preview::Carried& part : preview.carried) picture.name(part, session.view.show);
    picture.stroke(preview.stroke, preview.is_stroke_on_sheet);
    const auto dimension = preview.dimension ? layout_of(session.model(), *preview.dimension) : std::nullopt;
    if (dimension) picture.dimension(*dimension);
    if (preview.cut) picture.cut(preview.cut->first, preview.cut->second);
    if (preview.window) picture.window(preview.window->first, preview.window->second);
    const bool is_placing = (tool_controller.can_type() && tool_controller.tool().snaps()) ||
                            !tool_controller.tool().moving().empty();
    const Aim& aim = tool_controller.aim();
    const Point meant = projection(aim.place());
    if (is_placing && !aim.is_lost) picture.glyph(meant, aim.snap.kind);
    if (!tool_controller.typed().empty())
        picture.note(meant + Point{0.0, 40.0}, drawing::typed_so_far(tool_controller.typed()));
    else if (is_in_space && is_placing && !aim.is_lost) picture.coordinates(aim.place());
}

void draw_typed(ui::Painter& painter, const ToolController& tool_controller, const ui::Theme& theme)
{
    drawing::draw_typed(painter, theme, tool_controller.typed());
}

} // namespace frame
