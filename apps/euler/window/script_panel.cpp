#include "apps/euler/window/script_panel.h"

#include <imgui.h>

#include <string>

#include "apps/euler/window/step_panel.h"
#include "ui/text/shortened.h"

namespace euler {

namespace {

constexpr std::size_t most_letters = 200; // of a row

// The line before the first step.
void beginning(Session& session)
{
    const std::string name = session.tr()("the beginning") + "###step 0";
    if (ImGui::Selectable(name.c_str(), session.place() == 0)) session.go_to(0);
}

void line(Session& session, std::size_t i)
{
    const StepReport& step = session.stepper().report(i);
    const std::string name = std::to_string(i) + "  " + ui::shortened(code(step), most_letters) + "###step " +
                             std::to_string(i);
    const bool is_undone = i > session.place();
    if (is_undone) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const bool is_clicked = ImGui::Selectable(name.c_str(), i == session.place());
    if (is_undone) ImGui::PopStyleColor();
    if (!is_clicked) return;
    session.is_playing = false;
    session.go_to(i);
}

// The present line stays in sight while the lesson goes on.
void keep_in_sight(const Session& session)
{
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const float at = row * static_cast<float>(session.place());
    const float top = ImGui::GetScrollY(), room = ImGui::GetWindowHeight();
    if (session.is_moving() && (at < top || at + 2.0F * row > top + room)) ImGui::SetScrollY(at - 0.5F * room);
}

} // namespace

void script_panel(Desk& desk)
{
    Session& session = desk.session;
    ImGui::BeginChild("###script");
    keep_in_sight(session);
    beginning(session);
    ImGuiListClipper clipper; // a script may have a million lines
    clipper.Begin(static_cast<int>(session.n_steps()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) line(session, static_cast<std::size_t>(i) + 1);
    ImGui::EndChild();
}

} // namespace euler
