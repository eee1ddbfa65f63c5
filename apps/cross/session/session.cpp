#include "apps/cross/session/session.h"

#include <algorithm>
#include <utility>

#include "apps/cross/document/file.h"
#include "apps/frame/document/fault/place.h"
#include "apps/frame/document/fault/sentence.h"
#include "femoop/edit/excerpt.h"
#include "femoop/io/model_file.h"
#include "femoop/result/structure_words.h"

namespace cross {

namespace fc = femoop::cross;
using ui::Message;
using ui::translatable;

namespace {

constexpr double seconds_of_a_turn = 1.2;
constexpr std::size_t most_turns = 2000;           // by "finish"
constexpr double seconds_of_a_double_click = 0.35; // a little more than the window allows

} // namespace

Session::Session() : EditedDocument(starting_document()) { solve_again(); }

void Session::solve_again(SolveMode mode)
{
    states_.reset();
    waiting_.reset();
    hover.reset(); // its joint may be gone
    ++n_solved_;
    solution_ = solve(document(), mode);
    solution_.faults = frame::named(std::move(solution_.faults), document().model);
    judge_worksheet();
    find_state();
}

// The sheets as they were filled, turn by turn.
void Session::show_solved()
{
    const Task& task = *solution_.task;
    state_ = task.balanced;
    for (std::size_t stage = 0; stage < std::min(worksheet_->n_sheets(), solution_.sheets.size()); ++stage)
        solution_.sheets[stage] = fc::sheet_of(task.problem, task.loading(stage), worksheet_->form.turns[stage],
                                               task.procedure);
}

void Session::work_again()
{
    work(solution_, document());
    find_state();
}

void Session::find_state()
{
    state_.reset();
    if (worksheet() != nullptr) {
        if (solution_.task && !hides_results()) show_solved();
        return;
    }
    const bool has_all = sheet() != nullptr || (solution_.task && solution_.task->all);
    if (!solution_.task || !has_all) return;
    try {
        const fc::Problem& problem = solution_.task->problem;
        if (!states_) states_ = std::make_shared<fc::StateAnalysis>(document().model, problem);
        state_ = states_->solve(document().model, problem, present_locks(document(), solution_, phase()));
    } catch (const femoop::ModelError& error) {
        solution_.task->remarks = error.faults();
    }
}

const TurnTree* Session::turn_tree() const
{
    return document().stage < document().plays.size() ? &document().plays[document().stage] : nullptr;
}

std::optional<Message> Session::why_no_turn() const
{
    if (!solution_.task) return Message(translatable("this structure cannot be distributed"));
    if (worksheet() != nullptr) return Message(translatable("the sheet is yours to fill; end the exercise first"));
    if (sheet() == nullptr) return Message(translatable("all sheets are seen together; choose one of them first"));
    if (solution_.sheet_problem(document()).balanced_joints().empty())
        return Message(translatable("there is no joint to balance"));
    return std::nullopt;
}

std::optional<Message> Session::why_no_step() const
{
    if (const auto reason = why_no_turn()) return reason;
    if (sheet()->is_balanced && (turn_tree() == nullptr || turn_tree()->n_ahead() == 0))
        return Message(translatable("every joint is balanced; click one to go on"));
    return std::nullopt;
}

template <class Change> void Session::play_on(const Change& change, const Message& label)
{
    Document next = document();
    if (next.plays.size() <= next.stage) next.plays.resize(next.stage + 1);
    change(next.plays[next.stage]);
    history_.apply(std::move(next), label);
    work_again();
}

void Session::advance(const TurnTree::Turn& turn)
{
    const auto change = [&](TurnTree& turn_tree) { turn_tree.advance(turn); };
    if (!turn) return play_on(change, translatable("Balance all joints at once"));
    const femoop::NodeId node = solution_.task->problem[*turn].node;
    play_on(change, {translatable("Balance joint {joint}"), {{"joint", document().model[node].id}}});
}

std::optional<Message> Session::balance(const TurnTree::Turn& clicked)
{
    if (const auto reason = why_no_turn()) return reason;
    const TurnTree::Turn turn = clicked ? solution_.sheet_problem(document()).balanced_for(*clicked) : clicked;
    if (clicked && !turn)
        return Message(translatable("this joint stands on the axis of a symmetric structure and does not turn"));
    if (turn && solution_.task->problem[*turn].is_released_once && sheet()->end.rotations[turn->index] != 0.0)
        return Message(translatable("this joint was released for good and is never locked again"));
    phase_ = 0.0;
    advance(turn);
    return std::nullopt;
}

std::optional<Message> Session::step()
{
    if (const auto reason = why_no_step()) return reason;
    if (turn_tree() == nullptr || turn_tree()->n_ahead() == 0) return balance(*next_turn(document(), solution_));
    phase_ = 0.0;
    play_on([](TurnTree& turn_tree) { turn_tree.forward(); }, translatable("Step"));
    return std::nullopt;
}

std::optional<Message> Session::back()
{
    if (const auto reason = why_no_turn()) return reason;
    if (turn_tree() == nullptr || turn_tree()->length() == 0)
        return Message(translatable("every joint is locked: this is the start"));
    phase_ = 1.0;
    play_on([](TurnTree& turn_tree) { turn_tree.back(); }, translatable("Step back"));
    return std::nullopt;
}

void Session::restart()
{
    is_playing = false;
    jump(0);
}

void Session::jump(std::size_t n_turns)
{
    if (turn_tree() == nullptr) return;
    phase_ = 1.0;
    play_on([&](TurnTree& turn_tree) { turn_tree.jump(n_turns); }, translatable("Jump"));
}

void Session::go_to_branch(std::size_t place)
{
    phase_ = 1.0;
    play_on([&](TurnTree& turn_tree) { turn_tree.go_to(place); }, translatable("Go to another branch"));
}

std::optional<Message> Session::finish()
{
    if (const auto reason = why_no_step()) return reason;
    is_playing = false;
    phase_ = 1.0;
    Document next = document();
    if (next.plays.size() <= next.stage) next.plays.resize(next.stage + 1);
    for (std::size_t n = 0; n < most_turns && !solution_.sheets[next.stage].is_balanced; ++n) {
        next.plays[next.stage].advance(*next_turn(next, solution_));
        work(solution_, next);
    }
    const bool is_balanced = solution_.sheets[next.stage].is_balanced;
    history_.apply(std::move(next), translatable("Go through"));
    work_again();
    if (is_balanced) return std::nullopt;
    return Message(translatable("rounding keeps the sheet from its tolerance; take more digits or a larger tolerance"));
}

void Session::set_method(const Method& method, const Message& label)
{
    if (method == document().method || refuse_in_exercise()) return;
    Document next = unworked(document());
    next.method = method;
    is_playing = false;
    phase_ = 1.0;
    history_.apply(std::move(next), label);
    solve_again();
}

void Session::set_stage(std::size_t stage)
{
    if (worksheet() != nullptr) return show_worksheet_stage(stage);
    Document next = document();
    next.stage = std::min(stage, n_stages() - 1);
    is_playing = false;
    phase_ = 1.0;
    history_.apply(std::move(next), translatable("Choose a sheet"));
    work_again();
}

std::size_t Session::n_stages() const
{
    if (worksheet() != nullptr) return worksheet()->n_stages();
    if (!solution_.task || solution_.task->problem.sways.empty()) return 1;
    return solution_.task->n_sheets() + (solution_.task->all ? 1 : 0);
}

void Session::change(femoop::Model model, const Message& label)
{
    drag(std::move(model), label);
    settle();
}

void Session::drag(femoop::Model model, const Message& label)
{
    if (refuse_in_exercise()) return;
    Document next = unworked(document());
    next.model = std::move(model);
    is_playing = false;
    phase_ = 1.0;
    history_.drag(std::move(next), label);
    solve_again(SolveMode::Interactive);
}

void Session::settle()
{
    history_.settle();
    if (solution_.task && !solution_.task->kani) solve_again();
}

void Session::change_later(femoop::Model model, const Message& label)
{
    waiting_ = {std::move(model), label, seconds_of_a_double_click};
}

void Session::change_at_once()
{
    if (auto waiting = std::exchange(waiting_, std::nullopt)) change(std::move(waiting->model), waiting->label);
}

void Session::follow(const Document& /*before*/)
{
    phase_ = 1.0;
    solve_again();
}

void Session::restart_with(Document document)
{
    seen_ = {ShownTurn{{}, document.pupil ? document.pupil->helped : std::vector<bool>{}}};
    present_ = 0;
    cell_.reset();
    worksheet_stage_ = 0;
    begin(std::move(document));
    is_playing = false;
    phase_ = 1.0;
    hover.reset();
    look.zoom = {};
    solve_again();
}

void Session::new_document() { restart_with(starting_document()); }

std::optional<Notice> Session::read(const std::filesystem::path& path)
{
    try {
        restart_with(read_document_file(path));
        leave_unfit_exercise();
        return std::nullopt;
    } catch (const femoop::ModelError& error) {
        std::vector<Message> reasons;
        for (const femoop::Fault& fault : error.faults()) reasons.emplace_back(frame::sentence(fault, tr()));
        return ui::lasting(ui::not_opened(path, reasons));
    }
}

std::string Session::file_text() const
{
    Document whole = document();
    if (whole.pupil) whole.pupil->helped = seen_[present_].helped;
    return write_document(whole);
}

std::string Session::about(const ui::Catalogue& tr) const { return femoop::title_and_size_text(document().model, tr); }

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
    return model && femoop::write_model(femoop::structure_alone(*model)) !=
                        femoop::write_model(femoop::structure_alone(document().model));
}

void Session::adopt(const std::string& text)
{
    auto model = model_of(text);
    if (!model || refuse_in_exercise()) return;
    Document next = unworked(document());
    next.model = std::move(*model);
    if (next.method.load_case.index >= next.model.n_cases()) next.method.load_case = femoop::CaseId(0);
    if (const Solution solution = solve(next); !solution.faults.empty())
        return notify(translatable("Moment distribution cannot do what the frame has now; it stays as it was"));
    is_playing = false;
    phase_ = 1.0;
    history_.apply(std::move(next), translatable("Take over from the frame"));
    solve_again();
}

void Session::tick(double seconds)
{
    ui::tick(notice, seconds);
    if (waiting_ && (waiting_->seconds_left -= seconds) < 0.0) change_at_once();
    if (phase_ < 1.0) {
        phase_ = std::min(1.0, phase_ + seconds / seconds_of_a_turn);
        find_state();
    } else if (is_playing && step()) {
        is_playing = false;
    }
}

Scene Session::scene() const
{
    return {document(), solution_,       state_ ? &*state_ : nullptr, phase(), hover, look, worksheet(),
            cell_,      worksheet_stage_};
}

} // namespace cross
