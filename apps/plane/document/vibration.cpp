#include "apps/plane/document/vibration.h"

#include <utility>

namespace plane {

Vibration::Vibration(std::shared_ptr<const Analysed> of) : of_(std::move(of))
{
    try {
        modes_ = femoop::plane::natural_modes(*of_->mesh());
        faults_ = modes_->warnings;
    } catch (const femoop::ModelError& error) {
        faults_ = error.faults();
    }
}

} // namespace plane
