#pragma once

namespace ui {

/// Whether a window that everything else waits for can be shown now. There is one at a time: others wait until it is
/// closed, but for the question about unsaved changes, which takes the place of another and gives it back.
bool has_turn(const char* id);

} // namespace ui
