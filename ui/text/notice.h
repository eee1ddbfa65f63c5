#pragma once

#include <optional>

#include "ui/text/message.h"

namespace ui {

/// Something that an app tells its user: one sentence.
struct Notice {
    Message sentence;
    std::optional<double> seconds_left = 6.0; ///< to read it; absent: it stays until it is closed
};

/// Time goes by.
inline void tick(std::optional<Notice>& notice, double seconds)
{
    if (notice && notice->seconds_left && (*notice->seconds_left -= seconds) <= 0.0) notice.reset();
}

} // namespace ui
