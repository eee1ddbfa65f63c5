#include "apps/plane/document/solution.h"

#include <algorithm>
#include <iterator>

#include "apps/plane/discretize/fault_place.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/plane/check/plane_check.h"

namespace plane {

using femoop::Fault;

namespace {

/// The curves and the places of the regions alone, with nothing that could be wrong besides.
PlaneModel bare_model(PlaneModel model)
{
    model.load_cases.clear();
    model.combinations.clear();
    model.expected.clear();
    model.mesh = {};
    for (auto& point : model.points) {
        point.support.reset();
        point.size.reset();
    }
    for (auto& curve : model.curves) {
        curve.support.reset();
        curve.tie = {};
        if (curve.shape) curve.shape->divide.clear();
    }
    model.materials = {{.id = "any", .E = 1.0, .nu = {}, .G = {}, .alpha = {}, .density = {}, .fy = {}}};
    for (auto& region : model.regions) {
        region.material = MaterialId(0U);
        region.thickness = model.analysis == femoop::StressState::Axisymmetric ? std::nullopt
                                                                               : std::optional(femoop::Quantity(1.0));
        region.mesh = {};
    }
    return model;
}

std::vector<Fault> errors_of_curves(const std::vector<Fault>& faults)
{
    std::vector<Fault> errors;
    std::ranges::copy_if(faults, std::back_inserter(errors),
                         [](const Fault& fault) { return is_error(fault) && !discretize::is_of_faces(fault.kind); });
    return errors;
}

} // namespace

Solution::Solution(const Document& document) : model_(std::make_unique<const PlaneModel>(document.model))
{
    faults_ = femoop::plane::check(*model_);
    if (std::ranges::any_of(faults_, femoop::is_error)) {
        bare_ = std::make_unique<const PlaneModel>(bare_model(*model_));
        curve_errors_ = femoop::errors_among(femoop::plane::check(*bare_));
    }
    refused_ = femoop::errors_among(faults_);
    if (curve_errors_.empty()) draw(bare_ ? *bare_ : *model_);
    std::stable_partition(faults_.begin(), faults_.end(), femoop::is_error);
    is_sound_ = std::ranges::none_of(faults_, femoop::is_error);
}

void Solution::draw(const PlaneModel& model)
{
    drawing_ = std::make_unique<const discretize::Drawing>(model);
    faults_.insert(faults_.end(), drawing_->faults().begin(), drawing_->faults().end());
    curve_errors_ = errors_of_curves(drawing_->faults());
    refused_.insert(refused_.end(), curve_errors_.begin(), curve_errors_.end());
    if (curve_errors_.empty()) dispute_ = dispute_in(*model_, *drawing_);
    else drawing_.reset();
}

} // namespace plane
