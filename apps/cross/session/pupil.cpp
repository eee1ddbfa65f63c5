// What a session does while a pupil fills the sheet.
#include <algorithm>
#include <utility>

#include "apps/cross/session/session.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/pupil_words.h"

namespace cross {

namespace fc = femoop::cross;
using ui::Phrase;
using ui::translatable;

void Session::judge_paper()
{
    if (!document().pupil) {
        note_all_seen();
        paper_.reset();
        cell_.reset();
        return;
    }
    const std::size_t before = paper_ ? paper_->form.blanks.size() : 0;
    paper_ = paper_of(document());
    const std::size_t n = paper_ ? paper_->form.blanks.size() : 0;
    present_ = document().pupil->number;
    if (seen_.size() <= present_) seen_.resize(present_ + 1);
    seen_[present_].helped.resize(n);
    seen_[present_].n_hints.resize(n);
    if (cell_ && (n != before || cell_->index >= n)) cell_.reset();
    if (paper_) paper_stage_ = std::min(paper_stage_, paper_->n_stages() - 1);
    note_mistakes();
}

// Whoever saw that a cell is wrong gets no point for it.
void Session::note_mistakes()
{
    if (!paper_ || !paper_->is_told) return;
    std::vector<bool>& helped = seen_[present_].helped;
    for (std::size_t i = 0; i < helped.size(); ++i)
        if (paper_->is_written(fc::BlankId(i)) && !paper_->is_good(fc::BlankId(i))) helped[i] = true;
}

// Whoever left the exercise, by Ctrl+Z too, saw what belongs in the cells that were not right.
void Session::note_all_seen()
{
    if (!paper_ || paper_->is_solved()) return;
    std::vector<bool>& helped = seen_[present_].helped;
    for (std::size_t i = 0; i < helped.size(); ++i)
        if (!paper_->is_good(fc::BlankId(i))) helped[i] = true;
}

void Session::leave_unfit_exercise()
{
    if (!document().pupil || paper() != nullptr) return;
    Document without = document();
    without.pupil.reset();
    restart_with(std::move(without));
    forget_saved();
    tell(translatable("the exercise that is saved here does not fit this structure and was left out"));
}

bool Session::refuse_in_exercise()
{
    if (paper() == nullptr) return false;
    tell(translatable("the exercise is about this structure as it is; end the exercise first"));
    return true;
}

std::optional<Phrase> Session::why_no_paper() const
{
    if (paper() != nullptr) return std::nullopt;
    return Phrase(translatable("no exercise is being done"));
}

std::optional<Phrase> Session::why_no_own_exercise() const
{
    if (paper() != nullptr) return Phrase(translatable("an exercise is being done"));
    if (!solution_.task) return Phrase(translatable("this structure cannot be distributed"));
    if (solution_.task->problem.joints.empty()) return Phrase(translatable("there is no joint to balance"));
    if (!fc::is_for_hand(solution_.task->problem))
        return Phrase(translatable("on an elastic foundation no hand finds the stiffness factors"));
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
    const bool has_paper = paper_of(next).has_value();
    if (!has_paper) {
        tell(translatable("this structure has too many cells for an exercise"));
        return;
    }
    paper_stage_ = 0;
    is_playing = false;
    phase_ = 1.0;
    history_.apply(std::move(next), translatable("Begin an exercise"));
    solve_anew();
    cell_ = neighbour(1, true);
}

void Session::end_exercise()
{
    Document next = document();
    next.pupil.reset();
    history_.apply(std::move(next), translatable("End the exercise"));
    solve_anew();
}

void Session::go_to_cell(std::optional<fc::BlankId> cell)
{
    cell_ = cell;
    if (cell_ && paper_) paper_stage_ = paper_->stage_of(*cell_);
}

std::optional<fc::BlankId> Session::neighbour(int step, bool only_open) const
{
    if (paper() == nullptr) return std::nullopt;
    const auto n = static_cast<int>(paper()->form.blanks.size());
    const int here = cell_ ? static_cast<int>(cell_->index) : step > 0 ? -1 : n;
    for (int i = here + step; i >= 0 && i < n; i += step) {
        const fc::BlankId id(static_cast<std::size_t>(i));
        const bool is_done = paper()->is_told ? paper()->is_good(id) : paper()->is_written(id);
        if (!only_open || (!is_done && !paper()->form[id].may_stay_empty)) return id;
    }
    return std::nullopt;
}

void Session::change_pupil(Pupil pupil, const Phrase& label)
{
    Document next = document();
    next.pupil = std::move(pupil);
    const bool hid = hides_results();
    history_.apply(std::move(next), label);
    judge_anew(*paper_, document());
    note_mistakes();
    find_state();
    if (hid && !hides_results()) tell(translatable("every cell is right: the sheet is done"));
}

std::optional<Phrase> Session::write(fc::BlankId cell, const std::string& text)
{
    if (const auto reason = why_no_paper()) return reason;
    if (cell.index >= paper()->form.blanks.size()) return Phrase(translatable("there is no such cell"));
    const bool is_blank = text.find_first_not_of(" \t") == std::string::npos;
    if (!is_blank && !entry_typed(text))
        return Phrase(translatable("found \"{text}\", wanted a number such as 12.5, -20 or 1/3"),
                      {{"text", text.substr(0, 40)}});
    Pupil pupil = *document().pupil;
    pupil.written.resize(paper()->form.blanks.size());
    const std::string wanted = is_blank ? "" : text;
    if (pupil.written[cell.index] == wanted) return std::nullopt;
    pupil.written[cell.index] = wanted;
    pupil.is_judged = false;
    change_pupil(std::move(pupil),
                 {translatable("Write {cell}"), {{"cell", question(*paper(), document().model, cell)}}});
    return std::nullopt;
}

void Session::show_cell()
{
    if (paper() == nullptr || !cell_) return;
    seen_[present_].helped[cell_->index] = true;
    write(*cell_, text_for(*paper(), *cell_, units_of(document().model, look.tr)));
}

void Session::give_hint()
{
    if (paper() == nullptr || !cell_) return;
    std::size_t& n = seen_[present_].n_hints[cell_->index];
    n = std::min(n + 1, fc::hints_for(paper()->form, *cell_).size());
}

std::vector<fc::Hint> Session::hints() const
{
    if (paper() == nullptr || !cell_) return {};
    std::vector<fc::Hint> given = fc::hints_for(paper()->form, *cell_);
    given.resize(std::min(given.size(), seen_[present_].n_hints[cell_->index]));
    return given;
}

void Session::start_over()
{
    if (paper() == nullptr) return;
    const std::size_t n_cells = paper()->form.blanks.size();
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
    if (paper() == nullptr) return;
    Pupil pupil = *document().pupil;
    pupil.judges_at_once = does;
    change_pupil(std::move(pupil), does ? translatable("Judge at once") : translatable("Judge at the end"));
}

void Session::judge_now()
{
    if (paper() == nullptr) return;
    Pupil pupil = *document().pupil;
    pupil.is_judged = true;
    change_pupil(std::move(pupil), translatable("Judge now"));
}

void Session::show_paper_stage(std::size_t stage)
{
    if (paper() == nullptr) return;
    paper_stage_ = std::min(stage, paper()->n_stages() - 1);
    cell_.reset();
}

std::size_t Session::points() const
{
    if (paper() == nullptr || !paper()->is_told) return 0;
    std::size_t n = 0;
    const std::vector<bool>& helped = seen_[present_].helped;
    for (std::size_t i = 0; i < helped.size(); ++i) {
        const fc::BlankId id(i);
        n += !paper()->form[id].may_stay_empty && paper()->is_good(id) && !helped[i] ? 1 : 0;
    }
    return n;
}

} // namespace cross
