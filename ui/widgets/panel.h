#pragma once

#include <imgui.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ui {

/// Of the parts that the window consists of: they stay where they are, below what is opened over them.
inline constexpr ImGuiWindowFlags fixed_panel = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                                ImGuiWindowFlags_NoSavedSettings |
                                                ImGuiWindowFlags_NoBringToFrontOnFocus;

/// What fills the window between the menu bar and its foot, of a height [px]; its parts touch one another.
void begin_body(float foot);
void end_body();

/// A part with the spacing of panels, whatever that of the window around it is.
void begin_panel(const char* id, float width);
void end_panel();

inline constexpr float splitter_ems = 0.35F; ///< thickness of a bar that is dragged

/// The picture in a window that is the same with panels and without, so that a field in it keeps the keyboard.
void show_picture(ImVec2 size, const std::function<void()>& picture);

/// A panel on either side of the picture; the bars between them are dragged to give the panels other widths.
class SidePanels {
public:
    struct Sides {
        float left, right;
    };
    /// \param ems  widths that are asked for   \param most  shares of the window's width that they never exceed
    SidePanels(Sides ems, Sides most) : ems_(ems), most_(most) {}

    /// `left` and `right` show a panel of a width [px]. Both are laid out before the picture, so that it shows what
    /// they changed. What lies over the right one, `covered` pixels wide, does not reach the picture.
    void show(const std::function<void(float)>& left, const std::function<void(float)>& right,
              const std::function<void()>& picture, float covered = 0.0F);

private:
    Sides ems_, most_;
};

/// What lies below the picture, `height` pixels high; laid out before the picture, which shows what it changed.
void show_below(float height, const std::function<void()>& content);

float width_of_button(const std::string& label); ///< [px]

/// One tab beside the other, in a further row where there is no room: a word is never cut.
class TabRow {
public:
    bool show(const std::string& title, bool is_chosen); ///< true when it is clicked. \param title "Results###id"

private:
    bool is_first_ = true;
};

/// How the names of the menus stand in their bar: closer where they have no room otherwise, and where that would crowd
/// them, in smaller type.
struct MenuRow {
    float spacing; ///< half of what lies between two of them [px]
    float type;    ///< of the usual size, at most 1
};
MenuRow menu_row(const std::vector<std::string>& names);

/// The menu that begins next is scrolled where it is higher than the room below its bar: laid over the bar it would take
/// the click that opens it. \pre within a menu bar
void keep_next_menu_below();

/// The document's name at the right of the menu bar, where the menus leave room for it.
void menu_bar_title(const std::string& name);

/// The line at the window's foot.
float status_height(); ///< [px]
void begin_status_bar();
void end_status_bar();

/// What is told at the window's foot, in the status bar's place: it lies over nothing, and where it needs more than one
/// line the body gives way to it.
struct FootMessage {
    std::vector<std::string> lines;
    std::vector<std::string> buttons; ///< at the right, with their ids: "Close###close notice"
    std::vector<std::size_t> links{}; ///< lines that are pressed like buttons
};
float height(const FootMessage& message); ///< [px]
/// \returns which button is pressed; links count on after the buttons
std::optional<std::size_t> show(const FootMessage& message);

} // namespace ui
