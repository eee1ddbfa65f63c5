#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

namespace ui {

/// Of the parts that the window consists of: they stay where they are, below what is opened over them.
inline constexpr ImGuiWindowFlags fixed_panel = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                                ImGuiWindowFlags_NoSavedSettings |
                                                ImGuiWindowFlags_NoBringToFrontOnFocus;

/// What fills the window between the menu bar and the status bar; its parts touch one another.
void begin_body();
void end_body();

/// A part with the spacing of panels, whatever that of the window around it is.
void begin_panel(const char* id, float width);
void end_panel();

/// A bar beside a panel, dragged to give it another width [ems]. \param sign 1: the panel is at its left; -1: right
std::optional<float> splitter(const char* id, float width, float sign, float height);
inline constexpr float splitter_ems = 0.35F; ///< thickness

/// One tab beside the other, in a further row where there is no room: a word is never cut.
class TabRow {
public:
    bool show(const std::string& title, bool is_chosen); ///< true when it is clicked. \param title "Results###id"

private:
    bool is_first_ = true;
};

/// The line at the window's foot.
void begin_status_bar();
void end_status_bar();

/// Sentences in a box at the top of the present window; buttons can follow within it.
void begin_message_box(const std::vector<std::string>& lines);
void end_message_box();

} // namespace ui
