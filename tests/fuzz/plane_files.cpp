// Whatever the bytes, a plane file is read or refused with reasons; what can be read is drawn, meshed and solved, or refused
// in words; a mesh fills its regions, and solves in balance.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <vector>

#include "apps/plane/discretize/meshed_drawing.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/model/fault/fault.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/mesh/mesh_quality.h"

namespace {

using femoop::plane::PlaneModel;

constexpr std::size_t most_curves = 24, most_elements = 4000;
constexpr double most_parts = 60.0;

[[noreturn]] void fail(std::string_view what)
{
    std::cerr << what << '\n';
    std::abort();
}

void require_words(const std::vector<femoop::Fault>& faults)
{
    for (const femoop::Fault& fault : faults)
        if (message(fault).empty()) fail("a fault without words");
}

/// Small enough for a fuzzer's second: no size of its own, few curves and parts.
bool is_small(PlaneModel& model)
{
    if (model.curves.size() > most_curves || model.elements.size() > most_elements) return false;
    model.mesh.size.reset();
    for (auto& region : model.regions) region.mesh.size.reset();
    for (auto& point : model.points) point.size.reset();
    for (const auto& curve : model.curves)
        if (curve.shape)
            for (const auto& division : curve.shape->divide)
                if (!(division.n <= most_parts)) return false;
    return true;
}

void require_filled(const discretize::Drawing& drawing, const PlaneModel& mesh)
{
    double of_mesh = 0.0, of_drawing = 0.0, largest = 0.0;
    for (const auto& size : femoop::plane::region_sizes(mesh)) of_mesh += size.area;
    for (const auto& face : drawing.faces()) {
        if (face.region && !drawing.model()[*face.region].is_hole) of_drawing += face.area;
        largest = std::max(largest, face.area);
    }
    // sides of elements leave out what bulges beyond them, at most a good part of the whole
    if (!(of_mesh > 0.0) || !(of_mesh < 3.0 * of_drawing + largest)) fail("the mesh does not fill its regions");
}

void solve(const PlaneModel& mesh)
{
    if (mesh.elements.size() > most_elements || mesh.n_cases() == 0) return;
    try {
        const femoop::plane::PlaneResults results = femoop::plane::analyse(mesh);
        require_words(results.warnings());
    } catch (const femoop::ModelError& error) {
        if (std::string_view(error.what()).empty()) fail("a refusal without words");
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    femoop::plane::PlaneReading reading = femoop::plane::examine_plane_model(
        {reinterpret_cast<const char*>(data), size});
    require_words(reading.faults);
    if (!femoop::errors_among(reading.faults).empty() || !is_small(reading.model)) return 0;
    if (!reading.model.is_drawn) {
        solve(reading.model);
        return 0;
    }
    const discretize::Drawing drawing(reading.model);
    require_words(drawing.faults());
    if (!drawing.is_sound()) return 0;
    const discretize::MeshedDrawing mesh(drawing);
    require_words(mesh.faults());
    if (!mesh.is_sound()) return 0;
    require_filled(drawing, mesh.model());
    solve(mesh.model());
    return 0;
}
