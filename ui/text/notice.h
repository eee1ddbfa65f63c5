#pragma once

#include <optional>

#include "ui/text/phrase.h"

namespace ui {

/// Something that an app tells its user: one sentence, gone when it has been read.
struct Notice {
    Phrase sentence;
    double seconds_left = 6.0;
};

/// Time goes by.
inline void tick(std::optional<Notice>& notice, double seconds)
{
    if (notice && (notice->seconds_left -= seconds) <= 0.0) notice.reset();
}

} // namespace ui
