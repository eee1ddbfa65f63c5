#include "apps/cross/window/exercise_panel.h"

#include <imgui.h>

#include <cmath>
#include <limits>
#include <string>

#include "apps/cross/session/exercise_report.h"
#include "apps/cross/view/pupil_words.h"
#include "apps/cross/view/verdict_mark.h"
#include "ui/text/number_format.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace cross {

namespace fc = femoop::cross;

namespace {

void separate()
{
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
}

ImVec4 colour_of(fc::Verdict verdict, ui::ThemeName name)
{
    const ui::Theme theme(name);
    const ui::Color c = theme[role_of(verdict)].text;
    const auto part = [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; };
    return {part(c.r), part(c.g), part(c.b), 1.0F};
}

/// For those who see no colours.
const char* sign_of(fc::Verdict verdict)
{
    switch (verdict) {
    case fc::Verdict::Open: return "";
    case fc::Verdict::Right: return "✓ ";
    case fc::Verdict::FollowsRight: return "(✓) ";
    default: return "✗ ";
    }
}

void show_verdict(const Session& session, std::size_t cell)
{
    const Worksheet& worksheet = *session.worksheet();
    if (!worksheet.shows_judgement || worksheet.judgements[cell].verdict == fc::Verdict::Open) return;
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(worksheet.judgements[cell].verdict, session.look.theme));
    ui::wrapped_text(sign_of(worksheet.judgements[cell].verdict) +
                     session.tr()(verdict_text(worksheet.judgements[cell])));
    ImGui::PopStyleColor();
}

void show_cell(Workspace& workspace, const CommandTable& commands, CellField& field, bool is_cell_drawn)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.tr();
    if (!session.cell()) {
        ui::wrapped_text(tr("Click a cell of the sheet and type its number: 12.5, -20 or 1/3. Tab and Enter go on."));
        ui::command_button(workspace, commands, "exercise.next_cell");
        return;
    }
    ui::wrapped_text(tr(question(*session.worksheet(), session.document().model, *session.cell())));
    if (!is_cell_drawn) field.show_here(session);
    if (!session.cell()) return;
    show_verdict(session, session.cell()->index);
    for (const fc::Hint hint : session.hints()) ui::wrapped_text("· " + tr(words_of(hint)));
    ui::command_button(workspace, commands, "exercise.hint");
    ImGui::SameLine();
    ui::command_button(workspace, commands, "exercise.show_cell");
}

/// Every mistake that is there now; a click goes to its cell.
void show_mistakes(Session& session)
{
    const Worksheet& worksheet = *session.worksheet();
    if (!worksheet.shows_judgement) return;
    for (std::size_t i = 0; i < worksheet.form.blanks.size(); ++i) {
        const fc::BlankId id(i);
        if (worksheet.is_good(id) || worksheet.judgements[i].verdict == fc::Verdict::Open) continue;
        if (session.cell() == id) continue;
        const std::string name = session.tr()(question(worksheet, session.document().model, id));
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(ui::shown_whole(name).c_str())) session.go_to_cell(id);
        ImGui::PopID();
        show_verdict(session, i);
    }
}

std::string worksheet_stage_name(const Session& session, std::size_t stage)
{
    const Worksheet& worksheet = *session.worksheet();
    if (stage == 0) return session.tr()("Loads, sways propped");
    if (stage == worksheet.n_sheets()) return session.tr()("All together");
    const auto& sway = worksheet.form.problem.sways[stage - 1];
    return session.tr()("Sway at {node}", {{"node", session.document().model[sway.prop].id}});
}

void show_worksheet_stages(Session& session)
{
    if (session.worksheet()->n_stages() < 2) return;
    separate();
    for (std::size_t stage = 0; stage < session.worksheet()->n_stages(); ++stage) {
        const std::string name = ui::label_beside_box(worksheet_stage_name(session, stage),
                                                      "paper stage" + std::to_string(stage));
        if (ImGui::RadioButton(name.c_str(), session.worksheet_stage() == stage)) session.show_worksheet_stage(stage);
    }
}

} // namespace

void ExercisePanel::show_beginning(Workspace& workspace, const CommandTable& commands)
{
    const ui::Catalogue tr = workspace.tr(); // a command may change the language
    ui::wrapped_text(tr("Difficulty"));
    for (int i = 1; i <= n_difficulties; ++i) {
        const auto difficulty = static_cast<fc::Difficulty>(i);
        const std::string name = ui::label_beside_box(std::to_string(i) + "  " + tr(words_of(difficulty)),
                                                      "difficulty");
        ImGui::PushID(i);
        if (ImGui::RadioButton(name.c_str(), workspace.next_exercise.difficulty == difficulty))
            workspace.next_exercise = {difficulty, 1};
        ImGui::PopID();
    }
    show_seed(workspace);
    ui::command_button(workspace, commands, "exercise.new");
    ui::command_button(workspace, commands, "exercise.own");
    if (workspace.session.worksheet() == nullptr) return;
    show_worksheet_stages(workspace.session);
    separate();
    const auto& command = *commands.find("exercise.judge_at_once");
    bool is_on = command.is_on(workspace);
    if (ImGui::Checkbox(ui::label_beside_box(label(command, workspace, tr), "judge at once").c_str(), &is_on))
        run(command, workspace);
    for (const char* const id : {"exercise.judge", "exercise.start_over", "exercise.end"})
        ui::command_button(workspace, commands, id);
}

void ExercisePanel::show_seed(Workspace& workspace)
{
    const ui::Catalogue& tr = workspace.tr();
    ui::wrapped_text(tr("Number of the exercise: the same number gives the same one"));
    const std::string text = std::to_string(workspace.next_exercise.seed);
    const auto event = fields_.show("###seed",
                                    {.text = text, .exact_text = text, .value = std::nullopt, .is_typed_only = true});
    if (event.kind != ui::NumberFieldEvent::Kind::Typed) return;
    const auto typed = ui::number_typed(event.text);
    constexpr double most = std::numeric_limits<std::uint32_t>::max();
    if (!typed || *typed < 0.0 || *typed > most || *typed != std::floor(*typed))
        return fields_.reject(event, tr("wanted a whole number from 0 to 4294967295"));
    workspace.next_exercise.seed = static_cast<std::uint32_t>(*typed);
}

void ExercisePanel::show_worksheet(Workspace& workspace, const CommandTable& commands, CellField& field,
                                   bool is_cell_drawn)
{
    Session& session = workspace.session;
    ui::wrapped_text(exercise_name(session));
    ui::wrapped_text(score_text(session));
    separate();
    show_cell(workspace, commands, field, is_cell_drawn);
    if (session.worksheet() == nullptr) return;
    separate();
    show_mistakes(session);
}

} // namespace cross
