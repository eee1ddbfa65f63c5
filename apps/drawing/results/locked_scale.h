#pragma once

#include "femoop/model/ids.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

#include <array>
#include <optional>

namespace drawing {

/// The largest values of a solved case, by which diagrams and displacements keep their scale while a number or a part
/// of the structure is dragged: one sees them grow.
struct LockedScale {
    femoop::CaseId load_case;                                  ///< others have a scale of their own
    std::array<double, femoop::n_member_components> largest{}; ///< section forces, absolute; 0 of mere rounding
    double displacement = 0.0;                                 ///< the largest of any point

    double operator[](femoop::MemberComponent component) const { return largest[static_cast<std::size_t>(component)]; }
};

/// Nothing when the results lack the case.
std::optional<LockedScale> locked_scale(const femoop::Model& model, const femoop::Results& results, femoop::CaseId id);

/// The value that a scale is made for: the locked one, unless it is 0 or the picture would grow beyond bounds.
double scaling_value(double locked, double now);

} // namespace drawing
