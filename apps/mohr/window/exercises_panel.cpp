#include "apps/mohr/window/exercises_panel.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "apps/mohr/exercise/words.h"
#include "apps/mohr/view/names.h"
#include "apps/mohr/window/choice.h"
#include "ui/paint/theme.h"
#include "ui/text/language_manner.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/wrapped_text.h"

namespace mohr {

using Kind = ui::NumberFieldEvent::Kind;

namespace {

ImVec4 color_of(Verdict verdict, ui::ThemeName name)
{
    const ui::Theme theme(name);
    const ui::Role role = verdict == Verdict::Wrong ? ui::Role::Error : ui::Role::Reaction;
    const ui::Color c = theme[role].text;
    const auto part = [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; };
    return {part(c.r), part(c.g), part(c.b), 1.0F};
}

/// "σx = 50 MPa": the numbers that the exercise gives, a line each.
std::string given_words(const Session& session)
{
    const Document& document = session.document();
    std::string words;
    for (std::size_t i = 0; i < document.state().size(); ++i) {
        const std::string unit(bare_unit(document.subject, i));
        words += (i == 0 ? "" : "\n") + std::string(names(document.subject)[i]) + " = " +
                 with_unit(ui::with_minus_signs(document.state()[i]), unit);
    }
    if (ui::decimal_mark(session.tr().language()) == ui::DecimalMark::Comma) std::ranges::replace(words, '.', ',');
    return words;
}

std::string verdict_words(const Judgement& judgement, const ui::Catalogue& tr)
{
    switch (judgement.verdict) {
    case Verdict::Open: return "";
    case Verdict::Right: return tr("right");
    case Verdict::FollowsRight: return tr(judgement.words);
    case Verdict::Wrong: break;
    }
    return tr("not so: {why}", {{"why", tr(judgement.words)}});
}

} // namespace

void ExercisesPanel::show(Desk& desk, const CommandTable& commands)
{
    choice(desk, commands, "###exercise topic", exercise_topics(),
           [&](const ExerciseTopicEntry& entry) { return entry.value == desk.exercise_topic; });
    for (const char* id : {"exercise.easy", "exercise.medium", "exercise.hard"}) ui::command_button(desk, commands, id);
    ImGui::Separator();
    if (!desk.session.practice()) {
        ui::wrapped_text(
            desk.tr()("An exercise gives a state and asks for what follows from it. "
                      "Answers are judged one by one; what follows from a number that was wrong counts as right."));
        return;
    }
    ui::wrapped_text(given_words(desk.session));
    ImGui::Separator();
    for (std::size_t i = 0; i < desk.session.practice()->answers().size(); ++i) show_question(desk, i);
    ImGui::Separator();
    const Practice& practice = *desk.session.practice();
    const std::string points = std::to_string(practice.points()), all = std::to_string(practice.answers().size());
    ui::wrapped_text(desk.tr()("{points} of {all} right the first time", {{"points", points}, {"all", all}}));
    ui::command_button(desk, commands, "exercise.give_up");
    ui::command_button(desk, commands, "exercise.end");
}

void ExercisesPanel::show_question(Desk& desk, std::size_t place)
{
    Session& session = desk.session;
    const Practice& practice = *session.practice();
    ui::wrapped_text(question(practice.exercise().asked[place], practice.exercise(), session.tr()));
    const auto& answer = practice.answers()[place];
    const std::string text = answer ? session.look.number(*answer) : "";
    const bool begins = desk.is_asking_next && practice.first_open() == place;
    if (begins) desk.is_asking_next = false;
    const auto event = fields_.show(
        "###answer" + std::to_string(place),
        {.text = text, .exact_text = text, .value = std::nullopt, .begins = begins, .stays = true});
    if (event.kind == Kind::Typed) {
        const auto reason = session.answer(place, event.text);
        if (reason) fields_.reject(event, session.tr()(*reason));
        else desk.is_asking_next = true;
    }
    const Judgement& judgement = practice.judgements()[place];
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(judgement.verdict, session.look.theme));
    const std::string words = verdict_words(judgement, session.tr());
    if (!words.empty()) ui::wrapped_text(words);
    ImGui::PopStyleColor();
    ImGui::Spacing();
}

} // namespace mohr
