#include "apps/cli/mesh.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "apps/cli/argument.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_file.h"
#include "apps/cli/picture_file.h"
#include "apps/cli/plane_input.h"
#include "apps/plane/view/plate_picture.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/plane/mesh_vtu.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/plane/mesh/mesh_quality.h"
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
    std::string text = tr("vertices: {vertices}, edges: {edges}, regions: {regions}, components: {components}",
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

/// A region of a mesh, with its angles.
struct RegionMesh {
    std::string id;
    discretize::RegionReport report;
    std::size_t n_nodes = 0;
    femoop::plane::RegionSize size;
    femoop::plane::MeshQuality quality;
};

std::vector<RegionMesh> region_meshes(const discretize::MeshedDrawing& mesh)
{
    const femoop::plane::PlaneModel& model = mesh.model();
    const std::vector<femoop::plane::RegionSize> sizes = femoop::plane::region_sizes(model);
    std::vector<std::vector<bool>> is_used(model.regions.size());
    std::vector<RegionMesh> all;
    for (std::size_t i = 0; i < model.regions.size(); ++i) {
        is_used[i].resize(model.points.size());
        all.push_back({model.regions[i].id, mesh.reports()[i], 0, sizes[i],
                       femoop::plane::mesh_quality(model, femoop::plane::RegionId(i))});
    }
    for (const femoop::plane::PlaneElement& element : model.elements)
        for (const femoop::NodeId node : element.points) {
            auto used = is_used[element.region.index][node.index];
            if (!used) ++all[element.region.index].n_nodes;
            used = true;
        }
    return all;
}

void write_quality(JsonWriter& json, const femoop::plane::MeshQuality& quality)
{
    json.member("min_angle", quality.min_angle).member("max_angle", quality.max_angle);
    json.member("min_jacobian", quality.min_jacobian);
}

std::string mesh_json(const discretize::MeshedDrawing& mesh)
{
    const femoop::plane::PlaneModel& model = mesh.model();
    JsonWriter json;
    femoop::begin_output(json, model.units);
    json.key("mesh").begin_object().member("nodes", model.points.size()).member("elements", model.elements.size());
    write_quality(json, femoop::plane::mesh_quality(model));
    json.end().key("regions").begin_object(JsonWriter::Layout::Block);
    for (const RegionMesh& region : region_meshes(mesh)) {
        json.key(region.id).begin_object().member("method", region.report.method).member("nodes", region.n_nodes);
        json.member("elements", region.size.n_elements).member("area", region.size.area);
        write_quality(json, region.quality);
        json.member("seconds", region.report.seconds).end();
    }
    json.end().end();
    return json.take();
}

std::string mesh_text(const discretize::MeshedDrawing& mesh, const ui::Catalogue& tr)
{
    const femoop::plane::PlaneModel& model = mesh.model();
    std::string text = tr("{nodes} nodes, {elements} elements", {{"nodes", std::to_string(model.points.size())},
                                                                 {"elements", std::to_string(model.elements.size())}});
    tabular::Table table({{tr("region")},
                          {tr("method")},
                          {tr("nodes")},
                          {tr("elements")},
                          {tr("area"), femoop::unit_text({.length = 2}, model.units)},
                          {tr("smallest angle"), "°"},
                          {tr("largest angle"), "°"},
                          {tr("least scaled Jacobian")},
                          {tr("time"), "s"}});
    for (const auto& [id, report, n_nodes, size, quality] : region_meshes(mesh))
        table.add_row({id, report.method, std::to_string(n_nodes), std::to_string(size.n_elements), size.area,
                       femoop::six_digits(quality.min_angle, tr), femoop::six_digits(quality.max_angle, tr),
                       femoop::six_digits(quality.min_jacobian, tr), femoop::six_digits(report.seconds, tr)});
    return text + "\n\n" + tabular::plain_text(table, {2, femoop::decimal_mark(tr)});
}

class MeshCommand : public Subcommand {
public:
    std::string_view name() const override { return "mesh"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void require_possible_output(const ui::Catalogue& tr) const;
    void write(const PlaneInput& input, const std::string& out, const ui::Catalogue& tr) const;

    std::string file_;
    std::optional<std::string> out_;
    bool shows_regions_ = false, is_json_ = false;
};

HelpText MeshCommand::help(const ui::Catalogue& tr) const
{
    return {
        tr("recognise the regions that a plane model's curves close, and mesh them"),
        tr("Draws the curves of a plane model: lines, arcs, ellipses, Bézier curves and splines that may cross, touch, "
           "overlap and end anywhere; and fills the regions that they close with elements, as \"mesh\" and \"divide\" of "
           "the file say. Prints of each region how many nodes and elements it has, their angles and Jacobians, and the "
           "time it took. With --regions, instead: how many vertices, edges, regions and connected components there "
           "are, and of each bounded face its area, its perimeter, its holes and a place inside it, the largest first."),
        {{"cremona mesh examples/plate.json", tr("The mesh of a plate with a hole.")},
         {"cremona mesh examples/plate.json -o meshed.json", tr("The same model with its elements, to be solved.")},
         {"cremona mesh examples/plate.json --regions", tr("The faces of a drawing, as a table.")}}};
}

void MeshCommand::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", file_, tr("the model file; - is standard input")).option_text(" ");
    options
        .add_option(
            "-o,--output", out_,
            tr("write the mesh to this file: .json is the model with its elements, .vtu for ParaView, .svg, .pdf or .png a picture"))
        .option_text("FILE");
    options.add_flag("--regions", shows_regions_,
                     tr("print vertices, edges and components of the drawing, and its faces, without a mesh"));
    options.add_flag("--json", is_json_, tr("print JSON with every digit instead of tables"));
}

void MeshCommand::require_possible_output(const ui::Catalogue& tr) const
{
    if (!out_) return;
    if (shows_regions_) throw UsageError(tr("--regions makes no mesh to be written; take --output away"));
    const std::string kind = kind_of(*out_);
    if (kind != ".json" && kind != ".vtu" && !is_picture(*out_))
        throw UsageError(tr("--output: found {file}, wanted a name that ends in .json, .vtu, .svg, .pdf or .png",
                            {{"file", '"' + *out_ + '"'}}));
}

void MeshCommand::write(const PlaneInput& input, const std::string& out, const ui::Catalogue& tr) const
{
    if (kind_of(out) == ".vtu") return write_file(out, femoop::plane::mesh_vtu(input.model()), tr);
    if (!is_picture(out)) return write_file(out, femoop::plane::write_plane_model(input.model()), tr);
    const ::plane::PlateInput shown{
        .model = input.drawing()->model(), .drawing = input.drawing(), .mesh = &input.model()};
    ::plane::PlateOptions options;
    options.show = {};
    for (const char* const word : {"geometry", "regions", "mesh"})
        options.show = options.show | *::plane::plate_shown(word);
    options.tr = tr;
    write_picture(
        {.path = out}, {.color = ::plane::background(options), .title = shown.model.title},
        [&](ui::Painter& painter) { ::plane::draw(painter, shown, options); }, tr);
}

ExitStatus MeshCommand::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (file_.empty()) throw no_file("mesh", tr);
    require_possible_output(tr);
    femoop::AnyReading any = examine_any(file_, tr);
    auto* const reading = std::get_if<femoop::plane::PlaneReading>(&any);
    const std::string shown = display_name(file_, tr);
    if (reading == nullptr) {
        console.report(shown, std::get<femoop::ModelReading>(any).faults);
        if (!std::get<femoop::ModelReading>(any).is_sound()) return ExitStatus::BadInput;
        throw UsageError(tr("`mesh`: a structure of members has no regions; give a plane model"));
    }
    const PlaneInput input(*reading, shows_regions_ ? PlaneInput::Depth::Drawing : PlaneInput::Depth::Mesh);
    console.report(shown, reading->faults);
    if (!reading->is_sound()) return ExitStatus::BadInput;
    if (input.drawing() == nullptr)
        throw UsageError(tr("`mesh`: the file has its mesh already; give one without \"elements\""));
    if (shows_regions_) {
        console.print(is_json_ ? faces_json(*input.drawing()) : faces_text(*input.drawing(), tr));
        return ExitStatus::Done;
    }
    if (out_) write(input, *out_, tr);
    console.print(is_json_ ? mesh_json(*input.mesh()) : mesh_text(*input.mesh(), tr));
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> mesh_command() { return std::make_unique<MeshCommand>(); }

} // namespace cli
