#pragma once

#include "ui/context/pixels.h"

#include <string>
#include <string_view>

namespace golden {

/// How far a channel of a pixel may be off: rounding of another renderer's, no more. One wrong digit changes a few
/// pixels by a hundred, so no rule about means or percentages would see it.
inline constexpr int tolerance = 8;

struct Comparison {
    bool has_same_size = true;
    long n_differing = 0; ///< pixels of which a channel is off by more than the tolerance
    int largest = 0;      ///< difference of any channel

    bool is_same() const { return has_same_size && n_differing == 0; }
};

Comparison compare(const ui::Pixels& found, const ui::Pixels& wanted);

/// The wanted picture, pale, with every differing pixel in red and a frame around them all.
/// \pre both have the same size
ui::Pixels difference_picture(const ui::Pixels& found, const ui::Pixels& wanted);

/// The first line that differs, as "line 3: found ..., wanted ..."; empty for equal texts.
std::string first_difference(std::string_view found, std::string_view wanted);

} // namespace golden
