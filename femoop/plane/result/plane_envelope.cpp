#include "femoop/plane/result/plane_envelope.h"

#include <stdexcept>

namespace femoop::plane {

PlaneEnvelope::PlaneEnvelope(const PlaneResults& results, const std::vector<CaseId>& cases) : ids_(cases)
{
    if (cases.empty()) throw std::invalid_argument("PlaneEnvelope: of no case");
    for (const CaseId id : cases) cases_.push_back(results[id]);
}

GoverningPlaces PlaneEnvelope::extremes(RegionId region, PlaneComponent component) const
{
    GoverningPlaces found;
    for (std::size_t c = 0; c < cases_.size(); ++c) {
        ExtremeQuestion question{.component = component, .region = region};
        const PlaneExtreme max = extreme(cases_[c], question);
        question.which = ExtremeKind::Min;
        const PlaneExtreme min = extreme(cases_[c], question);
        if (c == 0 || max.value > found.max.value) found.max = {max, ids_[c]};
        if (c == 0 || min.value < found.min.value) found.min = {min, ids_[c]};
    }
    return found;
}

} // namespace femoop::plane
