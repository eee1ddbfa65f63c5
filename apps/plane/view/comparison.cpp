#include "apps/plane/view/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "apps/drawing/sheet/sheet_table.h"
#include "apps/plane/view/error_curve.h"
#include "apps/plane/view/mesh_marks.h"
#include "apps/plane/view/plate_scene.h"
#include "femoop/shape/shape.h"
#include "ui/paint/wrapped_lines.h"

namespace plane {

namespace {

namespace fp = femoop::plane;

/// What is told of a mesh and its results.
struct MeshFigures {
    std::string elements; ///< "336 Q8", "120 Q4 + 2 T3"
    std::size_t n_unknowns = 0;
    double displacement = 0.0; ///< the largest, as a length
    double error = 0.0;
};

std::string elements_text(const fp::PlaneModel& mesh)
{
    std::vector<std::pair<femoop::ShapeKind, std::size_t>> counts;
    for (const fp::PlaneElement& element : mesh.elements) {
        const auto found = std::ranges::find(counts, element.kind, [](const auto& count) { return count.first; });
        if (found == counts.end()) counts.emplace_back(element.kind, 1);
        else ++found->second;
    }
    std::ranges::stable_sort(counts, std::greater<>(), [](const auto& count) { return count.second; });
    std::string text;
    for (const auto& [kind, n] : counts)
        text += (text.empty() ? "" : " + ") + std::to_string(n) + " " + std::string(name(kind));
    return text;
}

MeshFigures figures_of(const fp::PlaneResults& results, const fp::PlaneCase& result)
{
    return {.elements = elements_text(results.model()),
            .n_unknowns = results.statistics().dofs,
            .displacement = largest_displacement(results.model(), result),
            .error = result.error_estimate()};
}

/// The kept ones first.
std::array<MeshFigures, 2> figures_of(const PlateInput& input)
{
    return {figures_of(*input.kept_results, *input.kept_result), figures_of(*input.results, *input.result)};
}

/// "+12.3 %": of the displacement, from the kept one.
std::string change_text(const std::array<MeshFigures, 2>& of, const ui::NumberFormat& numbers)
{
    if (of[0].displacement == 0.0) return "–";
    const double change = of[1].displacement / of[0].displacement - 1.0;
    const std::string text = ui::with_minus_signs(percent_text(std::abs(change) < 5e-6 ? 0.0 : change, numbers));
    return change >= 5e-6 ? "+" + text : text;
}

} // namespace

tabular::Table comparison_table(const PlateInput& input, const PlateOptions& options)
{
    using tabular::Alignment;
    const ui::Catalogue& tr = options.tr;
    const ui::DisplayUnits units = display_units(input.model, options);
    const std::array<MeshFigures, 2> figures = figures_of(input);
    tabular::Table table({{""},
                          {tr("elements"), {}, Alignment::Right},
                          {tr("unknowns"), {}, Alignment::Right},
                          {tr("largest displacement"), units.unit(ui::Measure::Displacement).name, Alignment::Right},
                          {tr("error"), {}, Alignment::Right}});
    const std::array names{options.is_beside ? tr("kept") : tr("kept (dashes)"), tr("now")};
    for (std::size_t i = 0; i < figures.size(); ++i)
        table.add_row({names[i], figures[i].elements, std::to_string(figures[i].n_unknowns),
                       units.number(figures[i].displacement, ui::Measure::Displacement),
                       percent_text(figures[i].error, options.numbers)});
    table.add_row({tr("change"), "", "", change_text(figures, options.numbers), ""});
    table.n_sums = 1;
    return table;
}

std::vector<std::string> comparison_sentences(const PlateInput& input, const PlateOptions& options)
{
    const ui::Catalogue& tr = options.tr;
    const ui::DisplayUnits units = display_units(input.model, options);
    const std::array<MeshFigures, 2> figures = figures_of(input);
    const auto sentence = [&](std::string_view words, const MeshFigures& of) {
        return tr(words, {{"elements", of.elements},
                          {"n", std::to_string(of.n_unknowns)},
                          {"displacement", units.text(of.displacement, ui::Measure::Displacement)},
                          {"error", percent_text(of.error, options.numbers)}});
    };
    return {
        sentence(ui::translatable("kept: {elements}, {n} unknowns, largest displacement {displacement}, error {error}"),
                 figures[0]),
        sentence(ui::translatable("now: {elements}, {n} unknowns, largest displacement {displacement}, error {error}"),
                 figures[1]),
        tr("the largest displacement has changed by {change}", {{"change", change_text(figures, options.numbers)}})};
}

std::string mesh_title(bool is_kept, const PlateInput& input, const PlateOptions& options)
{
    const std::string elements = elements_text(is_kept ? input.kept_results->model() : input.results->model());
    return is_kept ? options.tr("kept: {elements}", {{"elements", elements}})
                   : options.tr("now: {elements}", {{"elements", elements}});
}

void draw_comparison(ui::Painter& painter, const PlateInput& input, const PlateOptions& options, const ui::Box& box)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const ui::Theme theme(options.theme);
    ui::TextStyle title = theme.text(ui::Role::Label, ui::Anchor::TopLeft);
    title.weight = ui::Weight::Bold;
    const ui::ClipScope clip(painter, box);
    const double width = box.width() - 28.0;
    ui::Point corner = box.min + ui::Point{14.0, 4.0};
    const auto write = [&](const std::string& text, const ui::TextStyle& style, double line_height) {
        for (const std::string& line : ui::wrapped_lines(painter.fonts(), text, style, width)) {
            painter.text(corner, line, style);
            corner.y += line_height * style.size;
        }
    };
    write(options.tr("Compared with the results that were kept"), title, 1.6);
    const tabular::Table rows = comparison_table(input, options);
    const drawing::SheetTable table([&](std::size_t) { return rows; },
                                    {.width = width, .height = box.max.y - corner.y - 8.0}, theme, painter.fonts());
    if (table.width() <= width) return table.draw(painter, corner);
    ui::TextStyle words = theme.text(ui::Role::Label, ui::Anchor::TopLeft);
    words.size = theme.type().small;
    for (const std::string& sentence : comparison_sentences(input, options)) write(sentence, words, 1.35);
}

void draw_kept_shape(const PlateScene& scene, const fp::PlaneModel& mesh, const std::vector<Eigen::Vector2d>& places)
{
    ui::Stroke stroke = scene.sketch.thin(ui::Role::FaintLabel);
    stroke.color = ui::with_opacity(scene.sketch.theme().series(5).stroke.color, 0.9);
    stroke.dash = ui::DashPattern{6.0, 4.0}.scaled(scene.sketch.theme().symbol_scale());
    ui::Stroke of_sides = stroke;
    of_sides.color = ui::with_opacity(stroke.color, 0.4);
    if (scene.shows(PlateShow::Mesh)) draw_sides(scene, mesh, places, of_sides);
    stroke.width *= 1.6;
    const PlateOutline outline = joined(outline_of(mesh, places, 0.05 / scene.camera.scale()));
    for (const OutlinedPiece& piece : outline.pieces)
        scene.sketch.polyline(scene.on_sheet(piece.line), stroke, drawing::Clearance::Soft);
}

} // namespace plane
