#pragma once

namespace ui {

/// Whether a program may be started from a terminal, to draw, describe or play a scenario without a window. A page always
/// has a window, and holds nothing of these.
#if defined(__EMSCRIPTEN__)
inline constexpr bool has_terminal = false;
#else
inline constexpr bool has_terminal = true;
#endif

} // namespace ui
