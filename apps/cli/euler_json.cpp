#include "apps/cli/euler_json.h"

#include <algorithm>

#include "femoop/io/json/json_writer.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"

namespace cli {

using topology::NamedSolid;
using topology::ScriptRunner;

namespace {

std::vector<int> loop_lengths(const topology::Solid& solid)
{
    std::vector<int> lengths;
    for (const topology::LoopId l : solid.loops()) {
        int n = 0;
        for ([[maybe_unused]] const topology::HalfEdgeId h : solid.chain(l)) ++n;
        lengths.push_back(n);
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

void write_solid(femoop::JsonWriter& json, const NamedSolid& solid)
{
    const topology::EulerCounts counts = topology::euler_counts(solid.solid);
    json.key(solid.name)
        .begin_object()
        .member("V", counts.V)
        .member("E", counts.E)
        .member("F", counts.F)
        .member("L", counts.L)
        .member("S", counts.S)
        .member("G", counts.G)
        .member("euler", static_cast<int>(counts.formula()))
        .member("valid", !topology::why_not_valid(solid.solid))
        .key("loops")
        .begin_array();
    for (const int length : loop_lengths(solid.solid)) json.value(length);
    json.end().end();
}

} // namespace

std::vector<NamedSolid> living_solids(const ScriptRunner& runner)
{
    std::vector<NamedSolid> solids;
    for (const NamedSolid& solid : runner.solids())
        if (solid.is_alive()) solids.push_back(solid);
    return solids;
}

std::string euler_json(const std::vector<NamedSolid>& solids, std::size_t n_steps)
{
    femoop::JsonWriter json;
    json.begin_object().key("solids").begin_object();
    for (const NamedSolid& solid : solids) write_solid(json, solid);
    json.end().member("steps", n_steps).end();
    return json.take();
}

} // namespace cli
