#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "apps/plane/document/analysed.h"
#include "femoop/plane/analysis/natural_modes.h"

namespace plane {

/// How the mesh of a drawing vibrates by itself, or why it does not.
class Vibration {
public:
    explicit Vibration(std::shared_ptr<const Analysed> of); ///< \pre it has a mesh

    const std::shared_ptr<const Analysed>& of() const { return of_; }
    const femoop::plane::NaturalModes* modes() const { return modes_ ? &*modes_ : nullptr; }
    const std::vector<femoop::Fault>& faults() const { return faults_; } ///< why there are no modes, or warnings

private:
    std::shared_ptr<const Analysed> of_;
    std::optional<femoop::plane::NaturalModes> modes_;
    std::vector<femoop::Fault> faults_;
};

} // namespace plane
