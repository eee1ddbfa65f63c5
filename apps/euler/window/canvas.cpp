#include "apps/euler/window/canvas.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "apps/euler/view/draw/draw.h"
#include "apps/euler/view/pick.h"
#include "apps/euler/view/polygons/plane_model.h"
#include "apps/euler/view/shapes/outline.h"
#include "apps/euler/view/solid/solid_shapes.h"
#include "ui/canvas/click.h"
#include "ui/widgets/wrapped_text.h"

namespace euler {

using topology::EntityKind;
using ui::translatable;

namespace {

// Of the view that is seen.
template <class Change> void move(Session& session, const Change& change)
{
    session.is_fitted = false;
    switch (session.view()) {
    case ViewKind::Space: return change(session.eye);
    case ViewKind::Plane: return change(session.map_eye);
    case ViewKind::Polygons: return change(session.polygon_eye);
    }
}

PlaneStep plane_step(const Session& session)
{
    PlaneStep step;
    const auto way = session.transition();
    if (!way) return step;
    step.share = way->share;
    for (const Snapshot& in : way->other) step.other.push_back({in.solid.get(), in.names.get(), {}});
    return step;
}

// What the pointer may mean now.
std::set<EntityKind> wanted_kinds(const Session& session)
{
    using enum EntityKind;
    if (!session.draft() || session.draft()->is_complete()) return {Vertex, HalfEdge, Edge, Face};
    switch (session.draft()->next().kind) {
    case ArgumentKind::Face: return {Face};
    case ArgumentKind::Vertex: return {Vertex};
    case ArgumentKind::HalfEdge:
    case ArgumentKind::Ring: return {HalfEdge, Edge};
    default: return {Vertex, HalfEdge, Edge, Face};
    }
}

bool asks_for_corner(const Session& session)
{
    return session.draft() && !session.draft()->is_complete() && session.draft()->next().kind == ArgumentKind::Corner;
}

std::optional<Part> under_pointer(const Session& session, const Shapes& shapes, std::span<const Subject> subjects,
                                  ui::Point at)
{
    const PickRequest request{.at = at, .kinds = wanted_kinds(session), .reach = session.look.size};
    if (asks_for_corner(session))
        if (const auto corner = pick_corner(shapes, subjects, request)) return corner;
    return pick(shapes, subjects, request);
}

// Around which the eye turns.
ui::World3 middle_of(std::span<const Subject> subjects)
{
    ui::World3 sum;
    double n = 0.0;
    for (const Subject& subject : subjects) {
        for (const topology::VertexId v : subject.solid->vertices()) {
            const topology::Point& p = subject.solid->point(v);
            sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
            n += 1.0;
        }
    }
    return n > 0.0 ? ui::World3{sum.x / n, sum.y / n, sum.z / n} : sum;
}

std::string_view kind_name(EntityKind kind)
{
    switch (kind) {
    case EntityKind::Vertex: return translatable("vertex {name}");
    case EntityKind::Edge: return translatable("edge {name}");
    case EntityKind::HalfEdge: return translatable("half-edge {name}");
    case EntityKind::Loop: return translatable("loop {name}");
    case EntityKind::Face: return translatable("face {name}");
    }
    return "";
}

// On an empty sheet: how to begin, or how to go on from before the first step.
std::vector<std::string> invitation(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    if (session.n_steps() > 0)
        return {tr("Before the first of {count} steps.", {{"count", std::to_string(session.n_steps())}}),
                tr("Page down or → takes a step, Space plays.")};
    return {tr("Choose an example in the gallery, or begin with the operator MVFS."),
            tr("Ctrl+O opens a script, Ctrl+K finds a command.")};
}

} // namespace

std::string describe(const Session& session, const Part& part)
{
    const Snapshot& in = session.shown()[part.subject];
    return session.tr()(kind_name(part.entity.kind), {{"name", in.names->of(part.entity, *in.solid)}});
}

Canvas::Solids Canvas::solids_of(std::span<const Snapshot> snapshots)
{
    Solids solids;
    for (const Snapshot& snapshot : snapshots) solids.push_back(snapshot.solid);
    return solids;
}

Canvas::ViewTransform Canvas::transform_of(const Session& session, std::span<const Subject> subjects)
{
    ViewTransform transform{.solids = solids_of(session.shown()),
                            .progress = {},
                            .generation = session.generation(),
                            .view = session.view(),
                            .eye = session.eye,
                            .map_eye = session.map_eye,
                            .polygon_eye = session.polygon_eye,
                            .explosion = session.look.explosion,
                            .size = session.look.size,
                            .has_faces = session.look.faces,
                            .theme = session.look.theme,
                            .language = session.tr().language()};
    for (const Subject& subject : subjects) transform.progress.push_back(subject.marks.progress);
    return transform;
}

Canvas::Painting Canvas::painting_of(const Session& session, std::span<const Subject> subjects) const
{
    Painting painting{.transform = *seen_,
                      .marks = {},
                      .names = session.look.names,
                      .has_hatching = session.look.hatching,
                      .has_half_edges = session.look.half_edges,
                      .sheet = sheet()};
    for (const Subject& subject : subjects) painting.marks.push_back(subject.marks);
    return painting;
}

// What stands where is found again when something moved; a solid of thousands of faces takes a while.
void Canvas::follow_shapes(const Session& session, std::span<const Subject> subjects)
{
    ViewTransform transform = transform_of(session, subjects);
    if (seen_ == transform) return;
    shapes_ = shapes_of(session, subjects);
    seen_ = std::move(transform);
}

Shapes Canvas::shapes_of(const Session& session, std::span<const Subject> subjects)
{
    switch (session.view()) {
    case ViewKind::Plane: return map_of(session, subjects).shapes(subjects, session.map_eye, session.look);
    case ViewKind::Polygons: return plane_model(subjects, session.polygon_eye, session.look, plane_step(session));
    case ViewKind::Space: break;
    }
    return solid_shapes(subjects, session.eye, session.look);
}

const PlanarMap& Canvas::Map::of(const Solids& solids, std::span<const Subject> subjects)
{
    if (solids_ != solids) map_ = PlanarMap(subjects);
    solids_ = solids;
    return map_;
}

// During a step between the maps before it and after it.
PlanarMap Canvas::map_of(const Session& session, std::span<const Subject> subjects)
{
    const PlanarMap& own = map_.of(solids_of(session.shown()), subjects);
    const auto way = session.transition();
    if (!way) return own;
    const PlaneStep step = plane_step(session);
    return own.on_its_way(subjects, other_map_.of(solids_of(way->other), step.other), step.other, step.share);
}

Canvas::Fitting Canvas::fitting_of(const Session& session) const
{
    return {.now = solids_of(session.shown()),
            .at_end = solids_of(session.at_end()),
            .sheet = sheet(),
            .view = session.view(),
            .explosion = session.look.explosion,
            .way = session.view() != ViewKind::Space ? plane_step(session).share : 1.0,
            .eye = session.eye,
            .map_eye = session.map_eye,
            .polygon_eye = session.polygon_eye};
}

void Canvas::fit(Session& session)
{
    if (fitted_ == fitting_of(session)) return;
    fit_view(session);
    fitted_ = fitting_of(session);
}

// In space for the whole lesson and for what is seen now, so that the picture rests from step to step.
void Canvas::fit_view(Session& session)
{
    std::vector<Subject> subjects = session.subjects();
    if (session.view() == ViewKind::Plane) session.map_eye = map_of(session, subjects).fitted(sheet());
    if (session.view() == ViewKind::Polygons)
        session.polygon_eye = fitted_plane_model(subjects, sheet(), plane_step(session));
    if (session.view() != ViewKind::Space) return;
    for (const Snapshot& snapshot : session.at_end())
        subjects.push_back({snapshot.solid.get(), snapshot.names.get(), {}});
    session.eye = fitted(session.eye, subjects, session.look, sheet());
}

// Around what is drawn already; from then on the picture rests under the hand.
void Canvas::give_room_to_draw(Session& session)
{
    constexpr std::array<ui::World3, 2> sheet_of_paper{{{-1.0, -1.0, 0.0}, {9.0, 7.0, 0.0}}};
    if (shapes_.vertices.empty()) session.eye.fit(sheet_of_paper, sheet());
    else fit(session);
    if (!shapes_.vertices.empty()) session.eye.zoom(middle(), 0.6);
    session.is_fitted = false;
}

void Canvas::zoom(Session& session, double factor) const
{
    move(session, [&](auto& camera) { camera.zoom(middle(), factor); });
}

void Canvas::look(Session& session, ui::StandardView view)
{
    session.eye.look(view);
    session.show_as(ViewKind::Space);
}

// Where panels come or go, what the hand has moved keeps its middle and its share of the sheet. A notice at the foot
// moves nothing under the hand.
void Canvas::follow_room(Session& session)
{
    constexpr double clearly = 0.15;
    const auto has_changed = [](double a, double b) { return std::abs(b - a) > clearly * a; };
    if (!has_changed(room_.width, sheet().width) && !has_changed(room_.height, sheet().height)) return;
    const ui::Size before = std::exchange(room_, sheet());
    if (session.is_fitted) return;
    const ui::Point shift = middle() - 0.5 * ui::Point{before.width, before.height};
    const auto extent = [](ui::Size size) { return std::min(size.width, size.height); }; // there and back is nothing
    const double factor = extent(sheet()) / extent(before);
    const auto follow = [&](auto& camera) {
        camera.pan(shift);
        camera.zoom(middle(), factor);
    };
    follow(session.eye);
    follow(session.map_eye);
    follow(session.polygon_eye);
}

void Canvas::show(Session& session, ui::ImGuiSession& gui)
{
    if (!begin(gui, any_button)) return;
    follow_room(session);
    if (session.is_fitted) session.is_drawing() ? give_room_to_draw(session) : fit(session);
    if (!is_over() && !is_active()) line_start_.reset(); // released beside the picture
    else follow(session);
    repaint(session);
    end(gui);
}

void Canvas::follow(Session& session)
{
    move_camera(session);
    if (is_moving_view()) return;
    if (session.is_drawing()) return draw_line(session);
    const std::vector<Subject> subjects = session.subjects();
    follow_shapes(session, subjects);
    const auto under = under_pointer(session, shapes_, subjects, pointer());
    if (under) session.hover = under;
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && is_released()) click(session, under);
    if (!under && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) session.is_fitted = true;
    notify(session);
}

void Canvas::click(Session& session, const std::optional<Part>& under) const
{
    if (under) session.pick(*under);
    else session.selection.reset();
}

// What lies under the pointer, and why it cannot be chosen where an operator asks.
void Canvas::notify(const Session& session) const
{
    if (!session.hover || session.hover->subject >= session.shown().size()) return;
    std::string words = describe(session, *session.hover);
    if (const auto reason = session.why_not_pick(*session.hover)) words += "\n" + session.tr()(*reason);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.5F * ImGui::GetFontSize(), 0.3F * ImGui::GetFontSize()});
    ImGui::BeginTooltip();
    ui::wrapped_text(words, 24.0F * ImGui::GetFontSize());
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

namespace {

// So many pixels apart that a hand can choose among them.
double grid(double scale)
{
    constexpr double least = 24.0; // px
    double step = std::pow(10.0, std::floor(std::log10(least / scale)));
    for (const double factor : {2.0, 2.5, 2.0})
        if (step * scale < least) step *= factor;
    return step;
}

} // namespace

// At a vertex that is near, else on the grid.
topology::Point Canvas::place_under_pointer(const Session& session) const
{
    constexpr double near = 10.0; // px
    for (const Shapes::Vertex& vertex : shapes_.vertices)
        if (ui::distance(vertex.at, pointer()) < near)
            return session.shown()[vertex.subject].solid->point(vertex.vertex);
    const ui::World3 p = session.eye.to_world(pointer(), 0.0);
    const double step = grid(session.eye.scale());
    const auto rounded = [&](double x) { return step * std::round(x / step) + 0.0; }; // no minus zero
    return {rounded(p.x), rounded(p.y), 0.0};
}

void Canvas::draw_line(Session& session)
{
    line_end_ = place_under_pointer(session);
    if (is_pressed()) line_start_ = line_end_;
    const bool is_click = ui::distance(pressed_at(), pointer()) <=
                          ui::click_reach; // over the border of two places of the grid too
    if (line_start_ && is_click) line_end_ = line_start_;
    if (!line_start_ || !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
    if (const auto reason = session.draw(*std::exchange(line_start_, std::nullopt), *line_end_))
        session.notify(*reason);
}

// The place that is meant, and the line on its way.
void Canvas::paint_drawing(const Session& session, ui::Painter& painter) const
{
    const ui::Theme theme = session.look.full_theme();
    const ui::LayerScope above(painter, ui::Layer::Overlay);
    if (!line_end_) return;
    const auto on_sheet = [&](const topology::Point& p) { return session.eye.to_sheet({p.x, p.y, p.z}); };
    const ui::Stroke stroke = theme.stroke(ui::Role::Created);
    painter.circle(on_sheet(*line_end_), 5.0 * theme.symbol_scale(), stroke);
    if (line_start_) painter.line(on_sheet(*line_start_), on_sheet(*line_end_), stroke);
}

void Canvas::move_camera(Session& session)
{
    const ui::ViewMove hand = view_move({.left = !session.is_drawing()});
    if (hand.wheel != 0.0) move(session, [&](auto& camera) { camera.zoom(pointer(), hand.zoom()); });
    if (!hand.is_drag()) return;
    const bool turns = hand.is_left && !ImGui::GetIO().KeyShift && session.view() == ViewKind::Space;
    if (turns) session.eye.orbit(hand.drag, middle_of(session.subjects()));
    else move(session, [&](auto& camera) { camera.pan(hand.drag); });
    session.is_fitted = false;
}

void Canvas::repaint(const Session& session)
{
    const std::vector<Subject> subjects = session.subjects();
    follow_shapes(session, subjects);
    Painting painting = painting_of(session, subjects);
    if (painted_ == painting && !session.is_drawing()) return;
    painted_ = session.is_drawing() ? std::nullopt : std::optional(std::move(painting));
    const bool is_empty = std::ranges::all_of(subjects, [](const Subject& s) { return s.solid->is_empty(); });
    paint([&](ui::Painter& painter) {
        draw(painter, shapes_, subjects, session.look);
        if (session.is_drawing()) paint_drawing(session, painter);
        else if (is_empty) ui::draw_invitation(painter, session.look.full_theme(), invitation(session));
    });
}

ui::Picture Canvas::picture_of(const Session& session)
{
    std::vector<Subject> subjects = session.subjects();
    for (Subject& subject : subjects) {
        subject.marks.hovered.reset();
        subject.marks.selected.clear();
    }
    follow_shapes(session, subjects);
    return euler::picture(shapes_, subjects, session.look, sheet(), fonts());
}

namespace {

ui::Point middle_of(const std::vector<ui::Point>& line)
{
    const std::size_t n = line.size();
    return n % 2 == 1 ? line[n / 2] : 0.5 * (line[n / 2 - 1] + line[n / 2]);
}

// A place that is in no hole: the middle, or the first of some others.
ui::Point place_in(const Region& area)
{
    const ui::Box box = bounds_of(area);
    constexpr int n = 8;
    if (is_inside(area, box.center())) return box.center();
    for (int i = 1; i < n * n; ++i) {
        const int row = i / n, column = i % n;
        const ui::Point p{box.min.x + (column + 0.5) / n * box.width(), box.min.y + (row + 0.5) / n * box.height()};
        if (is_inside(area, p)) return p;
    }
    return box.center();
}

} // namespace

ui::Point Canvas::in_window(const Session& session, const topology::Point& place) const
{
    return corner() + session.eye.to_sheet({place.x, place.y, place.z});
}

std::optional<ui::Point> Canvas::in_window(const Part& part) const
{
    const auto is_it = [&](std::size_t subject, topology::Entity entity) {
        return subject == part.subject && entity == part.entity;
    };
    for (const Shapes::Vertex& vertex : shapes_.vertices)
        if (is_it(vertex.subject, vertex.vertex)) return corner() + vertex.at;
    for (const Shapes::Edge& edge : shapes_.edges)
        if (is_it(edge.subject, edge.edge) && !edge.line.empty()) return corner() + middle_of(edge.line);
    for (const Shapes::Arrow& arrow : shapes_.arrows)
        if (is_it(arrow.subject, arrow.half_edge) && !arrow.line.empty()) return corner() + middle_of(arrow.line);
    for (const Shapes::Piece& piece : shapes_.pieces) {
        const Shapes::Face& face = shapes_.faces[piece.face];
        if (is_it(face.subject, face.face)) return corner() + place_in(piece.area);
    }
    return std::nullopt;
}

} // namespace euler
