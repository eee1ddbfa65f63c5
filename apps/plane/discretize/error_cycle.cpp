#include "apps/plane/discretize/error_cycle.h"

#include <algorithm>
#include <cmath>

#include "apps/plane/discretize/meshed_drawing.h"
#include "femoop/model/fault/fault.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/result/refined_sizes.h"

namespace discretize {

namespace {

namespace fp = femoop::plane;
using topology::SizeField;

constexpr double aim = 0.5;           // of the error of a mesh, for the next one
constexpr double rounding = 1e-7;     // an error that is
constexpr double least_gain = 0.95;   // of an error, that the next is to be below
constexpr double falls_behind = 0.75; // of the rate of smooth stresses
constexpr double by_far = 0.2;        // of a size, that is smaller by far
constexpr double most_of_last = 1.5;  // unknowns of an even mesh
constexpr double least_spread = 1.3;  // of unknowns, that a rate is told from

std::shared_ptr<const SizeField> field_of(const std::vector<fp::RefinedSize>& sizes, double fp::RefinedSize::*of,
                                          double factor = 1.0)
{
    std::vector<SizeField::Sample> samples;
    for (const fp::RefinedSize& each : sizes) samples.push_back({{each.at.x(), each.at.y()}, factor * (each.*of)});
    return std::make_shared<const SizeField>(std::move(samples), topology::usual_growth);
}

std::shared_ptr<const SizeField> scaled(const SizeField& field, double factor)
{
    std::vector<SizeField::Sample> samples = field.samples();
    for (SizeField::Sample& sample : samples) sample.size *= factor;
    return std::make_shared<const SizeField>(std::move(samples), field.growth());
}

} // namespace

void ErrorCycle::add(const fp::PlaneResults& results, const fp::PlaneCase& result)
{
    const fp::PlaneModel& mesh = results.model();
    const double error = result.error_estimate();
    std::vector<fp::RefinedSize> sizes = fp::refined_sizes(mesh, result.element_errors(), aim * error);
    wanted_ = field_of(sizes, &fp::RefinedSize::wanted);
    for (fp::RefinedSize& each : sizes) each.wanted = wanted_->at({each.at.x(), each.at.y()}); // as they are graded
    growth_ = fp::growth_of_mesh(sizes);
    meshes_.push_back({mesh.elements.size(), results.statistics().dofs, error});
    if (meshes_.size() == 1) {
        first_ = field_of(sizes, &fp::RefinedSize::size);
        uniform_ = meshes_;
        degree_ = 2;
        for (const fp::PlaneElement& element : mesh.elements)
            degree_ = std::min(degree_, fp::complete_degree(element.kind));
    }
    const auto smallest = std::ranges::min_element(sizes, {}, &fp::RefinedSize::size);
    smallest_ = {smallest->at, smallest->size};
    shrinkage_ = smallest->size / first_->at({smallest->at.x(), smallest->at.y()});
}

NextMesh ErrorCycle::next() const
{
    const MeshError& last = meshes_.back();
    NextMesh next{.sizes = {}, .end = {}, .n_unknowns = growth_ * static_cast<double>(last.n_unknowns)};
    if (last.error <= rounding) next.end = CycleEnd::Exact;
    else if (next.n_unknowns > static_cast<double>(most_unknowns_)) next.end = CycleEnd::TooLarge;
    else if (meshes_.size() > 2) {
        const MeshError& before = meshes_[meshes_.size() - 2];
        const bool has_gained = last.error < least_gain * before.error || last.n_unknowns <= before.n_unknowns;
        if (!has_gained) next.end = CycleEnd::NoGain;
    }
    if (!next.end) next.sizes = wanted_;
    return next;
}

void ErrorCycle::compare(const Drawing& drawing, const std::function<bool()>& is_cancelled)
{
    const auto stops = [&] { return is_cancelled && is_cancelled(); };
    while (!stops()) {
        const auto n_halvings = static_cast<double>(uniform_.size());
        const double n_expected = static_cast<double>(uniform_.front().n_unknowns) * std::pow(4.0, n_halvings);
        if (n_expected > most_of_last * static_cast<double>(meshes_.back().n_unknowns)) return;
        const MeshedDrawing mesh(drawing, is_cancelled, scaled(*first_, std::pow(0.5, n_halvings)));
        if (!mesh.is_sound() || stops()) return;
        try {
            const fp::PlaneResults results = fp::analyse(mesh.model());
            uniform_.push_back(
                {mesh.model().elements.size(), results.statistics().dofs, results[load_case_].error_estimate()});
        } catch (const femoop::ModelError&) { // of a mesh that nobody asked for
            return;
        }
    }
}

std::size_t ErrorCycle::memory() const
{
    std::size_t bytes = sizeof *this;
    for (const auto* field : {&sizes_, &first_, &wanted_})
        if (*field) bytes += (*field)->samples().size() * 2 * sizeof(SizeField::Sample); // with their boxes
    return bytes;
}

std::optional<SmallElement> ErrorCycle::singular_place() const
{
    const auto of_uniform = rate(uniform_);
    const bool is_behind = of_uniform && *of_uniform < falls_behind * smooth_rate();
    return is_behind && shrinkage_ < by_far ? std::optional(smallest_) : std::nullopt;
}

std::optional<double> rate(const std::vector<MeshError>& meshes)
{
    if (meshes.size() < 2) return std::nullopt;
    const MeshError &last = meshes.back(), &before = meshes[meshes.size() - 2];
    const double spread = static_cast<double>(last.n_unknowns) / static_cast<double>(before.n_unknowns);
    if (spread < least_spread || last.error <= 0.0 || before.error <= 0.0) return std::nullopt;
    return std::log(before.error / last.error) / std::log(spread);
}

std::optional<fp::RegionId> mapped_region(const fp::PlaneModel& model)
{
    for (std::size_t i = 0; i < model.regions.size(); ++i) {
        const fp::PlaneRegion& region = model.regions[i];
        const std::string& method = region.mesh.method.empty() ? model.mesh.method : region.mesh.method;
        const bool is_map = method == "mapped" || method == "sweep" || method == "trilateral";
        if (is_map && !region.is_hole) return fp::RegionId(i);
    }
    return std::nullopt;
}

} // namespace discretize
