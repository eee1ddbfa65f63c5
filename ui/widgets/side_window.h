#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ui/text/catalogue.h"
#include "ui/widgets/tab_stops.h"

namespace ui {

/// A window over the panel at the right that everything else waits for, while the picture beside it is looked at.
class SideWindow {
public:
    /// Whether it is there and its content is to be shown; then `end` must follow. Tab goes round in it.
    /// \param id "###section"
    bool begin(bool is_open, const char* id, const std::string& title, TabStops& stops);
    /// Around what stands above its buttons, which follow and rest at its foot.
    static void begin_content();
    static void end_content();
    /// Closes it where it is open no longer.
    void end(bool is_open, TabStops& stops);
    static float width(); ///< [px]

private:
    void light_up(bool is_open);

    std::optional<float> dimming_; ///< of what lies behind other windows, while this one is open
};

/// What the buttons at a window's foot say, or Enter and Escape where no field is typed into.
enum class FootAnswer : std::uint8_t { None, Accept, Cancel };
struct FootButtons {
    std::string accept = "OK###accept";
    bool may_accept = true; ///< else that button is grey, and Enter does nothing
    bool is_typing = false; ///< the two keys belong to a field
};
/// A button that accepts, and beside it "Cancel".
FootAnswer foot_buttons(const FootButtons& buttons, const Catalogue& tr, TabStops& stops);

} // namespace ui
