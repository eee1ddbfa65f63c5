#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "apps/frame/session/commands.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/picture.h"
#include "ui/paint/text_measure.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/side_window.h"

namespace frame {

/// The list of typical structures, each with a small picture, and the sliders of the chosen one. It lies over the panel
/// at the right, so that the picture beside it shows what comes of them.
class TypicalWindow {
public:
    explicit TypicalWindow(const ui::Fonts& fonts) : fonts_(fonts) {}

    /// Nothing where no structure is being chosen.
    void show(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields);

private:
    void show_list(Workspace& workspace, ui::ImGuiSession& gui, ui::TabStops& stops, float height);
    bool show_entry(const TypicalStructure& structure, const Workspace& workspace, ui::ImGuiSession& gui,
                    ui::Size size);
    void draw_pictures(const Workspace& workspace, ui::Size size);

    const ui::Fonts& fonts_;
    ui::SideWindow window_;
    std::vector<ui::Picture> pictures_; ///< of all structures, in the look below
    ui::ThemeName theme_ = ui::ThemeName::Light;
    ui::Size size_{};
    std::pair<std::size_t, float> seen_{}; ///< the structure that was scrolled to last, and the height of the list then
    std::uint64_t generation_ = 0;         ///< of the session when the camera was fitted last
};

} // namespace frame
