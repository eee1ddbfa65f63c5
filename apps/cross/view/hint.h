#pragma once

#include <string>

#include "apps/cross/view/look.h"
#include "ui/paint/painter.h"

namespace cross {

/// What a press would do where the pointer is: drawn over the picture, faint.
struct Hint {
    enum class Kind : std::uint8_t { Support, Span, Load };
    Kind kind = Kind::Support;
    ui::Point at;          ///< where the support would be; the sign beyond an end
    std::string words{};   ///< "4.2 m | 1.8 m"
    bool is_faint = false; ///< it can be reached for, but the pointer is elsewhere
};

void draw(ui::Painter& painter, const Hint& hint, const Look& look);

} // namespace cross
