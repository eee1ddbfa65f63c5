#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "apps/frame/session/commands.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/text_measure.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/side_window.h"

namespace frame {

/// Where the trains of the document are edited: the list with those of the library to take from, the chosen one's
/// picture to scale, its axles as a table, and what else it brings. The structure beside it shows what becomes of it.
class TrainWindow {
public:
    explicit TrainWindow(const ui::Fonts& fonts) : fonts_(fonts) {}

    /// Nothing where no trains are edited.
    void show(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields);

private:
    void show_content(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields);
    void show_trains(Workspace& workspace) const;
    void show_new(Workspace& workspace, ui::TabStops& stops) const;
    void show_name(Workspace& workspace, ui::TabStops& stops);
    void show_picture(const Workspace& workspace, ui::ImGuiSession& gui) const;

    const ui::Fonts& fonts_;
    ui::SideWindow window_;
    std::string name_;                  ///< as it is typed
    std::string old_name_;              ///< before
    bool is_naming_ = false;            ///< it has the keyboard
    std::optional<ui::Message> reason_; ///< why it is not taken
    std::size_t named_ = 0;             ///< the train that it is of
    std::optional<std::size_t> begun_;  ///< the axle whose force gets the keyboard when it is shown
};

} // namespace frame
