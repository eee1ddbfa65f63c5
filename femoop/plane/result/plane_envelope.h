#pragma once

#include <cstddef>
#include <vector>

#include "femoop/plane/analysis/plane_results.h"
#include "femoop/plane/analysis/result_reader.h"
#include "femoop/result/envelope.h"

namespace femoop::plane {

/// The largest and the smallest of a stress component in a region, each with its case and its place.
struct GoverningPlaces {
    struct Extreme : PlaneExtreme {
        CaseId load_case;
    };
    Extreme max, min;
};

/// Largest and smallest of every result of a plane model over several load cases and combinations, with the one that
/// governs; of equal ones the first.
///
/// Accuracy  each case's own value is compared, so that s1 and mises are of one state, never of components that belong
///           to different cases
class PlaneEnvelope {
public:
    /// \throws std::invalid_argument for an empty list
    PlaneEnvelope(const PlaneResults& results, const std::vector<CaseId>& cases);

    const std::vector<CaseId>& ids() const { return ids_; }
    const std::vector<PlaneCase>& cases() const { return cases_; } ///< in the same order

    /// Of what `value` makes of each case.
    template <class Value> GoverningRange range(const Value& value) const
    {
        return governing_range(ids_, [&](std::size_t i) { return value(cases_[i]); });
    }
    /// Of smoothed stresses over the nodes of a region.
    GoverningPlaces extremes(RegionId region, PlaneComponent component) const;

private:
    std::vector<CaseId> ids_;
    std::vector<PlaneCase> cases_;
};

} // namespace femoop::plane
