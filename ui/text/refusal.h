#pragma once

#include <string>

namespace ui {

/// Why a program prints nothing, and what it ends with.
struct Refusal {
    std::string words; ///< for stderr, in the reader's language
    int status = 2;    ///< as `cremona` has it: 2 bad input, 3 a mechanism
};

} // namespace ui
