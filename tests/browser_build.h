#pragma once

/// Whether this is built for a browser, so that it runs under node.
#if defined(__EMSCRIPTEN__)
inline constexpr bool is_for_browser = true;
#else
inline constexpr bool is_for_browser = false;
#endif
