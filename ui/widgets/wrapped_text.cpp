#include "ui/widgets/wrapped_text.h"

#include <imgui.h>

#include <string>

#include "ui/text/shortened.h"

namespace ui {

namespace {

void show_line(std::string_view line)
{
    constexpr std::size_t most_letters = 4000;
    const std::string shown = shortened(line, most_letters);
    ImGui::TextUnformatted(shown.data(), shown.data() + shown.size());
}

} // namespace

void wrapped_text(std::string_view utf8, float wrap_at)
{
    ImGui::PushTextWrapPos(wrap_at);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.0F});
    if (utf8.ends_with('\n')) utf8.remove_suffix(1);
    std::size_t begin = 0;
    for (std::size_t end = utf8.find('\n'); end != std::string_view::npos; end = utf8.find('\n', begin)) {
        show_line(utf8.substr(begin, end - begin));
        begin = end + 1;
    }
    ImGui::PopStyleVar(); // the distance to what follows is the usual one
    show_line(utf8.substr(begin));
    ImGui::PopTextWrapPos();
}

} // namespace ui
