#pragma once

#include <optional>
#include <utility>

#include "ui/text/message.h"

namespace ui {

/// Something that an app tells its user: one sentence. An app that tells more of it has a type of its own, derived from
/// this one.
struct Notice {
    Message sentence;
    std::optional<double> seconds_left = 6.0; ///< to read it; absent: it stays until it is closed
};

inline Notice lasting(Message sentence) { return {std::move(sentence), std::nullopt}; }

/// Time goes by.
template <class AnyNotice> void tick(std::optional<AnyNotice>& notice, double seconds)
{
    if (notice && notice->seconds_left && (*notice->seconds_left -= seconds) <= 0.0) notice.reset();
}

/// What it told of is past, as by undo. One that stays until it is closed stays.
template <class AnyNotice> void outdate(std::optional<AnyNotice>& notice)
{
    if (notice && notice->seconds_left) notice.reset();
}

} // namespace ui
