#include "apps/plane/window/hand_picture.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "apps/drawing/grid.h"
#include "apps/drawing/hand_marks.h"
#include "apps/plane/discretize/shape_curves.h"
#include "apps/plane/document/fault_words.h"
#include "apps/plane/document/points.h"
#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/view/plate_outline.h"
#include "ui/text/number_format.h"

namespace plane {

using drawing::SnapGlyph;
using ui::Point;
using ui::Role;

namespace {

SnapGlyph glyph_of(SnapKind kind)
{
    switch (kind) {
    case SnapKind::Point: return SnapGlyph::Square;
    case SnapKind::Crossing: return SnapGlyph::Cross;
    case SnapKind::Middle: return SnapGlyph::Triangle;
    case SnapKind::OnCurve: return SnapGlyph::Hourglass;
    case SnapKind::Grid: return SnapGlyph::Plus;
    case SnapKind::Free: break;
    }
    return SnapGlyph::Dot;
}

/// The curve as a line of short parts.
std::vector<Point> traced(const topology::Curve& curve, const ui::PlaneCamera& camera)
{
    const int n = curve.is_straight() ? 1 : 64;
    std::vector<Point> points;
    for (int i = 0; i <= n; ++i) {
        const FlatPoint p = curve.at(static_cast<double>(i) / n);
        points.push_back(camera.to_sheet({p.x, p.y}));
    }
    return points;
}

/// "82.5 mm   30°" of a straight part, "R 12 mm" of a circle.
std::string measure_text(const CurveDraft& draft, const Session& session)
{
    const ui::DisplayUnits units = session.units();
    if (draft.kind == femoop::plane::DrawnKind::Circle) return "R " + units.text(draft.radius, ui::Measure::Length);
    if (draft.kind != femoop::plane::DrawnKind::Line || draft.places.size() < 2) return {};
    const topology::FlatVector arm = draft.places.back().at - draft.places[draft.places.size() - 2].at;
    const double angle = std::atan2(arm.y, arm.x) * 180.0 / std::numbers::pi;
    return units.text(topology::length(arm), ui::Measure::Length) + "   " +
           ui::with_minus_signs(ui::number_text(angle, units.format())) + "°";
}

class HandPicture {
public:
    HandPicture(ui::Painter& painter, const Workspace& workspace, const ui::PlaneCamera& camera)
        : painter_(painter), workspace_(workspace), camera_(camera), theme_(workspace.session.look.theme)
    {}

    void preview(const CurveDraft& draft)
    {
        begun(draft);
        if (const std::string text = measure_text(draft, workspace_.session); !text.empty())
            drawing::draw_note(painter_, theme_, meant(), text);
    }

    void begun(const CurveDraft& draft)
    {
        const ui::Color ink = theme_.stroke(Role::Selection).color;
        const ui::Stroke dashed{.color = ink, .width = 2.5, .dash = {8.0, 5.0}};
        const auto made = discretize::curves_of(workspace_.session.model(), shape_of(draft), "", 0.0);
        for (const discretize::ShapePart& part : made.parts) painter_.polyline(traced(part.curve, camera_), dashed);
        for (const DraftPlace& place : draft.places) painter_.disc(at(place.at), 2.5 * theme_.symbol_scale(), ink);
    }

    void cut(const FlatPoint& start)
    {
        const ui::Stroke dashed{
            .color = theme_.stroke(Role::Selection).color, .width = 2.0, .dash = {12.0, 3.0, 3.0, 3.0}};
        painter_.line(at(start), meant(), dashed);
        painter_.disc(at(start), 3.5 * theme_.symbol_scale(), dashed.color);
    }

    /// The places of the image that were picked, by their numbers, and where the first one comes.
    void aligned(const AlignTool& tool)
    {
        const ui::Color ink = theme_.stroke(Role::Selection).color;
        const ui::Stroke dashed{.color = ink, .width = 2.0, .dash = {8.0, 5.0}};
        const std::vector<FlatPoint>& picked = tool.picked();
        if (picked.size() == 1) painter_.line(at(picked[0]), meant(), dashed);
        if (picked.size() == 2) painter_.line(at(picked[0]), at(picked[1]), {.color = ink, .width = 2.0});
        if (tool.first_target()) {
            painter_.line(at(picked[0]), at(*tool.first_target()), dashed);
            painter_.circle(at(*tool.first_target()), 7.0 * theme_.symbol_scale(), {.color = ink, .width = 2.0});
            painter_.line(at(picked[1]), meant(), dashed);
        }
        for (std::size_t i = 0; i < picked.size(); ++i) number(at(picked[i]), std::to_string(i + 1), ink);
    }

    /// The place that is meant, and where it is while a point is dragged.
    void place(bool tells_place)
    {
        const Snap& snap = workspace_.hand.aim().snap;
        drawing::draw_snap(painter_, theme_, meant(), glyph_of(snap.kind));
        if (tells_place) drawing::draw_note(painter_, theme_, meant(), place_text(snap.place));
    }

    void typed()
    {
        drawing::draw_note(painter_, theme_, meant() + Point{0.0, 40.0},
                           drawing::typed_so_far(workspace_.hand.typed()));
    }

private:
    void number(Point place, const std::string& digit, ui::Color ink)
    {
        painter_.disc(place, 9.0 * theme_.symbol_scale(), ink);
        ui::TextStyle style = theme_.text(Role::Label, ui::Anchor::Center);
        style.weight = ui::Weight::Bold;
        style.color = theme_.background();
        painter_.text(place, digit, style);
    }

    Point at(const FlatPoint& p) const { return camera_.to_sheet({p.x, p.y}); }
    Point meant() const { return at(workspace_.hand.aim().snap.place); }

    std::string place_text(const FlatPoint& p) const
    {
        const ui::DisplayUnits units = workspace_.session.units();
        return units.place(p.x, p.y) + " " + units.unit(ui::Measure::Length).name;
    }

    ui::Painter& painter_;
    const Workspace& workspace_;
    const ui::PlaneCamera& camera_;
    ui::Theme theme_;
};

/// Curves as lines, faces as areas and points as rings, over the picture.
class HighlightPicture {
public:
    HighlightPicture(ui::Painter& painter, const Session& session, const ui::PlaneCamera& camera,
                     const PlateOutline& outline)
        : painter_(painter), session_(session), camera_(camera), outline_(outline), theme_(session.look.theme)
    {}

    void show(const std::vector<Part>& parts, Role role, double width)
    {
        const PlateHighlight lit = session_.highlight(parts);
        const ui::Color ink = theme_.stroke(role).color;
        for (const std::size_t face : lit.faces)
            if (face < outline_.faces.size()) mark(outline_.faces[face], ink, width);
        for (const CurveId curve : lit.curves)
            for (const OutlinedPiece& piece : outline_.pieces)
                if (piece.curve == curve) painter_.polyline(on_sheet(piece.line), {.color = ink, .width = width});
        for (const NodeId point : lit.points) {
            const FlatPoint p = place_of(session_.model(), point);
            painter_.circle(camera_.to_sheet({p.x, p.y}), 6.0 * theme_.symbol_scale(), {.color = ink, .width = 2.5});
        }
    }

private:
    std::vector<Point> on_sheet(const PlaceLine& line) const
    {
        std::vector<Point> points;
        for (const auto& p : line) points.push_back(camera_.to_sheet({p.x(), p.y()}));
        return points;
    }
    /// Filled, but where colours mean stresses.
    void mark(const OutlinedFace& face, ui::Color ink, double width)
    {
        std::vector<std::vector<Point>> loops;
        for (const PlaceLine& loop : face.loops) loops.push_back(on_sheet(loop));
        if (!session_.look.field && !session_.look.error) return painter_.region(loops, ui::with_opacity(ink, 0.18));
        for (const std::vector<Point>& loop : loops)
            painter_.polyline(loop, {.color = ink, .width = width}, ui::PathEnds::Closed);
    }

    ui::Painter& painter_;
    const Session& session_;
    const ui::PlaneCamera& camera_;
    const PlateOutline& outline_;
    ui::Theme theme_;
};

/// Where a part is marked: a point, the middle of a curve's first part, a face.
std::optional<FlatPoint> mark_of(const Part& part, const Session& session)
{
    if (const auto* const point = std::get_if<NodeId>(&part)) return place_of(session.model(), *point);
    if (const auto* const face = std::get_if<FacePlace>(&part)) return face->at;
    const auto& shape = session.model()[std::get<CurveId>(part)].shape;
    if (!shape) return std::nullopt;
    const auto made = discretize::curves_of(session.model(), *shape, "", 0.0);
    if (made.parts.empty()) return std::nullopt;
    return made.parts[made.parts.size() / 2].curve.at(0.5);
}

void draw_mark(ui::Painter& painter, const ui::Theme& theme, Point at)
{
    const double r = 8.0 * theme.symbol_scale();
    painter.disc(at, r, theme.stroke(Role::Error).color);
    ui::TextStyle style = theme.text(Role::Label, ui::Anchor::Center);
    style.weight = ui::Weight::Bold;
    style.color = theme.background();
    painter.text(at, "!", style);
}

} // namespace

double grid_step(const ui::PlaneCamera& camera)
{
    constexpr double least = 24.0; // [px]
    return drawing::round_grid(least / camera.scale());
}

void draw_hand(ui::Painter& painter, const Workspace& workspace, const ui::PlaneCamera& camera, const ui::Box& room,
               bool is_dragging)
{
    const Hand& hand = workspace.hand;
    const ui::Theme theme(workspace.session.look.theme);
    HandPicture picture(painter, workspace, camera);
    const auto draft = hand.preview();
    {
        const ui::ClipScope clip(painter, room);
        if ((hand.draws() || is_dragging) && hand.snaps_to_grid && hand.tool() != ToolKind::Probe &&
            !hand.picks_in_backdrop())
            drawing::draw_grid(painter, theme, camera, grid_step(camera));
        const ui::LayerScope layer(painter, ui::Layer::Overlay);
        if (draft) picture.preview(*draft);
        if (hand.cut_start()) picture.cut(*hand.cut_start());
        if (hand.align_tool()) picture.aligned(*hand.align_tool());
    }
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    if (hand.draws() || is_dragging) picture.place(is_dragging || !draft);
    if (!hand.typed().empty()) picture.typed();
}

void draw_begun(ui::Painter& painter, const Workspace& workspace, const ui::PlaneCamera& camera, const ui::Box& room)
{
    const auto draft = workspace.hand.begun();
    if (!draft) return;
    const ui::ClipScope clip(painter, room);
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    HandPicture(painter, workspace, camera).begun(*draft);
}

void draw_helpers(ui::Painter& painter, const Session& session, const ui::PlaneCamera& camera, const ui::Box& room)
{
    if (session.drawing() == nullptr) return;
    const ui::ClipScope clip(painter, room);
    const ui::Theme theme(session.look.theme);
    const ui::Stroke stroke{.color = theme[Role::FaintLabel].text, .width = 1.25};
    const double r = 4.0 * theme.symbol_scale();
    for (std::size_t i = 0; i < session.model().points.size(); ++i) {
        if (session.drawing()->vertex(NodeId(i))) continue;
        const FlatPoint place = place_of(session.model(), NodeId(i));
        const Point p = camera.to_sheet({place.x, place.y});
        painter.line(p - Point{r, 0.0}, p + Point{r, 0.0}, stroke);
        painter.line(p - Point{0.0, r}, p + Point{0.0, r}, stroke);
    }
}

void draw_highlight(ui::Painter& painter, const Session& session, const ui::PlaneCamera& camera, const ui::Box& room)
{
    if (session.drawing() == nullptr || (session.selection().empty() && !session.hover)) return;
    constexpr double flatness = 0.15; // [px] that a line may stray from its curve
    const PlateOutline outline = outline_of(*session.drawing(), flatness / camera.scale());
    const ui::ClipScope clip(painter, room);
    HighlightPicture picture(painter, session, camera, outline);
    if (session.hover) picture.show({*session.hover}, Role::Hover, 4.0);
    picture.show(session.selection(), Role::Selection, 4.0);
}

void draw_typed_at_foot(ui::Painter& painter, const Workspace& workspace)
{
    drawing::draw_typed(painter, ui::Theme(workspace.session.look.theme), workspace.hand.typed());
}

void draw_problems(ui::Painter& painter, const Workspace& workspace, const ui::PlaneCamera& camera)
{
    const Session& session = workspace.session;
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const ui::Theme theme(session.look.theme);
    const auto at = [&](const FlatPoint& p) { return camera.to_sheet({p.x, p.y}); };
    if (const auto gap = told_gap(workspace)) {
        const ui::Stroke stroke{.color = theme.stroke(Role::Error).color, .width = 2.0, .dash = {4.0, 4.0}};
        painter.line(at(gap->from), at(gap->to), stroke);
        for (const FlatPoint& end : {gap->from, gap->to})
            painter.circle(at(end), 7.0 * theme.symbol_scale(), {.color = stroke.color, .width = 2.0});
    }
    for (const femoop::Fault& fault : session.solution().faults()) {
        if (!is_error(fault)) continue;
        const auto part = part_of(fault, session.model(), session.drawing());
        const auto mark = part ? mark_of(*part, session) : std::nullopt;
        if (mark) draw_mark(painter, theme, at(*mark));
    }
}

} // namespace plane
