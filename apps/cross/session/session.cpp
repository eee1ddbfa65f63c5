#include "apps/cross/session/session.h"

#include <algorithm>
#include <utility>

#include "apps/cross/document/file.h"
#include "apps/frame/document/fault/place.h"
#include "apps/frame/document/fault/sentence.h"
#include "femoop/files/whole_file.h"
#include "femoop/io/model_file.h"
#include "femoop/result/structure_words.h"

namespace cross {

namespace fc = femoop::cross;
using ui::Phrase;
using ui::translatable;

namespace {

constexpr double seconds_of_a_turn = 1.2;
constexpr std::size_t most_turns = 2000; // by "finish"

} // namespace

Session::Session()
    : OpenDocument(starting_document(), files::write_whole_file), history_(starting_document(), translatable("Begin"))
{
    solve_anew();
}

void Session::solve_anew(Haste haste)
{
    states_.reset();
    hover.reset(); // its joint may be gone
    ++n_solved_;
    solution_ = solve(document(), haste);
    solution_.faults = frame::named(std::move(solution_.faults), document().model);
    judge_paper();
    find_state();
}

// The sheets as they were filled, turn by turn.
void Session::show_solved()
{
    const Task& task = *solution_.task;
    state_ = task.balanced;
    for (std::size_t stage = 0; stage < std::min(paper_->n_sheets(), solution_.sheets.size()); ++stage)
        solution_.sheets[stage] = fc::sheet_of(task.problem, task.loading(stage), paper_->form.turns[stage],
                                               task.procedure);
}

void Session::work_anew()
{
    work(solution_, document());
    find_state();
}

void Session::find_state()
{
    state_.reset();
    if (paper() != nullptr) {
        if (solution_.task && !hides_results()) show_solved();
        return;
    }
    const bool has_all = sheet() != nullptr || (solution_.task && solution_.task->all);
    if (!solution_.task || !has_all) return;
    try {
        const fc::Problem& problem = solution_.task->problem;
        if (!states_) states_ = std::make_shared<fc::StateAnalysis>(document().model, problem);
        state_ = states_->solve(document().model, problem, present_locks(document(), solution_, phase_));
    } catch (const femoop::ModelError& error) {
        solution_.task->remarks = error.faults();
    }
}

const Play* Session::play() const
{
    return document().stage < document().plays.size() ? &document().plays[document().stage] : nullptr;
}

std::optional<Phrase> Session::why_no_turn() const
{
    if (!solution_.task) return Phrase(translatable("this structure cannot be distributed"));
    if (paper() != nullptr) return Phrase(translatable("the sheet is yours to fill; end the exercise first"));
    if (sheet() == nullptr) return Phrase(translatable("all sheets are seen together; choose one of them first"));
    if (solution_.sheet_problem(document()).balanced_joints().empty())
        return Phrase(translatable("there is no joint to balance"));
    return std::nullopt;
}

std::optional<Phrase> Session::why_no_step() const
{
    if (const auto reason = why_no_turn()) return reason;
    if (sheet()->is_balanced && (play() == nullptr || play()->n_ahead() == 0))
        return Phrase(translatable("every joint is balanced; click one to go on"));
    return std::nullopt;
}

template <class Change> void Session::play_on(const Change& change, const Phrase& label)
{
    Document next = document();
    if (next.plays.size() <= next.stage) next.plays.resize(next.stage + 1);
    change(next.plays[next.stage]);
    history_.apply(std::move(next), label);
    work_anew();
}

void Session::take(const Play::Turn& turn)
{
    const auto change = [&](Play& play) { play.take(turn); };
    if (!turn) return play_on(change, translatable("Balance all joints at once"));
    const femoop::NodeId node = solution_.task->problem[*turn].node;
    play_on(change, {translatable("Balance joint {joint}"), {{"joint", document().model[node].id}}});
}

std::optional<Phrase> Session::balance(const Play::Turn& clicked)
{
    if (const auto reason = why_no_turn()) return reason;
    const Play::Turn turn = clicked ? solution_.sheet_problem(document()).balanced_for(*clicked) : clicked;
    if (clicked && !turn)
        return Phrase(translatable("this joint stands on the axis of a symmetric structure and does not turn"));
    if (turn && solution_.task->problem[*turn].is_released_once && sheet()->end.rotations[turn->index] != 0.0)
        return Phrase(translatable("this joint was released for good and is never locked again"));
    phase_ = 0.0;
    take(turn);
    return std::nullopt;
}

std::optional<Phrase> Session::step()
{
    if (const auto reason = why_no_step()) return reason;
    if (play() == nullptr || play()->n_ahead() == 0) return balance(*next_turn(document(), solution_));
    phase_ = 0.0;
    play_on([](Play& play) { play.forward(); }, translatable("Step"));
    return std::nullopt;
}

std::optional<Phrase> Session::back()
{
    if (const auto reason = why_no_turn()) return reason;
    if (play() == nullptr || play()->length() == 0)
        return Phrase(translatable("every joint is locked: this is the start"));
    phase_ = 1.0;
    play_on([](Play& play) { play.back(); }, translatable("Step back"));
    return std::nullopt;
}

void Session::restart()
{
    is_playing = false;
    jump(0);
}

void Session::jump(std::size_t n_turns)
{
    if (play() == nullptr) return;
    phase_ = 1.0;
    play_on([&](Play& play) { play.jump(n_turns); }, translatable("Jump"));
}

void Session::go_to_branch(std::size_t place)
{
    phase_ = 1.0;
    play_on([&](Play& play) { play.go_to(place); }, translatable("Go to another branch"));
}

std::optional<Phrase> Session::finish()
{
    if (const auto reason = why_no_step()) return reason;
    is_playing = false;
    phase_ = 1.0;
    Document next = document();
    if (next.plays.size() <= next.stage) next.plays.resize(next.stage + 1);
    for (std::size_t n = 0; n < most_turns && !solution_.sheets[next.stage].is_balanced; ++n) {
        next.plays[next.stage].take(*next_turn(next, solution_));
        work(solution_, next);
    }
    const bool is_balanced = solution_.sheets[next.stage].is_balanced;
    history_.apply(std::move(next), translatable("Go through"));
    work_anew();
    if (is_balanced) return std::nullopt;
    return Phrase(translatable("rounding keeps the sheet from its tolerance; take more digits or a larger tolerance"));
}

void Session::set_method(const Method& method, const Phrase& label)
{
    if (method == document().method || refuse_in_exercise()) return;
    Document next = unworked(document());
    next.method = method;
    is_playing = false;
    phase_ = 1.0;
    history_.apply(std::move(next), label);
    solve_anew();
}

void Session::set_stage(std::size_t stage)
{
    if (paper() != nullptr) return show_paper_stage(stage);
    Document next = document();
    next.stage = std::min(stage, n_stages() - 1);
    is_playing = false;
    phase_ = 1.0;
    history_.apply(std::move(next), translatable("Choose a sheet"));
    work_anew();
}

std::size_t Session::n_stages() const
{
    if (paper() != nullptr) return paper()->n_stages();
    if (!solution_.task || solution_.task->problem.sways.empty()) return 1;
    return solution_.task->n_sheets() + (solution_.task->all ? 1 : 0);
}

void Session::change(femoop::Model model, const Phrase& label)
{
    drag(std::move(model), label);
    settle();
}

void Session::drag(femoop::Model model, const Phrase& label)
{
    if (refuse_in_exercise()) return;
    Document next = unworked(document());
    next.model = std::move(model);
    is_playing = false;
    phase_ = 1.0;
    history_.drag(std::move(next), label);
    solve_anew(Haste::Dragging);
}

void Session::settle()
{
    history_.settle();
    if (solution_.task && !solution_.task->kani) solve_anew();
}

void Session::undo()
{
    history_.undo();
    phase_ = 1.0;
    solve_anew();
}

void Session::redo()
{
    history_.redo();
    phase_ = 1.0;
    solve_anew();
}

void Session::restart_with(Document document)
{
    begin(document);
    seen_ = {Seen{{}, document.pupil ? document.pupil->helped : std::vector<bool>{}}};
    present_ = 0;
    cell_.reset();
    paper_stage_ = 0;
    history_ = ui::History<Document>(std::move(document), translatable("Begin"));
    is_playing = false;
    phase_ = 1.0;
    hover.reset();
    look.zoom = {};
    solve_anew();
}

void Session::begin_anew() { restart_with(starting_document()); }

std::optional<Phrase> Session::read(const std::filesystem::path& path)
{
    try {
        restart_with(read_document_file(path));
        leave_unfit_exercise();
        return std::nullopt;
    } catch (const femoop::ModelError& error) {
        return Phrase(frame::sentence(error.faults().front(), tr()));
    }
}

std::string Session::file_text() const
{
    Document whole = document();
    if (whole.pupil) whole.pupil->helped = seen_[present_].helped;
    return write_document(whole);
}

std::string Session::about() const { return femoop::size_words(document().model, tr()); }

std::string Session::linked_text() const { return femoop::write_model(document().model); }

namespace {

/// Nothing where the text is none of a structure.
std::optional<femoop::Model> model_of(const std::string& text)
{
    try {
        return read_document(text).model;
    } catch (const femoop::ModelError&) {
        return std::nullopt;
    }
}

} // namespace

bool Session::is_news(const std::string& text) const
{
    const auto model = model_of(text);
    return model && femoop::write_model(*model) != linked_text();
}

void Session::take_over(const std::string& text)
{
    auto model = model_of(text);
    if (!model || refuse_in_exercise()) return;
    Document next = unworked(document());
    next.model = std::move(*model);
    if (next.method.load_case.index >= next.model.n_cases()) next.method.load_case = femoop::CaseId(0);
    if (const Solution solution = solve(next); !solution.faults.empty())
        return tell(translatable("moment distribution cannot do what the frame has now; it stays as it was"));
    is_playing = false;
    phase_ = 1.0;
    history_.apply(std::move(next), translatable("Take over from the frame"));
    solve_anew();
}

void Session::tick(double seconds)
{
    ui::tick(notice, seconds);
    if (phase_ < 1.0) {
        phase_ = std::min(1.0, phase_ + seconds / seconds_of_a_turn);
        find_state();
    } else if (is_playing && step()) {
        is_playing = false;
    }
}

Scene Session::scene() const
{
    return {document(), solution_, state_ ? &*state_ : nullptr, phase_, hover, look, paper(), cell_, paper_stage_};
}

} // namespace cross
