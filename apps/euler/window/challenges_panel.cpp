#include "apps/euler/window/challenges_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <string>

#include "apps/euler/session/challenge/challenge_commands.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/wrapped_text.h"

namespace euler {

namespace {

void take(Session& session, std::string_view words)
{
    if (auto reason = session.answer(words)) session.notify(*reason);
}

void side_button(Session& session, Side side, const std::string& title)
{
    if (ImGui::RadioButton(title.c_str(), session.side() == side)) session.show_side(side);
}

// Two pictures and four names.
void show_which(Session& session, const WhichOperator& which)
{
    const ui::Catalogue tr = session.tr();
    side_button(session, Side::Before, tr("the first picture") + "###side before");
    side_button(session, Side::After, tr("the second picture") + "###side after");
    ImGui::Spacing();
    ImGui::BeginDisabled(session.game()->is_over());
    for (std::size_t i = 0; i < which.choices.size(); ++i) {
        if (i % 2 == 1) ImGui::SameLine();
        const std::string title = which.choices[i] + "###choice " + std::to_string(i);
        if (ImGui::Button(title.c_str(), {6.0F * ImGui::GetFontSize(), 0.0F})) take(session, which.choices[i]);
    }
    ImGui::EndDisabled();
}

// A click on a cell of the tables begins the answer.
void show_pointer(Session& session)
{
    const ui::Catalogue& tr = session.tr();
    ui::wrapped_text(tr("Click the wrong cell below and type what it should be, as H 3 N 4."));
    ImGui::BeginDisabled(session.game()->is_over());
    ImGui::SetNextItemWidth(-1.0F);
    const bool is_entered = ImGui::InputText("###answer", &session.typed_answer(),
                                             ImGuiInputTextFlags_EnterReturnsTrue);
    const bool is_clicked = ImGui::Button((tr("Set the pointer") + "###set pointer").c_str());
    ImGui::EndDisabled();
    if (is_entered || is_clicked) take(session, session.typed_answer());
}

void show_reach(const Session& session, const ReachChallenge& reach)
{
    const ReachState state = judged(reach, session.stepper());
    ui::wrapped_text(
        session.tr()("{n} of {most} operators are used.",
                     {{"n", std::to_string(state.n_operators)}, {"most", std::to_string(reach.most_operators)}}));
}

void show_task(Session& session)
{
    const Game::Task& task = session.game()->task();
    if (const auto* const which = std::get_if<WhichOperator>(&task)) show_which(session, *which);
    else if (const auto* const reach = std::get_if<ReachChallenge>(&task)) show_reach(session, *reach);
    else show_pointer(session);
}

void show_game(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const ui::Catalogue tr = session.tr(); // a command may change the language
    ui::wrapped_text(tr(session.game()->question()));
    ImGui::Spacing();
    show_task(session);
    ImGui::Spacing();
    for (const ui::Message& hint : session.game()->hints()) ui::wrapped_text(tr("Hint: {hint}", {{"hint", tr(hint)}}));
    if (session.game()->verdict()) ui::wrapped_text(tr(*session.game()->verdict()));
    if (session.game()->is_over())
        ui::wrapped_text(tr("{n} of {most} points",
                            {{"n", std::to_string(session.game()->points())}, {"most", std::to_string(Score::most)}}));
    ui::command_button(workspace, commands, "challenge.hint");
    ui::command_button(workspace, commands, "challenge.give_up");
    ImGui::Separator();
}

} // namespace

void challenges_panel(Workspace& workspace, const CommandTable& commands)
{
    if (workspace.session.game()) show_game(workspace, commands);
    for (const std::string_view id : challenge_command_ids()) ui::command_button(workspace, commands, id);
    ImGui::Spacing();
    ImGui::TextDisabled(
        "%s",
        workspace.session.tr()("Points so far: {n}", {{"n", std::to_string(workspace.session.points())}}).c_str());
}

} // namespace euler
