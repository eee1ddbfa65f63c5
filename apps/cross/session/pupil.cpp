// What a session does while a pupil fills the sheet.
#include <algorithm>
#include <utility>

#include "apps/cross/session/session.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/pupil_words.h"

namespace cross {

namespace fc = femoop::cross;
using ui::Message;
using ui::translatable;

void Session::judge_worksheet()
{
    if (!document().pupil) {
        note_all_seen();
        worksheet_.reset();
        cell_.reset();
        return;
    }
    const std::size_t before = worksheet_ ? worksheet_->form.blanks.size() : 0;
    worksheet_ = worksheet_of(document());
    const std::size_t n = worksheet_ ? worksheet_->form.blanks.size() : 0;
    present_ = document().pupil->number;
    if (seen_.size() <= present_) seen_.resize(present_ + 1);
    seen_[present_].helped.resize(n);
    seen_[present_].n_hints.resize(n);
    if (cell_ && (n != before || cell_->index >= n)) cell_.reset();
    if (worksheet_) worksheet_stage_ = std::min(worksheet_stage_, worksheet_->n_stages() - 1);
    note_mistakes();
}

std::optional<Message> Session::why_not_here() const
{
    if (!hides_results() || document().pupil || seen_[present_].is_solution_seen) return std::nullopt;
    return Message(translatable("an exercise is being done; end it first: Exercise, End the exercise"));
}

// Whoever saw that a cell is wrong gets no point for it.
void Session::note_mistakes()
{
    if (!worksheet_ || !worksheet_->shows_judgement) return;
    std::vector<bool>& helped = seen_[present_].helped;
    for (std::size_t i = 0; i < helped.size(); ++i)
        if (worksheet_->is_written(fc::BlankId(i)) && !worksheet_->is_good(fc::BlankId(i))) helped[i] = true;
}

// Whoever left the exercise saw what belongs in the cells that were not right.
void Session::note_all_seen()
{
    if (!worksheet_ || worksheet_->is_solved()) return;
    seen_[present_].is_solution_seen = true;
    std::vector<bool>& helped = seen_[present_].helped;
    for (std::size_t i = 0; i < helped.size(); ++i)
        if (!worksheet_->is_good(fc::BlankId(i))) helped[i] = true;
}

void Session::leave_unfit_exercise()
{
    if (!document().pupil || worksheet() != nullptr) return;
    Document without = document();
    without.pupil.reset();
    restart_with(std::move(without));
    forget_saved();
    notify(translatable("the exercise that is saved here does not fit this structure and was left out"));
}

bool Session::refuse_in_exercise()
{
    if (worksheet() == nullptr) return false;
    notify(translatable("the exercise is about this structure as it is; end the exercise first"));
    return true;
}

std::optional<Message> Session::why_no_worksheet() const
{
    if (worksheet() != nullptr) return std::nullopt;
    return Message(translatable("no exercise is being done"));
}

std::optional<Message> Session::why_no_own_exercise() const
{
    if (worksheet() != nullptr) return Message(translatable("an exercise is being done"));
    if (!solution_.task) return Message(translatable("this structure cannot be distributed"));
    if (solution_.task->problem.joints.empty()) return Message(translatable("there is no joint to balance"));
    if (!fc::is_for_hand(solution_.task->problem))
        return Message(translatable("on an elastic foundation and along a taper no hand finds the stiffness factors"));
    return std::nullopt;
}

void Session::begin_exercise(const Seeded& seeded)
{
    Document fresh{.model = fc::seeded_model(seeded.difficulty, seeded.seed)};
    const bool judges_at_once = !document().pupil || document().pupil->judges_at_once;
    fresh.pupil = Pupil{.seeded = seeded, .judges_at_once = judges_at_once};
    restart_with(std::move(fresh));
    cell_ = neighbour(1, true);
}

void Session::begin_own_exercise()
{
    Document next = unworked(document());
    next.pupil = Pupil{.number = seen_.size()};
    const bool has_worksheet = worksheet_of(next).has_value();
    if (!has_worksheet) {
        notify(translatable("this structure has too many cells for an exercise"));
        return;
    }
    worksheet_stage_ = 0;
    is_playing = false;
    phase_ = 1.0;
    history_.apply(std::move(next), translatable("Begin an exercise"));
    solve_again();
    cell_ = neighbour(1, true);
}

void Session::end_exercise()
{
    Document next = document();
    next.pupil.reset();
    history_.apply(std::move(next), translatable("End the exercise"));
    solve_again();
}

void Session::go_to_cell(std::optional<fc::BlankId> cell)
{
    cell_ = cell;
    if (cell_ && worksheet_) worksheet_stage_ = worksheet_->stage_of(*cell_);
}

std::optional<fc::BlankId> Session::neighbour(int step, bool only_open) const
{
    if (worksheet() == nullptr) return std::nullopt;
    const auto n = static_cast<int>(worksheet()->form.blanks.size());
    const int here = cell_ ? static_cast<int>(cell_->index) : step > 0 ? -1 : n;
    for (int i = here + step; i >= 0 && i < n; i += step) {
        const fc::BlankId id(static_cast<std::size_t>(i));
        const bool is_done = worksheet()->shows_judgement ? worksheet()->is_good(id) : worksheet()->is_written(id);
        if (!only_open || (!is_done && !worksheet()->form[id].may_stay_empty)) return id;
    }
    return std::nullopt;
}

void Session::change_pupil(Pupil pupil, const Message& label)
{
    Document next = document();
    next.pupil = std::move(pupil);
    const bool hid = hides_results();
    history_.apply(std::move(next), label);
    judge_again(*worksheet_, document());
    note_mistakes();
    find_state();
    if (!hid || hides_results()) return;
    seen_[present_].is_solution_seen = true;
    notify(translatable("every cell is right: the sheet is done"));
}

std::optional<Message> Session::write(fc::BlankId cell, const std::string& text)
{
    if (const auto reason = why_no_worksheet()) return reason;
    if (cell.index >= worksheet()->form.blanks.size()) return Message(translatable("there is no such cell"));
    const bool is_blank = text.find_first_not_of(" \t") == std::string::npos;
    if (!is_blank && !entry_typed(text))
        return Message(translatable("found \"{text}\", wanted a number such as 12.5, -20 or 1/3"),
                       {{"text", text.substr(0, 40)}});
    Pupil pupil = *document().pupil;
    pupil.written.resize(worksheet()->form.blanks.size());
    const std::string wanted = is_blank ? "" : text;
    if (pupil.written[cell.index] == wanted) return std::nullopt;
    pupil.written[cell.index] = wanted;
    pupil.is_judged = false;
    change_pupil(std::move(pupil),
                 {translatable("Write {cell}"), {{"cell", question(*worksheet(), document().model, cell)}}});
    return std::nullopt;
}

void Session::show_cell()
{
    if (worksheet() == nullptr || !cell_) return;
    seen_[present_].helped[cell_->index] = true;
    write(*cell_, text_for(*worksheet(), *cell_, units_of(document().model, look.tr)));
}

void Session::give_hint()
{
    if (worksheet() == nullptr || !cell_) return;
    std::size_t& n = seen_[present_].n_hints[cell_->index];
    n = std::min(n + 1, fc::hints_for(worksheet()->form, *cell_).size());
}

std::vector<fc::Hint> Session::hints() const
{
    if (worksheet() == nullptr || !cell_) return {};
    std::vector<fc::Hint> given = fc::hints_for(worksheet()->form, *cell_);
    given.resize(std::min(given.size(), seen_[present_].n_hints[cell_->index]));
    return given;
}

void Session::start_over()
{
    if (worksheet() == nullptr) return;
    const std::size_t n_cells = worksheet()->form.blanks.size();
    Pupil pupil = *document().pupil;
    pupil.written.clear();
    pupil.is_judged = false;
    change_pupil(std::move(pupil), translatable("Start over"));
    seen_[present_] = {std::vector<std::size_t>(n_cells), std::vector<bool>(n_cells)};
    cell_.reset();
    go_to_cell(neighbour(1, true));
}

void Session::judge_at_once(bool does)
{
    if (worksheet() == nullptr) return;
    Pupil pupil = *document().pupil;
    pupil.judges_at_once = does;
    change_pupil(std::move(pupil), does ? translatable("Judge at once") : translatable("Judge at the end"));
}

void Session::judge_now()
{
    if (worksheet() == nullptr) return;
    Pupil pupil = *document().pupil;
    pupil.is_judged = true;
    change_pupil(std::move(pupil), translatable("Judge now"));
}

void Session::show_worksheet_stage(std::size_t stage)
{
    if (worksheet() == nullptr) return;
    worksheet_stage_ = std::min(stage, worksheet()->n_stages() - 1);
    cell_.reset();
}

std::size_t Session::points() const
{
    if (worksheet() == nullptr || !worksheet()->shows_judgement) return 0;
    std::size_t n = 0;
    const std::vector<bool>& helped = seen_[present_].helped;
    for (std::size_t i = 0; i < helped.size(); ++i) {
        const fc::BlankId id(i);
        n += !worksheet()->form[id].may_stay_empty && worksheet()->is_good(id) && !helped[i] ? 1 : 0;
    }
    return n;
}

} // namespace cross
