#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/document/document.h"
#include "apps/plane/document/regions.h"
#include "femoop/model/fault/fault.h"

namespace plane {

/// What follows from a document: how its curves divide the plane, and what is wrong with it. A pure function of it. It
/// keeps the model that it is of, which the drawing refers to.
class Solution {
public:
    explicit Solution(const Document& document);

    const PlaneModel& model() const { return *model_; }
    /// By its curves and the places of its regions; without the loads, supports and materials where one of those has an
    /// error. Null where the curves cannot be drawn.
    const discretize::Drawing* drawing() const { return drawing_.get(); }
    /// Everything wrong with it, errors before warnings.
    const std::vector<femoop::Fault>& faults() const { return faults_; }
    bool is_sound() const { return is_sound_; } ///< no fault is an error
    /// Errors of the curves themselves: faces cannot be told.
    const std::vector<femoop::Fault>& curve_errors() const { return curve_errors_; }
    /// Errors that no edit may bring: of single entries, such as a thickness below 0, and of curves.
    const std::vector<femoop::Fault>& refused() const { return refused_; }
    const std::optional<Dispute>& dispute() const { return dispute_; }

private:
    void draw(const PlaneModel& model);

    std::unique_ptr<const PlaneModel> model_;
    std::unique_ptr<const PlaneModel> bare_; ///< the drawing's, where the model has other errors
    std::unique_ptr<const discretize::Drawing> drawing_;
    std::vector<femoop::Fault> faults_, curve_errors_, refused_;
    std::optional<Dispute> dispute_;
    bool is_sound_ = false;
};

} // namespace plane
