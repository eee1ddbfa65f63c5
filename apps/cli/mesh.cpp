#include "apps/cli/mesh.h"

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <variant>

#include "apps/cli/argument.h"
#include "apps/cli/model_input.h"
#include "apps/cli/plane_input.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/tabular/plain_text.h"

namespace cli {

namespace {

using discretize::Drawing;
using discretize::DrawnFace;
using femoop::JsonWriter;

/// "(0.5, 0.25)", in Portuguese "(0,5; 0,25)".
std::string place_text(const topology::FlatPoint& at, const ui::Catalogue& tr)
{
    const std::string_view comma = femoop::decimal_mark(tr) == ',' ? "; " : ", ";
    return "(" + femoop::six_digits(at.x, tr) + std::string(comma) + femoop::six_digits(at.y, tr) + ")";
}

std::string faces_json(const Drawing& drawing)
{
    const topology::PlanarCounts counts = drawing.subdivision().counts();
    JsonWriter json;
    femoop::begin_output(json, drawing.model().units);
    json.member("vertices", counts.vertices).member("edges", counts.edges).member("regions", counts.regions);
    json.member("components", counts.components).member("dangling", counts.dangling);
    json.key("faces").begin_array(JsonWriter::Layout::Block);
    for (const DrawnFace& face : drawing.faces()) {
        json.begin_object().key("region");
        if (face.region) json.value(drawing.model()[*face.region].id);
        else json.null();
        json.member("area", face.area).member("perimeter", face.perimeter).member("holes", face.n_holes);
        json.key("inside").begin_array().value(face.inside.x).value(face.inside.y).end().end();
    }
    json.end().end();
    return json.take();
}

std::string faces_text(const Drawing& drawing, const ui::Catalogue& tr)
{
    const topology::PlanarCounts counts = drawing.subdivision().counts();
    const femoop::Units& units = drawing.model().units;
    std::string text = tr("{vertices} vertices, {edges} edges, {regions} regions, {components} components",
                          {{"vertices", std::to_string(counts.vertices)},
                           {"edges", std::to_string(counts.edges)},
                           {"regions", std::to_string(counts.regions)},
                           {"components", std::to_string(counts.components)}});
    if (counts.dangling > 0)
        text += ", " + tr("{dangling} dangling edges", {{"dangling", std::to_string(counts.dangling)}});
    text += "\n";
    if (drawing.faces().empty()) return text;
    tabular::Table table({{tr("face")},
                          {tr("region")},
                          {tr("area"), femoop::unit_text({.length = 2}, units)},
                          {tr("perimeter"), femoop::unit_text(femoop::dimension::length, units)},
                          {tr("holes")},
                          {tr("place inside"), femoop::unit_text(femoop::dimension::length, units)}});
    for (std::size_t i = 0; i < drawing.faces().size(); ++i) {
        const DrawnFace& face = drawing.faces()[i];
        const std::string region = face.region ? drawing.model()[*face.region].id : "-";
        table.add_row({std::to_string(i + 1), region, face.area, face.perimeter, std::to_string(face.n_holes),
                       place_text(face.inside, tr)});
    }
    return text + "\n" + tabular::plain_text(table, {2, femoop::decimal_mark(tr)});
}

class MeshRegions : public Subcommand {
public:
    std::string_view name() const override { return "mesh"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(CLI::App& app, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    std::string file_;
    bool shows_regions_ = false, is_json_ = false;
};

HelpText MeshRegions::help(const ui::Catalogue& tr) const
{
    return {
        tr("recognise the regions that a plane model's curves close"),
        tr("Draws the curves of a plane model: lines, arcs, ellipses, Bézier curves and splines that may cross, touch, "
           "overlap and end anywhere. Prints how many vertices, edges, regions and connected components they make, "
           "and of each bounded face its area, its perimeter, its holes and a place inside it, the largest face "
           "first. The mesh itself is not built yet: ask for --regions."),
        {{"cremona mesh examples/plate.json --regions", tr("The faces of a drawing, as a table.")},
         {"cremona mesh examples/plate.json --regions --json", tr("The faces of a drawing, for a program.")}}};
}

void MeshRegions::declare(CLI::App& app, const ui::Catalogue& tr)
{
    app.add_option("FILE", file_, tr("the model file; - is standard input"))->option_text(" ");
    app.add_flag("--regions", shows_regions_,
                 tr("print vertices, edges and components of the drawing, and its faces, without a mesh"));
    app.add_flag("--json", is_json_, tr("print JSON with every digit instead of tables"));
}

ExitStatus MeshRegions::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (file_.empty()) throw no_file("mesh", tr);
    femoop::AnyReading any = examine_any(file_, tr);
    auto* const reading = std::get_if<femoop::plane::PlaneReading>(&any);
    const std::string shown = display_name(file_, tr);
    if (reading == nullptr) {
        console.report(shown, std::get<femoop::ModelReading>(any).faults);
        if (!std::get<femoop::ModelReading>(any).is_sound()) return ExitStatus::BadInput;
        throw UsageError(tr("`mesh`: a structure of members has no regions; give a plane model"));
    }
    const auto drawing = drawing_of(*reading);
    console.report(shown, reading->faults);
    if (!reading->is_sound()) return ExitStatus::BadInput;
    if (!drawing) throw UsageError(tr("`mesh`: the file has its mesh already; give one without \"elements\""));
    if (!shows_regions_) {
        console.report(shown, {{femoop::FaultKind::PlaneDrawingNotBuilt, {}}});
        return ExitStatus::BadInput;
    }
    console.print(is_json_ ? faces_json(*drawing) : faces_text(*drawing, tr));
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> mesh_command() { return std::make_unique<MeshRegions>(); }

} // namespace cli
