#include "apps/mohr/window/exercises_panel.h"

#include <imgui.h>

#include <string>

#include "apps/mohr/exercise/words.h"
#include "apps/mohr/session/report.h"
#include "ui/paint/theme.h"
#include "ui/widgets/command_combo.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/wrapped_text.h"

namespace mohr {

using Kind = ui::NumberFieldEvent::Kind;

namespace {

ImVec4 color_of(Verdict verdict, ui::ThemeName name)
{
    if (verdict == Verdict::Shown) return ImGui::GetStyleColorVec4(ImGuiCol_Text);
    const ui::Theme theme(name);
    const ui::Role role = verdict == Verdict::Wrong ? ui::Role::Error : ui::Role::Reaction;
    const ui::Color c = theme[role].text;
    const auto part = [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; };
    return {part(c.r), part(c.g), part(c.b), 1.0F};
}

/// The numbers that the exercise gives, a line each.
std::string given_text(const Session& session)
{
    std::string words;
    for (std::size_t i = 0; i < session.document().state().size(); ++i)
        words += (i == 0 ? "" : "\n") + given_number(session, i);
    return words;
}

std::string verdict_text(const Session& session, std::size_t place)
{
    const ui::Catalogue& tr = session.tr();
    const Judgement& judgement = session.practice()->judgements()[place];
    const std::optional<double> own = session.practice()->own_answer(place);
    switch (judgement.verdict) {
    case Verdict::Open: return "";
    case Verdict::Right: return tr("right");
    case Verdict::FollowsRight: return tr(judgement.words);
    case Verdict::Shown:
        return own ? tr("shown; you had {answer}", {{"answer", session.look.number(*own)}}) : tr("shown");
    case Verdict::Wrong: break;
    }
    return tr("not so: {why}", {{"why", tr(judgement.words)}});
}

} // namespace

void ExercisesPanel::show(Workspace& workspace, const CommandTable& commands)
{
    ui::command_combo(workspace, commands, "###exercise topic", exercise_topics(),
                      [&](const ExerciseTopicEntry& entry) { return entry.value == workspace.exercise_topic; });
    for (const char* id : {"exercise.easy", "exercise.medium", "exercise.hard"})
        ui::command_button(workspace, commands, id);
    ImGui::Separator();
    if (!workspace.session.practice()) {
        ui::wrapped_text(workspace.tr()(
            "An exercise gives a state and asks for what follows from it. "
            "Answers are judged one by one; what follows from a number that was wrong counts as right."));
        return;
    }
    ui::wrapped_text(given_text(workspace.session));
    ImGui::Separator();
    for (std::size_t i = 0; i < workspace.session.practice()->answers().size(); ++i) show_question(workspace, i);
    ImGui::Separator();
    const Practice& practice = *workspace.session.practice();
    const std::string points = std::to_string(practice.points()), all = std::to_string(practice.answers().size());
    ui::wrapped_text(workspace.tr()("{points} of {all} right the first time", {{"points", points}, {"all", all}}));
    ui::command_button(workspace, commands, "exercise.give_up");
    ui::command_button(workspace, commands, "exercise.end");
}

void ExercisesPanel::show_question(Workspace& workspace, std::size_t place)
{
    Session& session = workspace.session;
    const Practice& practice = *session.practice();
    ui::wrapped_text(question(practice.exercise().asked[place], practice.exercise(), session.tr()));
    const auto& answer = practice.answers()[place];
    const std::string text = answer ? session.look.number(*answer) : "";
    const bool begins = workspace.is_asking_next && practice.next_to_answer() == place;
    if (begins) workspace.is_asking_next = false;
    const auto event = fields_.show("###answer" + std::to_string(place), {.text = text,
                                                                          .exact_text = text,
                                                                          .value = std::nullopt,
                                                                          .is_typed_only = true,
                                                                          .begins = begins,
                                                                          .stays = true});
    if (event.kind == Kind::Typed) {
        const auto reason = session.answer(place, event.text);
        if (reason) fields_.reject(event, session.tr()(*reason));
        else workspace.is_asking_next = true;
    }
    const Judgement& judgement = practice.judgements()[place];
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(judgement.verdict, session.look.theme));
    const std::string words = verdict_text(session, place);
    if (!words.empty()) ui::wrapped_text(words);
    ImGui::PopStyleColor();
    ImGui::Spacing();
}

} // namespace mohr
