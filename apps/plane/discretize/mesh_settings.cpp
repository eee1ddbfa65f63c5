#include "apps/plane/discretize/mesh_settings.h"

#include <algorithm>
#include <array>
#include <utility>

namespace discretize {

namespace {

using femoop::plane::MeshOptions;
using topology::Diagonal;

constexpr double usual_size = 0.05; // of the diagonal of the drawing's box

topology::FlatBox box_of(const Drawing& drawing)
{
    topology::FlatBox box;
    const topology::PlanarSubdivision& plane = drawing.subdivision();
    for (const topology::EdgeId e : plane.solid().edges()) {
        const topology::CurvePart& part = plane.part(e);
        const topology::FlatBox of_edge = plane.curve(part.curve).box(part.span);
        box.add(of_edge.low);
        box.add(of_edge.high);
    }
    return box;
}

Diagonal diagonal_named(std::string_view name)
{
    using Named = std::pair<std::string_view, Diagonal>;
    static constexpr std::array<Named, 4> all{Named{"right", Diagonal::Right}, Named{"left", Diagonal::Left},
                                              Named{"cross", Diagonal::Cross}, Named{"shortest", Diagonal::Shortest}};
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.first == name; });
    return found == all.end() ? Diagonal::Right : found->second;
}

MeshSettings settings_of(const MeshOptions& own, const MeshOptions& usual, double size)
{
    MeshSettings settings;
    settings.size = size;
    for (const MeshOptions* const options : {&usual, &own}) {
        if (!options->method.empty()) settings.method = options->method;
        if (options->element) settings.element = *options->element;
        if (options->size) settings.size = *options->size;
        if (options->min_angle) settings.min_angle = *options->min_angle;
        if (!options->diagonal.empty()) settings.diagonal = diagonal_named(options->diagonal);
        if (!options->corners.empty()) settings.corners = options->corners;
    }
    return settings;
}

} // namespace

std::vector<MeshSettings> settings_of(const Drawing& drawing, const std::vector<FaceOutline>& outlines,
                                      const std::shared_ptr<const topology::SizeField>& field)
{
    const double size = usual_size * box_of(drawing).diagonal();
    std::vector<MeshSettings> all;
    all.reserve(outlines.size());
    for (const FaceOutline& outline : outlines)
        all.push_back(settings_of(drawing.model()[outline.region].mesh, drawing.model().mesh, size));
    for (MeshSettings& settings : all) {
        settings.field = field;
        if (field) settings.size = field->greatest();
    }
    return all;
}

} // namespace discretize
