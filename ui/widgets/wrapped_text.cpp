#include "ui/widgets/wrapped_text.h"

#include <imgui_internal.h>

#include <algorithm>
#include <string>

#include "ui/text/shortened.h"
#include "ui/widgets/item_label.h"

namespace ui {

namespace {

// Dear ImGui alone would also break a number after its decimal sign.
void show_line(std::string_view line, float wrap_at)
{
    constexpr std::size_t most_letters = 4000;
    const float room = ImGui::CalcWrapWidthForPos(ImGui::GetCursorScreenPos(), wrap_at);
    std::string shown;
    for (const char c : in_lines(shortened(line, most_letters), room)) {
        if (c == '\n' && shown.ends_with(' ')) shown.pop_back(); // it would count as a part of the line's width
        shown += c;
    }
    ImGui::TextUnformatted(shown.data(), shown.data() + shown.size());
}

// On the button that was drawn last, as Dear ImGui draws it on a list of its own.
void draw_arrow_of_list()
{
    const ImVec2 padding = ImGui::GetStyle().FramePadding, least = ImGui::GetItemRectMin(),
                 most = ImGui::GetItemRectMax();
    const ImVec2 corner{most.x - ImGui::GetFrameHeight() + padding.y, 0.5F * (least.y + most.y - ImGui::GetFontSize())};
    ImGui::RenderArrow(ImGui::GetWindowDrawList(), corner, ImGui::GetColorU32(ImGuiCol_Text), ImGuiDir_Down);
}

// The list that is opened next stands below what was drawn last, where the window has room for so many rows there.
void put_below(std::size_t n_rows)
{
    const ImVec2 foot{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y};
    const float height = static_cast<float>(n_rows) * ImGui::GetTextLineHeightWithSpacing() +
                         2.0F * ImGui::GetStyle().WindowPadding.y;
    if (foot.y + height < ImGui::GetIO().DisplaySize.y) ImGui::SetNextWindowPos(foot, ImGuiCond_Appearing);
}

} // namespace

void wrapped_text(std::string_view utf8, float wrap_at)
{
    ImGui::PushTextWrapPos(wrap_at);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.0F});
    if (utf8.ends_with('\n')) utf8.remove_suffix(1);
    std::size_t begin = 0;
    for (std::size_t end = utf8.find('\n'); end != std::string_view::npos; end = utf8.find('\n', begin)) {
        show_line(utf8.substr(begin, end - begin), wrap_at);
        begin = end + 1;
    }
    ImGui::PopStyleVar(); // the distance to what follows is the usual one
    show_line(utf8.substr(begin), wrap_at);
    ImGui::PopTextWrapPos();
}

std::string in_lines(std::string_view utf8, float width)
{
    std::string lines;
    std::string_view line = utf8.substr(0, 0);
    while (!utf8.empty()) {
        const std::size_t blank = utf8.find_first_of(" \n");
        const std::string_view word = utf8.substr(0, blank);
        const std::string_view longer(line.data(), line.size() + word.size());
        if (!line.empty() && ImGui::CalcTextSize(longer.data(), longer.data() + longer.size()).x > width) {
            lines += '\n';
            line = utf8.substr(0, 0);
        }
        const std::size_t used = blank == std::string_view::npos ? word.size() : word.size() + 1;
        lines += utf8.substr(0, used);
        const bool ends = used > word.size() && utf8[word.size()] == '\n';
        line = ends ? utf8.substr(used, 0) : std::string_view(line.data(), line.size() + used);
        utf8.remove_prefix(used);
    }
    return lines;
}

std::string in_one_line(std::string_view lines)
{
    std::string text;
    for (const char c : lines)
        if (c != '\n' || !text.ends_with(' ')) text += c;
    return text;
}

std::string label_beside_box(std::string_view name, std::string_view id)
{
    const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    return item_label(in_lines(name, ImGui::GetContentRegionAvail().x - box), id);
}

bool wrapped_button(std::string_view name, std::string_view id)
{
    const float room = ImGui::GetContentRegionAvail().x - 2.0F * ImGui::GetStyle().FramePadding.x;
    return ImGui::Button(item_label(in_lines(name, room), id).c_str());
}

bool begin_wrapped_combo(std::string_view chosen, const std::vector<std::string>& names, const char* id)
{
    const float room = ImGui::GetContentRegionAvail().x, padding = 2.0F * ImGui::GetStyle().FramePadding.x;
    const auto has_room = [&](std::string_view name) {
        return ImGui::CalcTextSize(shown_whole(name).c_str()).x + padding + ImGui::GetFrameHeight() <= room;
    };
    if (has_room(chosen) && std::ranges::all_of(names, has_room)) {
        ImGui::SetNextItemWidth(-1.0F);
        return ImGui::BeginCombo(id, shown_whole(chosen).c_str());
    }
    float height = 0.0F;
    const auto lines = [&](std::string_view name) {
        const std::string broken = in_lines(name, room - padding - ImGui::GetFrameHeight());
        height = std::max(height, ImGui::CalcTextSize(broken.c_str()).y + 2.0F * ImGui::GetStyle().FramePadding.y);
        return broken;
    };
    for (const std::string& name : names) lines(name);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_FrameBg));
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0F, 0.5F});
    const std::string list = std::string(id) + " list", shown = item_label(lines(chosen), id);
    if (ImGui::Button(shown.c_str(), {-1.0F, height})) ImGui::OpenPopup(list.c_str());
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    draw_arrow_of_list();
    put_below(names.size());
    return ImGui::BeginPopup(list.c_str());
}

void beside_if_room(float width, float gap)
{
    const float end = std::min(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x,
                               ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x);
    if (ImGui::GetItemRectMax().x + gap + width <= end) ImGui::SameLine(0.0F, gap);
}

} // namespace ui
