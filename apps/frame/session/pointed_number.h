#pragma once

#include <cstdint>
#include <optional>

#include "apps/frame/influence/asked_line.h"
#include "femoop/model/expected.h"
#include "femoop/model/ids.h"
#include "femoop/model/moving_load.h"
#include "femoop/result/components.h"

namespace frame {

/// What stands on an influence line, and where.
struct LoadOnLine {
    AskedTrain::Place place;
    bool is_unit_load = false; ///< in place of the line's train

    friend bool operator==(const LoadOnLine&, const LoadOnLine&) = default;
};

/// Which of the numbers of a comparison it is.
enum class Compared : std::uint8_t { Now, Kept, Change };

/// A number under the pointer, and what it is of where that is not what is shown.
struct PointedNumber {
    femoop::MovingEffect effect;                  ///< or the resultant of a reaction
    std::optional<femoop::CaseId> of{};           ///< its case, where a table or an envelope says so
    std::optional<femoop::ExtremeKind> extreme{}; ///< of an envelope; nothing: that of the greater magnitude
    std::optional<LoadOnLine> under{};            ///< of an influence line: under this load it is the effect's value
    Compared compared = Compared::Now;
};

/// A section force or a reaction, which could be released.
inline bool is_force(const femoop::MovingEffect& effect)
{
    if (effect.component) return !femoop::is_displacement(*effect.component);
    return effect.quantity != femoop::ExpectedQuantity::Displacement;
}

} // namespace frame
