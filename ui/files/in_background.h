#pragma once

#include <chrono>
#include <future>

namespace ui {

/// How work is begun that need not be done in this frame: by another thread. Where there is but one core, as in a
/// browser, it is done when it is collected.
std::launch in_background();

/// Whether such work is done, or is to be done when it is collected. \pre work.valid()
bool is_ready(const auto& work) { return work.wait_for(std::chrono::seconds(0)) != std::future_status::timeout; }

} // namespace ui
