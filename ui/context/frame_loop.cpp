#include "ui/context/frame_loop.h"

namespace ui {

void run_frames(std::function<bool()> step)
{
    while (step()) {
    }
}

} // namespace ui
