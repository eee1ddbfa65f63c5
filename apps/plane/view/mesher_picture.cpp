#include "apps/plane/view/mesher_picture.h"

#include <array>
#include <string>
#include <vector>

#include "apps/plane/discretize/mesh_player.h"
#include "apps/plane/view/mesh_words.h"
#include "ui/paint/wrapped_lines.h"

namespace plane {

namespace {

using topology::MeshStep;
using ui::Role;

constexpr double made_opacity = 0.35, place_radius = 4.0, least_step_size = 5.0; // [px]

ui::Point on_sheet(const PlateScene& scene, const topology::FlatPoint& at) { return scene.place({at.x, at.y}); }

std::vector<ui::Point> outline_on_sheet(const PlateScene& scene, const std::vector<topology::FlatPoint>& cell)
{
    std::vector<ui::Point> points;
    for (const topology::FlatPoint& at : cell) points.push_back(on_sheet(scene, at));
    return points;
}

/// Cells that are there, each with its outline.
void draw_cells(const PlateScene& scene)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Grid);
    ui::Stroke stroke = scene.sketch.thin(Role::HiddenEdge);
    stroke.color = ui::with_opacity(scene.sketch.theme().stroke(Role::FaintLabel).color, 0.75);
    for (const topology::CellMesh& mesh : scene.input.player->meshes())
        for (const topology::Cell& cell : mesh.cells) {
            std::vector<ui::Point> points;
            for (const topology::CellNode node : cell.nodes()) points.push_back(on_sheet(scene, mesh.nodes[node]));
            points.push_back(points.front());
            scene.sketch.polyline(points, stroke, drawing::Clearance::None);
        }
}

void draw_made_cells(const PlateScene& scene, const topology::MeshMarks& marks)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Background);
    const ui::Color fill = ui::with_opacity(scene.sketch.theme().stroke(Role::Created).color, made_opacity);
    for (const auto& cell : marks.cells)
        scene.sketch.polygon(outline_on_sheet(scene, cell), fill, drawing::Clearance::None);
}

void draw_lines(const PlateScene& scene, const std::vector<std::array<topology::FlatPoint, 2>>& lines,
                const ui::Stroke& stroke)
{
    for (const auto& [a, b] : lines)
        scene.sketch.polyline({on_sheet(scene, a), on_sheet(scene, b)}, stroke, drawing::Clearance::None);
}

std::string_view sentence_of(MeshStep step)
{
    using ui::translatable;
    switch (step) {
    case MeshStep::Node: return translatable("A node of the outline is put in.");
    case MeshStep::Edge: return translatable("A part of the outline becomes the side of triangles.");
    case MeshStep::Outside: return translatable("The triangles outside are taken away.");
    case MeshStep::Point:
        return translatable(
            "A poor triangle, drawn with its circle, gets a new place; the triangles around that are made "
            "anew.");
    case MeshStep::FrontPoint: return translatable("The shortest side of the front gets a triangle, to a new place.");
    case MeshStep::FrontNode:
        return translatable("The shortest side of the front gets a triangle, to a node that stands already.");
    case MeshStep::Quarter: return translatable("A square that is too large there is cut into four.");
    case MeshStep::Pattern: return translatable("A square inside is filled by the pattern of its sides.");
    case MeshStep::Band: return translatable("Triangles join the squares inside to the outline.");
    case MeshStep::Row: return translatable("A row is laid between the sides.");
    case MeshStep::Triangles: return translatable("Delaunay's triangles stand, to be joined in pairs.");
    case MeshStep::Pair: return translatable("Two triangles become a quadrilateral.");
    case MeshStep::Walk:
        return translatable("A triangle that was left over walks to another one, and both become a quadrilateral.");
    case MeshStep::Mend:
        return translatable("The worst quadrilaterals are cut anew, then all places inside are smoothed.");
    case MeshStep::Smoothed: return translatable("Every place inside moves to the middle of its neighbours.");
    case MeshStep::Done: break;
    }
    return {};
}

} // namespace

void draw_mesher(const PlateScene& scene)
{
    const topology::MeshMarks marks = scene.input.player->marks();
    scene.shade_faces();
    draw_made_cells(scene, marks);
    draw_cells(scene);
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    draw_lines(scene, marks.lines, scene.sketch.thin(Role::ShearForce));
    if (marks.circle) {
        ui::Stroke stroke = scene.sketch.thin(Role::Changed);
        stroke.dash = ui::DashPattern{5.0, 3.0}.scaled(scene.sketch.theme().symbol_scale());
        scene.sketch.painter().circle(on_sheet(scene, marks.circle->centre),
                                      marks.circle->radius * scene.camera.scale(), stroke);
    }
    ui::Stroke chosen = scene.sketch.stroke(Role::Changed);
    chosen.width *= 1.5;
    draw_lines(scene, marks.edges, chosen);
    const ui::Color made = scene.sketch.theme().stroke(Role::Created).color;
    for (const topology::FlatPoint& at : marks.places)
        scene.sketch.painter().disc(on_sheet(scene, at), scene.sketch.px(place_radius), made);
}

std::string mesher_note(const discretize::MeshPlayer& player, const PlateOptions& options,
                        const femoop::plane::PlaneModel& model)
{
    const ui::Catalogue& tr = options.tr;
    return tr("step {n} of {total}",
              {{"n", std::to_string(player.place())}, {"total", std::to_string(player.n_steps())}}) +
           "  ·  " + model[player.region()].id + ": " + tr(method_word(player.method()));
}

std::string step_sentence(const discretize::MeshPlayer& player, const ui::Catalogue& tr)
{
    const std::string_view text = player.step() ? sentence_of(*player.step()) : std::string_view();
    return text.empty() ? "" : tr(text);
}

double step_foot_height(const ui::Theme& theme) { return 2.4 * theme.text(Role::Label, ui::Anchor::BottomLeft).size; }

/// In one line, a little smaller if need be, or in two; what is longer is written smaller.
void draw_step_foot(ui::Painter& painter, const std::string& sentence, const ui::Theme& theme, const ui::Box& room)
{
    ui::TextStyle style = theme.text(Role::Label, ui::Anchor::BottomLeft);
    const double height = step_foot_height(theme), margin = 0.8 * style.size;
    const double width = room.width() - 2.0 * margin;
    const double needed = painter.measure(sentence, style).width;
    if (needed > width && needed < 1.15 * width) style.size *= width / needed;
    const auto wrapped = [&] { return ui::wrapped_lines(painter.fonts(), sentence, style, 1.001 * width); };
    std::vector<std::string> lines = wrapped();
    while (lines.size() > 2 && style.size > least_step_size) {
        style.size *= 0.95;
        lines = wrapped();
    }
    const double line_height = 1.1 * style.size;
    double y = room.max.y + (lines.size() > 1 ? height - 0.25 * style.size - line_height : height - margin);
    for (const std::string& line : lines) {
        painter.text({room.min.x + margin, y}, line, style);
        y += line_height;
    }
}

} // namespace plane
