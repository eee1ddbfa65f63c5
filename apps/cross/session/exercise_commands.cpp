#include "apps/cross/session/exercise_commands.h"

#include <array>
#include <limits>

#include "apps/cross/view/pupil_words.h"

namespace cross {

namespace fc = femoop::cross;
using ui::Key;
using ui::Phrase;
using ui::translatable;

namespace {

constexpr std::string_view exercise_menu = translatable("Exercise");

constexpr std::array<std::string_view, n_difficulties> difficulty_ids{"exercise.difficulty.1", "exercise.difficulty.2",
                                                                      "exercise.difficulty.3", "exercise.difficulty.4",
                                                                      "exercise.difficulty.5", "exercise.difficulty.6"};

std::optional<Phrase> why_no_paper(const Desk& desk) { return desk.session.why_no_paper(); }

std::optional<Phrase> why_no_cell(const Desk& desk)
{
    if (const auto reason = why_no_paper(desk)) return reason;
    if (desk.session.cell()) return std::nullopt;
    return Phrase(translatable("choose a cell first"));
}

std::optional<Phrase> why_no_hint(const Desk& desk)
{
    if (const auto reason = why_no_cell(desk)) return reason;
    const Session& session = desk.session;
    if (session.hints().size() < fc::hints_for(session.paper()->form, *session.cell()).size()) return std::nullopt;
    return Phrase(translatable("there is no further hint for this cell"));
}

void add_beginnings(CommandTable& table)
{
    table.add({.id = "exercise.new",
               .menu = exercise_menu,
               .label = translatable("New exercise"),
               .shortcuts = {{Key::X, {}}},
               .run = [](Desk& desk) {
                   desk.leave_document([](Desk& left) {
                       left.session.begin_exercise(left.next_exercise);
                       if (left.next_exercise.seed < std::numeric_limits<std::uint32_t>::max())
                           ++left.next_exercise.seed;
                   });
               }});
    table.add({.id = "exercise.own",
               .menu = exercise_menu,
               .label = translatable("This structure as an exercise"),
               .run = [](Desk& desk) { desk.session.begin_own_exercise(); },
               .why_not = [](const Desk& desk) { return desk.session.why_no_own_exercise(); }});
    for (int i = 0; i < n_difficulties; ++i) {
        const auto difficulty = static_cast<fc::Difficulty>(i + 1);
        table.add({.id = difficulty_ids[static_cast<std::size_t>(i)],
                   .menu = exercise_menu,
                   .label = translatable("Difficulty"),
                   .run =
                       [difficulty](Desk& desk) {
                           desk.next_exercise = {difficulty, 1};
                       },
                   .is_on = [difficulty](const Desk& desk) { return desk.next_exercise.difficulty == difficulty; },
                   .live_label =
                       [difficulty](const Desk&) {
                           return Phrase(
                               translatable("Difficulty {n}: {what}"),
                               {{"n", std::to_string(static_cast<int>(difficulty))}, {"what", words_of(difficulty)}});
                       }});
    }
}

void add_cells(CommandTable& table)
{
    table.add({.id = "exercise.next_cell",
               .menu = exercise_menu,
               .label = translatable("To the next cell that is open"),
               .shortcuts = {{Key::N, {}}},
               .run =
                   [](Desk& desk) {
                       Session& session = desk.session;
                       const auto next = session.neighbour(1, true);
                       if (!next) session.go_to_cell({}); // from the beginning again
                       session.go_to_cell(next ? next : session.neighbour(1, true));
                   },
               .why_not = why_no_paper});
    table.add({.id = "exercise.hint",
               .menu = exercise_menu,
               .label = translatable("Hint"),
               .shortcuts = {{Key::H, {.ctrl = true}}},
               .run = [](Desk& desk) { desk.session.give_hint(); },
               .why_not = why_no_hint});
    table.add({.id = "exercise.show_cell",
               .menu = exercise_menu,
               .label = translatable("Show me this cell"),
               .run = [](Desk& desk) { desk.session.show_cell(); },
               .why_not = why_no_cell});
}

void add_judging(CommandTable& table)
{
    table.add({.id = "exercise.judge_at_once",
               .menu = exercise_menu,
               .label = translatable("Judge at once"),
               .run = [](Desk& desk) { desk.session.judge_at_once(!desk.session.document().pupil->judges_at_once); },
               .why_not = why_no_paper,
               .is_on =
                   [](const Desk& desk) {
                       const auto& pupil = desk.session.document().pupil;
                       return pupil && pupil->judges_at_once;
                   }});
    table.add({.id = "exercise.judge",
               .menu = exercise_menu,
               .label = translatable("Judge now"),
               .shortcuts = {{Key::J, {}}},
               .run = [](Desk& desk) { desk.session.judge_now(); },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   if (const auto reason = why_no_paper(desk)) return reason;
                   if (!desk.session.paper()->is_told) return std::nullopt;
                   return Phrase(translatable("everything is judged already"));
               }});
    table.add({.id = "exercise.start_over",
               .menu = exercise_menu,
               .label = translatable("Start over"),
               .run = [](Desk& desk) { desk.session.start_over(); },
               .why_not = why_no_paper});
    table.add({.id = "exercise.end",
               .menu = exercise_menu,
               .label = translatable("End the exercise"),
               .run = [](Desk& desk) { desk.session.end_exercise(); },
               .why_not = why_no_paper});
}

} // namespace

void add_exercise_commands(CommandTable& table)
{
    add_beginnings(table);
    add_cells(table);
    add_judging(table);
}

} // namespace cross
