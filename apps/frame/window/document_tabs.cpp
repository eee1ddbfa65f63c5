#include "apps/frame/window/document_tabs.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/frame/session/tabs.h"
#include "ui/text/shortened.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/tooltip.h"

namespace frame {

namespace {

constexpr float least_tab_ems = 7.5F; // "untitled (12)": what is narrower does not tell one document from the other

struct DocumentTab {
    std::string title;
    float width; ///< that it needs
};

std::vector<DocumentTab> tabs_of(const Workspace& workspace)
{
    std::vector<DocumentTab> tabs;
    for (std::size_t i = 0; i < n_tabs(workspace); ++i) {
        const std::string title = (tab(workspace, i).is_dirty() ? "* " : "") + tab_name(workspace, i);
        tabs.push_back({title, ui::width_of_button(ui::shown_whole(title))});
    }
    return tabs;
}

// How broad a tab may be where all are to have room: the broadest give way first.
float most_width(std::vector<DocumentTab> tabs, float room, float gap)
{
    std::ranges::sort(tabs, {}, &DocumentTab::width);
    const float least = least_tab_ems * ImGui::GetFontSize();
    float left = room - gap * static_cast<float>(tabs.size() - 1);
    for (std::size_t i = 0; i < tabs.size(); ++i) {
        const float share = left / static_cast<float>(tabs.size() - i);
        if (tabs[i].width > share) return std::max(share, least);
        left -= tabs[i].width;
    }
    return tabs.back().width;
}

std::string cut_to(const std::string& title, float width)
{
    std::string cut = title;
    for (std::size_t n = title.size(); n > 1 && ui::width_of_button(ui::shown_whole(cut)) > width; --n)
        cut = ui::shortened(title, n - 1);
    return cut;
}

float width_of_row(const std::vector<DocumentTab>& tabs, float most, float gap)
{
    float width = -gap;
    for (const DocumentTab& one : tabs) width += std::min(one.width, most) + gap;
    return width;
}

// The document that comes into the window is brought into sight; then the wheel moves the row.
void scroll_row(const Session& session)
{
    int& seen = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("seen"), -1);
    const int shown = static_cast<int>(session.number());
    if (std::exchange(seen, shown) != shown) ImGui::SetScrollHereX();
}

enum class Press : std::uint8_t { None, Show, Close };

Press document_tab(const DocumentTab& shown, float most, bool is_chosen, std::size_t place)
{
    const bool is_cut = shown.width > most;
    const std::string label = ui::item_label(is_cut ? cut_to(shown.title, most) : shown.title,
                                             "tab" + std::to_string(place));
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(is_chosen ? ImGuiCol_TabActive : ImGuiCol_Tab));
    const bool is_clicked = ImGui::Button(label.c_str(), {std::min(shown.width, most), 0.0F});
    ImGui::PopStyleColor();
    const bool is_hovered = ImGui::IsItemHovered();
    const bool is_closed = is_hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
    if (is_hovered && is_cut) ui::show_tooltip(shown.title);
    return is_closed ? Press::Close : is_clicked ? Press::Show : Press::None;
}

} // namespace

void document_tabs(Workspace& workspace, const std::function<bool()>& may_leave)
{
    if (n_tabs(workspace) < 2) return;
    const std::vector<DocumentTab> tabs = tabs_of(workspace);
    const float gap = 0.2F * ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
    const float most = most_width(tabs, room, gap);
    const bool is_scrolled = width_of_row(tabs, most, gap) > room + 1.0F;
    const float bar = is_scrolled ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    ImGui::BeginChild("###documents", {0.0F, ImGui::GetFrameHeight() + bar}, false,
                      ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav |
                          (is_scrolled ? ImGuiWindowFlags_HorizontalScrollbar : ImGuiWindowFlags_NoScrollbar));
    std::optional<std::pair<std::size_t, Press>> chosen;
    for (std::size_t i = 0; i < tabs.size(); ++i) {
        if (i > 0) ImGui::SameLine(0.0F, gap);
        const Press press = document_tab(tabs[i], most, i == workspace.tab, i);
        if (i == workspace.tab) scroll_row(workspace.session);
        if (press != Press::None) chosen = {i, press};
    }
    if (ImGui::IsWindowHovered() && ImGui::GetIO().MouseWheel != 0.0F)
        ImGui::SetScrollX(ImGui::GetScrollX() - 3.0F * ImGui::GetFontSize() * ImGui::GetIO().MouseWheel);
    ImGui::EndChild();
    if (!chosen || !may_leave()) return;
    show_tab(workspace, chosen->first);
    if (chosen->second == Press::Close) leave_tab(workspace);
}

} // namespace frame
