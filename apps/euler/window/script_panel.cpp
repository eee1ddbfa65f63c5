#include "apps/euler/window/script_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "apps/euler/window/step_panel.h"
#include "ui/text/shortened.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace euler {

namespace {

constexpr std::size_t most_letters_of_row = 200; // of a row

// What of a row has room, whose end gives way to an ellipsis.
std::string fitted(const std::string& row)
{
    const float room = ImGui::GetContentRegionAvail().x;
    std::size_t n = most_letters_of_row;
    std::string shown = ui::shortened(row, n);
    for (float width = ImGui::CalcTextSize(shown.c_str()).x; width > room && n > 1;
         width = ImGui::CalcTextSize(shown.c_str()).x) {
        n = std::min(n, shown.size());
        n = std::clamp<std::size_t>(static_cast<std::size_t>(static_cast<float>(n) * room / width), 1, n - 1);
        shown = ui::shortened(row, n);
    }
    return shown;
}

// The line before the first step.
void beginning(Session& session)
{
    const std::string name = session.tr()("the beginning") + "###step 0";
    if (ImGui::Selectable(name.c_str(), session.place() == 0)) session.go_to(0);
}

void line(Session& session, std::size_t i)
{
    const StepSummary step = session.stepper().summary(i);
    const std::string name = ui::item_label(fitted(std::to_string(i) + "  " + code(step)), "step " + std::to_string(i));
    const bool is_undone = i > session.place();
    if (is_undone) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const bool is_clicked = ImGui::Selectable(name.c_str(), i == session.place());
    if (is_undone) ImGui::PopStyleColor();
    if (!is_clicked) return;
    session.is_playing = false;
    session.go_to(i);
}

// The step that was in sight last; on the first look the beginning.
int& seen_step() { return *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("seen"), 0); }

// The last item, which is the present line; it may take some frames until the list knows how long it is.
void bring_step_into_sight(int place)
{
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    const bool is_whole = ImGui::GetItemRectMin().y >= top && ImGui::GetItemRectMax().y <= bottom;
    if (is_whole || ImGui::GetWindowHeight() < 2.0F * ImGui::GetFrameHeight()) seen_step() = place;
    else ImGui::SetScrollHereY();
}

void list(Session& session)
{
    const auto place = static_cast<int>(session.place());
    const bool has_moved = seen_step() != place;
    beginning(session);
    if (has_moved && place == 0) bring_step_into_sight(place);
    ImGuiListClipper clipper; // a script may have a million lines
    clipper.Begin(static_cast<int>(session.n_steps()));
    if (has_moved && place > 0) clipper.ForceDisplayRangeByIndices(place - 1, place);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            line(session, static_cast<std::size_t>(i) + 1);
            if (has_moved && i + 1 == place) bring_step_into_sight(place);
        }
}

// Takes out what is beyond a place of the text, but no half of a letter.
void cut(ImGuiInputTextCallbackData& data, std::size_t from, std::size_t end)
{
    const auto is_continued = [&](std::size_t i) { return (static_cast<unsigned char>(data.Buf[i]) & 0xC0U) == 0x80U; };
    while (from > 0 && is_continued(from)) --from;
    data.DeleteChars(static_cast<int>(from), static_cast<int>(end - from));
}

// Dear ImGui cannot draw a line of any length.
int shorten(ImGuiInputTextCallbackData* data)
{
    const auto size = [data] { return static_cast<std::size_t>(data->BufTextLen); };
    for (std::size_t i = 0, begin = 0; i <= size(); ++i) {
        if (i < size() && data->Buf[i] != '\n') continue;
        if (i - begin > Session::most_letters_of_line) {
            cut(*data, begin + Session::most_letters_of_line, i);
            i = begin;
            continue;
        }
        begin = i + 1;
    }
    if (size() > Session::most_letters_of_text) cut(*data, Session::most_letters_of_text, size());
    return 0;
}

float height_of(const std::string& fault)
{
    if (fault.empty()) return 0.0F;
    const float room = ImGui::GetContentRegionAvail().x;
    return ImGui::CalcTextSize(fault.c_str(), nullptr, false, room).y + ImGui::GetStyle().ItemSpacing.y;
}

// Of a button whose name is broken in a narrow panel.
float more_lines_of(const std::string& name)
{
    const float room = ImGui::GetContentRegionAvail().x - 2.0F * ImGui::GetStyle().FramePadding.x;
    return ImGui::CalcTextSize(ui::in_lines(name, room).c_str()).y - ImGui::GetTextLineHeight();
}

} // namespace

ScriptPanel::ScriptPanel() : line_(ui::KeptField::Hold::UntilLeft, shorten) {}

// It keeps the keyboard, so that line after line is written.
void ScriptPanel::write_line(Session& session)
{
    if (std::exchange(wants_keyboard_, false)) line_.grab_keyboard();
    if (line_.show("###line", session.tr()("one more line")) && session.write(line_.text())) line_.offer("");
    is_typing_ = line_.has_keyboard();
}

void ScriptPanel::settle(Session& session)
{
    if (has_line() && session.write(line_.text())) line_.offer("");
}

// The cursor goes to a line's end once the text has the keyboard.
int ScriptPanel::on_text_event(ImGuiInputTextCallbackData* data)
{
    if (data->EventFlag == ImGuiInputTextFlags_CallbackEdit) return shorten(data);
    const auto line = std::exchange(static_cast<ScriptPanel*>(data->UserData)->line_to_go_to_, std::nullopt);
    if (!line) return 0;
    const std::string_view text(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    std::size_t end = text.find('\n');
    for (std::size_t i = 1; i < *line && end < text.size(); ++i) end = text.find('\n', end + 1);
    data->CursorPos = static_cast<int>(std::min(end, text.size()));
    data->ClearSelection();
    return 0;
}

void ScriptPanel::edit_text(Session& session, float height)
{
    if (std::exchange(wants_keyboard_, false)) ImGui::SetKeyboardFocusHere();
    ImGui::InputTextMultiline("###text", &*session.edited_text, {-1.0F, height},
                              ImGuiInputTextFlags_CallbackEdit | ImGuiInputTextFlags_CallbackAlways, on_text_event,
                              this);
    is_typing_ = ImGui::IsItemActive();
    if (session.faulty_line) mark_faulty_line(session);
}

// In the window that the field lies in, which goes on with what is drawn there.
void ScriptPanel::mark_faulty_line(const Session& session) const
{
    ImGui::BeginChild("###text", ImGui::GetItemRectSize());
    const float height = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetWindowPos();
    const float top = corner.y + ImGui::GetStyle().FramePadding.y - ImGui::GetScrollY() +
                      height * static_cast<float>(*session.faulty_line - 1);
    const ui::Color color = ui::with_opacity(ui::Theme(session.look.theme)[ui::Role::Killed].stroke.color, 0.3);
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + ImGui::GetWindowWidth(), top + height},
                                              IM_COL32(color.r, color.g, color.b, color.a));
    ImGui::EndChild();
}

void ScriptPanel::show(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const std::string fault = session.script_fault ? session.tr()(*session.script_fault) : "";
    const float row = ImGui::GetFrameHeightWithSpacing();
    const float below = height_of(fault) + 2.0F * row +
                        more_lines_of(session.tr()(commands.find("script.edit")->label));
    const float height = std::max(3.0F * row, ImGui::GetContentRegionAvail().y - below);
    if (session.edited_text) {
        edit_text(session, height);
    } else {
        ImGui::BeginChild("###script", {0.0F, height});
        list(session);
        ImGui::EndChild();
        write_line(session);
    }
    if (!fault.empty()) ui::wrapped_text(fault);
    if (session.edited_text) {
        ui::command_button(workspace, commands, "script.accept");
        ui::command_button(workspace, commands, "operator.cancel");
    } else {
        ui::command_button(workspace, commands, "script.edit");
    }
}

} // namespace euler
