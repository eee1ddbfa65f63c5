#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cross/view/scene.h"

namespace cross {

/// What all sheets together are added up from, as a book writes it: loads + x sway.
struct SheetPart {
    std::optional<std::size_t> sway; ///< nothing: the loads
    double times = 1.0;
    std::vector<double> moments; ///< so many times those of the sheet, at every end
};
/// \pre the scene has a task whose sheets were worked to their tolerance
std::vector<SheetPart> parts_of(const Scene& scene);

/// "loads", "0.312 × sway at B", "no sway at B".
std::string words_of(const SheetPart& part, const Scene& scene);

} // namespace cross
