#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/methods/cross/exercise/judge.h"
#include "femoop/methods/cross/exercise/seeded.h"

namespace cross {

/// Which exercise it is: the same structure again for the same difficulty and seed.
struct Seeded {
    femoop::cross::Difficulty difficulty = femoop::cross::Difficulty::FixedEnds;
    std::uint32_t seed = 1;
    friend bool operator==(const Seeded&, const Seeded&) = default;
};
inline constexpr int n_difficulties = 6;

/// The sheet of a document's structure is filled by a pupil. Saved in the file's `cross` block.
struct Pupil {
    std::optional<Seeded> seeded{};     ///< nothing: a structure of one's own
    std::vector<std::string> written{}; ///< into the cells of the form, as it was typed; "" for nothing
    std::vector<bool> helped{};         ///< cells that were wrong once or shown: they give no point
    bool judges_at_once = true;         ///< else when it is asked for
    bool is_judged = false;             ///< it was asked for since the last number
    std::size_t number = 0;             ///< of the exercises that were begun on what is open; not saved

    friend bool operator==(const Pupil&, const Pupil&) = default;
};

/// A number that a pupil typed ("12,5", "-20", "1/3", "4/6"), with the digits that it has; nothing for anything else.
/// Of a calculation with decimals a thousandth is taken for its last digit; one of whole numbers is exact.
std::optional<femoop::cross::Entry> entry_typed(std::string_view text);

} // namespace cross
