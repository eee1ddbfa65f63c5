#include "apps/cli/solid_file.h"

#include <utility>

#include "apps/cli/model_input.h"
#include "apps/cli/output_file.h"
#include "apps/cli/picture_file.h"
#include "femoop/io/file_text.h"
#include "topology/mesh/mesh_file.h"
#include "topology/script/script_writer.h"
#include "topology/text/line_error.h"

namespace cli {

namespace {

using topology::LineError;
using topology::Mesh;
using topology::NamedSolid;

NamedSolid named(topology::Solid solid)
{
    NamedSolid part{.name = "s1", .solid = std::move(solid), .journal = {}, .names = {}};
    for (const topology::VertexId v : part.solid.vertices()) part.names.vertices.give(v, topology::table_name(v));
    for (const topology::FaceId f : part.solid.faces()) part.names.faces.give(f, topology::table_name(f));
    return part;
}

std::vector<NamedSolid> solids_of_script(std::string_view text)
{
    topology::ScriptRunner runner;
    run_script(runner, text, {});
    std::vector<NamedSolid> solids;
    for (const NamedSolid& solid : runner.solids())
        if (solid.is_alive()) solids.push_back(solid);
    return solids;
}

std::vector<NamedSolid> read(const std::string& kind, std::string_view text)
{
    if (kind == ".eul") return solids_of_script(text);
    return {named(topology::solid_of(kind == ".off" ? topology::read_off(text) : topology::read_obj(text)))};
}

void append(Mesh& all, Mesh part)
{
    const auto offset = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (std::vector<std::uint32_t>& polygon : part.polygons) {
        for (std::uint32_t& i : polygon) i += offset;
        all.polygons.push_back(std::move(polygon));
    }
}

std::string written(const std::string& kind, const std::vector<NamedSolid>& solids)
{
    if (kind == ".eul") {
        std::string text;
        for (const NamedSolid& solid : solids) text += topology::construction_script(solid);
        return text;
    }
    Mesh all;
    for (const NamedSolid& solid : solids) append(all, topology::mesh_of(solid.solid));
    return kind == ".off" ? topology::write_off(all) : topology::write_obj(all);
}

} // namespace

bool is_solid_file(const std::filesystem::path& path)
{
    const std::string kind = kind_of(path);
    return kind == ".eul" || kind == ".obj" || kind == ".off";
}

std::string text_of(const std::string& file, const ui::Catalogue& tr)
{
    if (file == "-") return standard_input(tr);
    femoop::FileText found = femoop::file_text(file);
    if (found.fault) throw UsageError(femoop::message(*found.fault, tr));
    return std::move(found.text);
}

std::vector<NamedSolid> load_solids(const std::string& file, const ui::Catalogue& tr)
{
    const std::string text = text_of(file, tr);
    try {
        return read(kind_of(file), text);
    } catch (const LineError& fault) {
        throw UsageError(display_name(file, tr) + ": " + fault.sentence(tr));
    }
}

void save_solids(const std::string& file, const std::vector<NamedSolid>& solids, const ui::Catalogue& tr)
{
    write_file(file, written(kind_of(file), solids), tr);
}

} // namespace cli
