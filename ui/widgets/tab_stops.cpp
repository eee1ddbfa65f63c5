#include "ui/widgets/tab_stops.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

bool is_tab_pressed()
{
    const ImGuiIO& io = ImGui::GetIO();
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab)) && !io.KeyCtrl && !io.KeyAlt;
}

void focus_last_item()
{
    ImGuiContext& gui = *ImGui::GetCurrentContext();
    ImGui::ClearActiveID();
    ImGui::SetFocusID(gui.LastItemData.ID, gui.CurrentWindow);
    gui.NavDisableHighlight = false;
    gui.NavDisableMouseHover = true; // until the mouse moves, only what has the keyboard stands out
    ImGui::ScrollToItem(ImGuiScrollFlags_KeepVisibleEdgeY);
}

// In the next frame; a stroke that comes until then waits (ui/context/imgui_session.h).
void activate(unsigned id)
{
    ImGuiContext& gui = *ImGui::GetCurrentContext();
    gui.NavNextActivateId = id;
    gui.NavNextActivateFlags = ImGuiActivateFlags_PreferInput; // a button is not pressed by it
}

} // namespace

TabStops::Round& TabStops::round()
{
    const auto known = std::ranges::find(rounds_, window_, &Round::window);
    Round& round = known != rounds_.end() ? *known : rounds_.emplace_back(Round{.window = window_});
    const int now = ImGui::GetFrameCount();
    if (round.last_shown != now) {
        if (round.last_shown + 1 < now) round.current = 0; // it was closed meanwhile
        round.places_before = std::exchange(round.places, {});
    }
    round.last_shown = now;
    return round;
}

void TabStops::begin_window()
{
    window_ = ImGui::GetCurrentWindow()->ID;
    round();
    ImGui::PushAllowKeyboardFocus(false); // of Dear ImGui's own Tab
}

void TabStops::end_window()
{
    ImGui::PopAllowKeyboardFocus();
    Round& round = this->round();
    window_ = 0;
    const bool is_ours = is_tab_pressed() && pressed_ != ImGui::GetFrameCount() &&
                         ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    if (!is_ours) return;
    ImGui::ClosePopupsOverWindow(ImGui::GetCurrentWindow(), true); // a list that was left open
    leave_for_neighbour(round);
}

void TabStops::add(Kind kind)
{
    ImGuiContext& gui = *ImGui::GetCurrentContext();
    if ((gui.LastItemData.InFlags & ImGuiItemFlags_Disabled) != 0) return;
    const unsigned id = gui.LastItemData.ID;
    const bool is_framed = ImGui::IsItemFocused() && !gui.NavDisableHighlight; // else a window has just come up with it
    if (is_framed || ImGui::IsItemActive()) stand(id);
    if (!arrives(id) || (kind == Kind::Text && ImGui::IsItemActive())) return;
    focus_last_item();
    if (kind == Kind::Text) activate(id); // it was out of sight
}

bool TabStops::arrives(unsigned id)
{
    Round& round = this->round();
    round.places.push_back(id);
    if (wanted_ != id) return false;
    wanted_ = 0;
    if (pressed_ + 1 < ImGui::GetFrameCount()) return false; // it was not there when it was looked for
    round.current = id;
    return true;
}

void TabStops::stand(unsigned id) { round().current = id; }

void TabStops::leave(unsigned id)
{
    stand(id);
    leave_for_neighbour(round());
}

void TabStops::stay() { wanted_ = 0; }

void TabStops::leave_for_neighbour(Round& round)
{
    pressed_ = ImGui::GetFrameCount();
    const auto has_current = [&](const std::vector<unsigned>& list) {
        return std::ranges::find(list, round.current) != list.end();
    };
    const std::vector<unsigned>& places = has_current(round.places_before) ? round.places_before : round.places;
    if (places.empty()) return;
    const std::size_t n = places.size();
    const auto at = static_cast<std::size_t>(std::ranges::find(places, round.current) - places.begin());
    const bool is_back = ImGui::GetIO().KeyShift;
    if (at == n) wanted_ = is_back ? places.back() : places.front();
    else wanted_ = places[(is_back ? at + n - 1 : at + 1) % n];
    activate(wanted_);
}

} // namespace ui
