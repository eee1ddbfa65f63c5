#include "apps/cross/session/exercise_commands.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "apps/cross/view/numbers.h"
#include "apps/cross/view/pupil_words.h"
#include "apps/cross/view/worksheet.h"

namespace cross {

namespace fc = femoop::cross;
using ui::Key;
using ui::Message;
using ui::Reason;
using ui::translatable;
using Menu = ui::MenuBuilder<Workspace>;

namespace {

constexpr std::string_view exercise_menu = translatable("Exercise");

constexpr std::array<std::string_view, n_difficulties> difficulty_ids{"exercise.difficulty.1", "exercise.difficulty.2",
                                                                      "exercise.difficulty.3", "exercise.difficulty.4",
                                                                      "exercise.difficulty.5", "exercise.difficulty.6"};

Reason why_no_worksheet(const Workspace& workspace) { return workspace.session.why_no_worksheet(); }

Reason why_no_cell(const Workspace& workspace)
{
    if (const auto reason = why_no_worksheet(workspace)) return reason;
    if (workspace.session.cell()) return std::nullopt;
    return Message(translatable("choose a cell first"));
}

Reason why_no_hint(const Workspace& workspace)
{
    if (const auto reason = why_no_cell(workspace)) return reason;
    const Session& session = workspace.session;
    if (session.hints().size() < fc::hints_for(session.worksheet()->form, *session.cell()).size()) return std::nullopt;
    return Message(translatable("there is no further hint for this cell"));
}

/// The list of difficulties marks its own, and the one after it is the next.
void begin_exercise(Workspace& workspace, const Seeded& exercise)
{
    workspace.leave_document([exercise](Workspace& left) {
        left.session.begin_exercise(exercise);
        left.next_exercise = exercise;
        if (exercise.seed < std::numeric_limits<std::uint32_t>::max()) ++left.next_exercise.seed;
    });
}

/// Of another difficulty the first one, else the one after the last that was begun.
void begin_exercise(Workspace& workspace, fc::Difficulty difficulty)
{
    const Seeded& next = workspace.next_exercise;
    begin_exercise(workspace, next.difficulty == difficulty ? next : Seeded{difficulty, 1});
}

void begin_next(Workspace& workspace) { begin_exercise(workspace, workspace.next_exercise.difficulty); }

void add_difficulty(Menu& menu, fc::Difficulty difficulty)
{
    const int n = static_cast<int>(difficulty);
    menu.choice(
            ui::Choice<fc::Difficulty>{difficulty, difficulty_ids[static_cast<std::size_t>(n - 1)],
                                       translatable("Difficulty")},
            [](const Workspace& workspace) { return workspace.next_exercise.difficulty; },
            [](Workspace& workspace, fc::Difficulty chosen) { begin_exercise(workspace, chosen); })
        .live_label = [=](const Workspace&) -> Message {
        return {translatable("Difficulty {n}: {what}"), {{"n", std::to_string(n)}, {"what", words_of(difficulty)}}};
    };
}

void add_beginnings(Menu& menu)
{
    menu.step({"exercise.new", translatable("New exercise"), {{Key::X, {}}}}, begin_next);
    menu.step(
        {"exercise.own", translatable("This structure as an exercise")},
        [](Workspace& workspace) { workspace.session.begin_own_exercise(); },
        [](const Workspace& workspace) { return workspace.session.why_no_own_exercise(); });
    for (int i = 1; i <= n_difficulties; ++i) add_difficulty(menu, static_cast<fc::Difficulty>(i));
}

void to_next_cell(Workspace& workspace)
{
    Session& session = workspace.session;
    const auto next = session.neighbour(1, true);
    if (!next) session.go_to_cell({}); // from the beginning again
    session.go_to_cell(next ? next : session.neighbour(1, true));
}

void add_cells(Menu& menu)
{
    menu.step({"exercise.next_cell", translatable("To the next cell that is open"), {{Key::N, {}}}}, to_next_cell,
              why_no_worksheet);
    menu.step(
        {"exercise.hint", translatable("Hint"), {{Key::H, ui::ctrl}}},
        [](Workspace& workspace) { workspace.session.give_hint(); }, why_no_hint);
    menu.step(
        {"exercise.show_cell", translatable("Show me this cell")},
        [](Workspace& workspace) { workspace.session.show_cell(); }, why_no_cell);
}

bool judges_at_once(const Workspace& workspace)
{
    const auto& pupil = workspace.session.document().pupil;
    return pupil && pupil->judges_at_once;
}

Reason why_not_judge(const Workspace& workspace)
{
    if (const auto reason = why_no_worksheet(workspace)) return reason;
    if (!workspace.session.worksheet()->shows_judgement) return std::nullopt;
    return Message(translatable("everything is judged already"));
}

void add_judging(Menu& menu)
{
    menu.toggle(
        {"exercise.judge_at_once", translatable("Judge at once")}, judges_at_once,
        [](Workspace& workspace, bool is_on) { workspace.session.judge_at_once(is_on); }, why_no_worksheet);
    menu.step(
        {"exercise.judge", translatable("Judge now"), {{Key::J, {}}}},
        [](Workspace& workspace) { workspace.session.judge_now(); }, why_not_judge);
    menu.step(
        {"exercise.start_over", translatable("Start over")},
        [](Workspace& workspace) { workspace.session.start_over(); }, why_no_worksheet);
    menu.step(
        {"exercise.end", translatable("End the exercise")}, [](Workspace& workspace) { workspace.end_exercise(); },
        why_no_worksheet);
}

/// "3 17": difficulty and number.
Reason begin(Workspace& workspace, const ui::Argument& argument)
{
    const auto numbers = argument.numbers(2);
    const auto is_whole = [&](std::size_t i, double least, double most) {
        const double n = numbers->at(i);
        return n >= least && n <= most && n == std::floor(n);
    };
    if (!numbers || !is_whole(0, 1.0, n_difficulties) || !is_whole(1, 0.0, std::numeric_limits<std::uint32_t>::max()))
        return argument.wanted("a difficulty from 1 to 6 and a whole number from 0 to 4294967295");
    begin_exercise(workspace, Seeded{static_cast<fc::Difficulty>(static_cast<int>(numbers->at(0))),
                                     static_cast<std::uint32_t>(numbers->at(1))});
    return std::nullopt;
}

/// So many of the cells that are empty, with what belongs in them.
Reason fill(Workspace& workspace, const ui::Argument& argument)
{
    Session& session = workspace.session;
    if (auto reason = session.why_no_worksheet()) return reason;
    const auto n = argument.number();
    if (!n || *n < 0.0) return argument.wanted("a number");
    const std::size_t n_cells = session.worksheet()->form.blanks.size();
    double open = *n;
    for (std::size_t i = 0; i < n_cells && open > 0.0; ++i) {
        const fc::BlankId cell(i);
        if (session.worksheet()->is_written(cell) || session.worksheet()->form[cell].may_stay_empty) continue;
        session.write(cell, text_for(*session.worksheet(), cell, units_of(session.document().model, session.tr())));
        open -= 1.0;
    }
    return std::nullopt;
}

} // namespace

void Workspace::end_exercise()
{
    const auto end = [](Workspace& workspace) { workspace.session.end_exercise(); };
    if (session.hides_results()) after_exercise = end;
    else end(*this);
}

void add_exercise_commands(CommandTable& table)
{
    Menu menu(table, exercise_menu);
    add_beginnings(menu);
    add_cells(menu);
    add_judging(menu);
    table.with_argument("exercise.new", begin);
    table.with_argument("exercise.fill", fill);
}

} // namespace cross
