#pragma once

#include <optional>
#include <string>

namespace ui {

/// A window over the panel at the right that everything else waits for, while the picture beside it is looked at.
class SideWindow {
public:
    /// Whether it is there and its content is to be shown; then `end` must follow. \param id "###section"
    bool begin(bool is_open, const char* id, const std::string& title);
    /// Around what stands above its buttons, which follow and rest at its foot.
    static void begin_content();
    static void end_content();
    /// Closes it where it is open no longer.
    void end(bool is_open);
    static float width(); ///< [px]

private:
    void light_up(bool is_open);

    std::optional<float> dimming_; ///< of what lies behind other windows, while this one is open
};

/// Enter or Escape was pressed, and not to end what is typed into a field.
bool is_pressed_outside_fields(int key);

} // namespace ui
