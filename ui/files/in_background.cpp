#include "ui/files/in_background.h"

#include <thread>

namespace ui {

std::launch in_background()
{
    return std::thread::hardware_concurrency() > 1 ? std::launch::async : std::launch::deferred;
}

} // namespace ui
