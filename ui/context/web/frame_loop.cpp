#include "ui/context/frame_loop.h"

#include <emscripten.h>

#include <exception>
#include <iostream>
#include <memory>
#include <utility>

namespace ui {

namespace {

using Step = std::function<bool()>;

/// False also where an exception ends it: the page shows what is written to stderr.
bool goes_on(const Step& step)
try {
    return step();
} catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return false;
}

void draw_frame(void* user)
{
    auto* const step = static_cast<Step*>(user);
    if (goes_on(*step)) return;
    emscripten_cancel_main_loop();
    delete step;
    EM_ASM({ Module['whenOver'] && Module['whenOver'](); });
}

} // namespace

void run_frames(std::function<bool()> step)
{
    auto owned = std::make_unique<Step>(std::move(step));
    constexpr int as_the_browser_draws = 0;
    emscripten_set_main_loop_arg(draw_frame, owned.release(), as_the_browser_draws, false);
}

} // namespace ui
