#include "apps/cli/plane_input.h"

#include <algorithm>

#include "apps/cli/solid_file.h"
#include "apps/plane/discretize/further_faults.h"
#include "apps/plane/view/singular_notice.h"
#include "femoop/plane/mesh/locator.h"
#include "topology/text/line_error.h"

namespace cli {

namespace fp = femoop::plane;

std::unique_ptr<const discretize::Drawing> drawing_of(femoop::plane::PlaneReading& reading)
{
    if (!reading.model.is_drawn) return nullptr;
    if (!reading.is_sound()) {
        const std::vector<femoop::Fault> further = discretize::further_faults(reading.model, reading.faults);
        reading.faults.insert(reading.faults.end(), further.begin(), further.end());
        return nullptr;
    }
    auto drawing = std::make_unique<const discretize::Drawing>(reading.model);
    reading.faults.insert(reading.faults.end(), drawing->faults().begin(), drawing->faults().end());
    return drawing;
}

outline::Outline load_outline(const std::string& file, const ui::Catalogue& tr)
{
    const std::string text = text_of(file, tr);
    try {
        return outline::read_outline(file, text);
    } catch (const topology::LineError& fault) {
        throw UsageError(file + ": " + fault.sentence(tr));
    }
}

void tell_singular_corners(const discretize::Drawing& drawing, const std::string& file,
                           const ::plane::PlateOptions& options, const Console& console)
{
    const auto notice = ::plane::singular_notice(drawing, options);
    if (notice) console.message(console.tr()("{file}: notice: {sentence}", {{"file", file}, {"sentence", *notice}}));
}

PlaneInput::PlaneInput(femoop::plane::PlaneReading& reading, Depth depth)
    : reading_(reading), drawing_(drawing_of(reading))
{
    if (depth == Depth::Drawing || !drawing_ || !drawing_->is_sound()) return;
    mesh_.emplace(*drawing_);
    const std::vector<femoop::Fault> of_drawing = reading.faults;
    for (const femoop::Fault& fault : mesh_->faults()) // which has what the drawing is loaded by, and its faults again
        if (std::ranges::find(of_drawing, fault) == of_drawing.end()) reading.faults.push_back(fault);
}

std::optional<femoop::plane::DrawnChecks> PlaneInput::checks() const
{
    if (!drawing_) return std::nullopt;
    return femoop::plane::DrawnChecks{
        .count_or_area = [this](const femoop::plane::PlaneExpected& check) { return drawing_->read(check); },
        .of_mesh = mesh_ ? &mesh_->checks() : nullptr};
}

std::optional<std::vector<fp::ShownPoint>> PlaneInput::points_in_material() const
{
    if (!mesh_) return std::nullopt;
    std::optional<fp::Locator> locator; // of a large mesh it takes a while, and most points are nodes
    std::vector<fp::ShownPoint> points;
    for (std::size_t i = 0; i < reading_.model.points.size(); ++i) {
        const fp::PlanePoint& point = reading_.model.points[i];
        fp::ShownPoint shown{.id = point.id, .node = mesh_->node(femoop::NodeId(i)), .at = {point.at[0], point.at[1]}};
        if (!shown.node && !locator) locator.emplace(mesh_->model());
        if (shown.node || !locator->find(shown.at).empty()) points.push_back(std::move(shown));
    }
    return points;
}

std::vector<std::string> PlaneInput::methods() const
{
    std::vector<std::string> methods;
    if (mesh_)
        for (const discretize::RegionReport& report : mesh_->reports()) methods.push_back(report.method);
    return methods;
}

} // namespace cli
