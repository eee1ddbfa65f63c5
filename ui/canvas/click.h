#pragma once

namespace ui {

/// So far a hand trembles between pressing and releasing a button: a click. Farther is a drag. [logical pixels]
inline constexpr double click_reach = 4.0;

} // namespace ui
