#include "apps/euler/session/session.h"

#include <algorithm>
#include <functional>
#include <system_error>
#include <utility>

#include "apps/euler/document/drawing/drawn_line.h"
#include "apps/euler/session/argument_pick.h"
#include "apps/euler/session/script_text.h"
#include "apps/euler/view/solid/clear_view.h"
#include "femoop/files/whole_file.h"
#include "ui/text/catalogue.h"

namespace euler {

using ui::translatable;

namespace {

constexpr double seconds_per_step = 0.9, seconds_between_steps = 0.6;

// Slow at both ends, as a hand moves.
double eased(double t) { return t * t * (3.0 - 2.0 * t); }

} // namespace

bool lives(const topology::Solid& solid, topology::Entity e)
{
    switch (e.kind) {
    case topology::EntityKind::Vertex: return solid.has(topology::VertexId{e.index});
    case topology::EntityKind::HalfEdge: return solid.has(topology::HalfEdgeId{e.index});
    case topology::EntityKind::Edge: return solid.has(topology::EdgeId{e.index});
    case topology::EntityKind::Loop: return solid.has(topology::LoopId{e.index});
    case topology::EntityKind::Face: return solid.has(topology::FaceId{e.index});
    }
    return false;
}

Session::Session() : OpenDocument({}) { restart(Stepper()); }

void Session::restart(Stepper lesson)
{
    earned_ = points();
    game_.reset();
    stepper_ = std::move(lesson);
    whole_ = stepper_.whole();
    OpenDocument::begin(whole_);
    ++n_changes_;
    is_playing = false;
    selection.reset();
    hover.reset();
    notice.reset();
    edited_text.reset();
    given_up_.reset();
    faulty_line.reset();
    is_fitted = true;
    look_at_end();
    look_at_place();
    look_again();
}

// From a side above. Lines go on being drawn from the top.
void Session::look_again()
{
    constexpr double azimuth = -1.1, elevation = 0.42;
    if (is_drawing_) return;
    eye.look(azimuth, elevation);
    look_clearly();
}

void Session::look_from_corner()
{
    eye.look(ui::StandardView::Isometric);
    look_clearly();
    show_as(ViewKind::Space);
}

// At what is seen now and at what it comes to.
void Session::look_clearly()
{
    std::vector<Subject> subjects = this->subjects();
    for (const Snapshot& snapshot : at_end_) subjects.push_back({snapshot.solid.get(), snapshot.names.get(), {}});
    eye = clear_view(eye, subjects);
}

void Session::new_document() { restart(Stepper()); }

void Session::show(Stepper lesson)
{
    restart(std::move(lesson));
    go_to(std::min<std::size_t>(1, n_steps()));
}

std::optional<Notice> Session::read(const std::filesystem::path& path)
{
    const files::WholeFile file = files::read_whole_file(path);
    if (file.hindrance) return ui::lasting(ui::not_opened(path, file.hindrance));
    auto [lesson, fault] = Stepper::as_far_as_it_goes(file.text);
    if (fault && lesson.n_steps() == 0 && !can_be_edited(file.text))
        return ui::lasting(ui::not_opened(path, sentence(*fault, tr())));
    restart(std::move(lesson));
    if (fault) show_fault(path, file.text, *fault);
    return std::nullopt;
}

ui::UnsavedDocument Session::unsaved() const
{
    return {.state = is_text_changed() ? std::hash<std::string>()(*edited_text) : n_changes_,
            .original = path(),
            .copy = [this]() -> ui::WriteDocument {
                if (is_text_changed())
                    return [text = *edited_text](const std::filesystem::path& draft) {
                        return files::write_whole_file(draft, text);
                    };
                return [script = whole_](const std::filesystem::path& draft) {
                    return files::write_whole_file(draft, script.text());
                };
            },
            .about = [this](const ui::Catalogue& tr) { return about(tr); }};
}

std::string Session::about(const ui::Catalogue& tr) const
{
    return tr("steps: {count}", {{"count", std::to_string(n_steps())}});
}

// Takes the last step back and does it again, to see what was before it.
void Session::look_at_place()
{
    cancel_operator();
    motion_.reset();
    script_fault.reset();
    ++generation_;
    const std::size_t here = place();
    before_.clear();
    report_.reset();
    after_ = snapshots(stepper_, at_end_);
    if (here > 0) {
        report_ = stepper_.report(here);
        stepper_.go_to(here - 1);
        before_ = retaken(stepper_, report_->solid, after_);
        stepper_.go_to(here);
    }
    const auto is_there = [this](const Part& part) {
        return part.subject < after_.size() && lives(*after_[part.subject].solid, part.entity);
    };
    if (selection && !is_there(*selection)) selection.reset(); // a row that was taken back has gone
    if (is_exhibiting()) exhibit();
}

void Session::look_at_end()
{
    const std::size_t here = place();
    stepper_.go_to(n_steps());
    at_end_ = snapshots(stepper_);
    stepper_.go_to(here);
}

// What it told of one place may be wrong of another.
void Session::forget_passing_notice()
{
    if (notice && notice->seconds_left) notice.reset();
}

void Session::go_to(std::size_t place)
{
    forget_passing_notice();
    stepper_.go_to(place);
    look_at_place();
}

void Session::step_forward()
{
    go_to(place() + 1);
    move(false);
}

void Session::step_back()
{
    if (motion_) look_at_place();
    if (has_just_opened_sweep()) return close_sweep();
    forget_passing_notice();
    cancel_operator();
    stepper_.go_to(place() - 1);
    ++generation_;
    move(true);
    if (!motion_) look_at_place();
}

void Session::move(bool is_back)
{
    if (!is_still) motion_ = Motion{.is_back = is_back};
}

bool Session::tick(double seconds)
{
    ui::tick(notice, seconds);
    if (motion_) {
        motion_->done += seconds * speed / seconds_per_step;
        if (motion_->done >= 1.0) look_at_place();
        rest_ = 0.0;
        return true;
    }
    if (!is_playing) return false;
    if (place() == n_steps()) is_playing = false;
    else if ((rest_ += seconds * speed) >= seconds_between_steps) {
        rest_ = 0.0;
        step_forward();
    }
    return true;
}

void Session::draw_or_look()
{
    cancel_operator();
    is_drawing_ = !is_drawing_;
    if (!is_drawing_) return;
    eye.look(ui::StandardView::Top);
    view_ = ViewKind::Space;
    is_fitted = true;
}

std::optional<ui::Message> Session::draw(const topology::Point& from, const topology::Point& to)
{
    if (motion_) look_at_place();
    const bool has_figure = place() > 0 && stepper_.runner().solids()[report()->solid].is_alive();
    const auto figure = has_figure ? std::optional(report()->solid) : std::nullopt;
    const auto drawn = drawn_line(stepper_, figure, from, to);
    if (const auto* const reason = std::get_if<ui::Message>(&drawn)) return *reason;
    std::string told;
    for (const DrawnStep& step : std::get<std::vector<DrawnStep>>(drawn)) {
        if (auto reason = apply(step.line)) return reason;
        told += (told.empty() ? "" : "\n") + report()->name + ": " + tr()(step.why);
    }
    notify(ui::Message(told));
    return std::nullopt;
}

void Session::show_as(ViewKind kind)
{
    is_drawing_ = false;
    view_ = kind;
    is_fitted = true;
}

const std::vector<Snapshot>& Session::shown() const
{
    if (!preview_.empty()) return preview_;
    const StepReport* const step = report();
    const bool shows_before = motion_ && step != nullptr && is_drawn_before(together(step->changes));
    return shows_before ? before_ : after_;
}

double Session::progress() const
{
    const double done = eased(motion_->done);
    return motion_->is_back ? 1.0 - done : done;
}

std::optional<Session::Transition> Session::transition() const
{
    if (!motion_ || report() == nullptr || !preview_.empty()) return std::nullopt;
    if (&shown() == &before_) return Transition{after_, 1.0 - progress()};
    return Transition{before_, progress()};
}

std::vector<Subject> Session::subjects() const
{
    std::vector<Subject> subjects;
    for (const Snapshot& snapshot : shown()) subjects.push_back({snapshot.solid.get(), snapshot.names.get(), {}});
    const StepReport* const step = report();
    if (step != nullptr && step->solid < subjects.size() && preview_.empty()) {
        subjects[step->solid].marks = marks_of(together(step->changes), motion_ ? progress() : 1.0);
    }
    const auto mark = [&](const std::optional<Part>& part) -> Marks* {
        return part && part->subject < subjects.size() ? &subjects[part->subject].marks : nullptr;
    };
    if (Marks* const marks = mark(selection)) marks->selected.push_back(selection->entity);
    if (Marks* const marks = mark(hover)) marks->hovered = hover->entity;
    if (pending_operator_ && !pending_operator_->is_complete()) {
        if (const auto solid = pending_operator_->solid(stepper_.runner())) subjects[*solid].marks.legal = legal_;
    }
    if (!preview_.empty()) subjects[preview_solid_].marks.preview = preview_made_;
    return subjects;
}

void Session::begin(Verb verb)
{
    if (motion_) look_at_place();
    is_playing = false;
    cancel_operator();
    pending_operator_.emplace(verb);
    fill_in_suggestions();
}

// The solid is chosen for the user where there is but one.
void Session::fill_in_suggestions()
{
    const topology::ScriptRunner& runner = stepper_.runner();
    while (pending_operator_ && !pending_operator_->is_complete() &&
           pending_operator_->next().kind == ArgumentKind::Solid) {
        const std::optional<Choice> only = pending_operator_->suggestion(runner);
        if (!only || pending_operator_->choose(runner, *only)) break;
    }
    legal_ = pending_operator_->legal_picks(runner);
    preview_pending_operator();
}

void Session::preview_pending_operator()
{
    preview_.clear();
    preview_made_.clear();
    if (!pending_operator_ || !pending_operator_->is_complete()) return;
    const std::optional<Stepper> would_be = preview(stepper_, *pending_operator_);
    if (!would_be) return;
    const StepReport step = would_be->report(would_be->place());
    preview_ = snapshots(*would_be);
    preview_solid_ = step.solid;
    const topology::Change change = together(step.changes);
    preview_made_ = change.created;
}

std::optional<ui::Message> Session::choose(const Choice& choice)
{
    if (!pending_operator_ || pending_operator_->is_complete()) return translatable("nothing is asked for");
    if (auto reason = pending_operator_->choose(stepper_.runner(), choice)) return reason;
    forget_passing_notice(); // of what was refused before
    fill_in_suggestions();
    return std::nullopt;
}

std::optional<ui::Message> Session::choose_typed(std::string_view text)
{
    if (!pending_operator_ || pending_operator_->is_complete()) return translatable("nothing is asked for");
    const auto understood = typed(stepper_.runner(), *pending_operator_, text);
    if (const auto* const reason = std::get_if<ui::Message>(&understood)) return *reason;
    return choose(std::get<Choice>(understood));
}

std::optional<ui::Message> Session::why_not_pick(const Part& part) const
{
    if (!pending_operator_ || pending_operator_->is_complete()) return std::nullopt;
    const auto solid = pending_operator_->solid(stepper_.runner());
    if (!solid || !is_pointed_at(pending_operator_->next().kind)) return std::nullopt;
    if (*solid != part.subject) return ui::Message(translatable("this belongs to another solid"));
    const topology::Entity wanted = as_argument(*after_[part.subject].solid, pending_operator_->next().kind,
                                                part.entity, legal_);
    return pending_operator_->why_not(stepper_.runner(), wanted);
}

void Session::pick(const Part& part)
{
    if (!pending_operator_ || pending_operator_->is_complete()) {
        selection = part;
        return;
    }
    if (pending_operator_->next().kind == ArgumentKind::Solid) {
        choose(after_[part.subject].name);
        return;
    }
    if (!is_pointed_at(pending_operator_->next().kind)) {
        selection = part;
        return;
    }
    if (auto reason = why_not_pick(part)) {
        notify(*reason);
        return;
    }
    choose(as_argument(*after_[part.subject].solid, pending_operator_->next().kind, part.entity, legal_));
}

void Session::undo_choice()
{
    if (!pending_operator_) return;
    const bool only_the_solid = pending_operator_->chosen().size() == 1 &&
                                pending_operator_->form().arguments()[0].kind == ArgumentKind::Solid;
    if (pending_operator_->chosen().empty() || only_the_solid) return cancel_operator();
    pending_operator_->drop_last();
    legal_ = pending_operator_->legal_picks(stepper_.runner());
    preview_pending_operator();
}

void Session::cancel_operator()
{
    pending_operator_.reset();
    legal_.clear();
    preview_.clear();
    preview_made_.clear();
}

bool Session::accept()
{
    if (!pending_operator_ || !pending_operator_->is_complete()) return false;
    const auto reason = apply(pending_operator_->line(stepper_.runner()));
    if (reason) notify(*reason);
    return !reason;
}

std::optional<ui::Message> Session::apply(std::string_view line)
{
    if (motion_) look_at_place();
    is_playing = false;
    const std::size_t here = place();
    if (auto reason = stepper_.apply(line)) return reason;
    note_change();
    if (place() == here + 1) move(false);
    if (report_ && !report_->warning.sentence.empty()) notify(report_->warning);
    return std::nullopt;
}

void Session::open_sweep()
{
    is_playing = false;
    motion_.reset();
    Stepper closed = stepper_;
    stepper_.open_sweep();
    note_change();
    opening_ = Opening{std::move(closed), n_changes_, place()};
}

bool Session::has_just_opened_sweep() const
{
    return opening_ && opening_->n_changes == n_changes_ && opening_->place == place();
}

void Session::close_sweep()
{
    cancel_operator();
    stepper_ = std::move(opening_->closed);
    opening_.reset();
    note_change();
}

// The script is another one.
void Session::note_change()
{
    forget_passing_notice();
    whole_ = stepper_.whole();
    is_dirty_ = differs_from_saved();
    ++n_changes_;
    look_at_end();
    look_at_place();
    if (game_) game_->judge(stepper_);
}

void Session::play(Game game)
{
    restart(Stepper());
    game_ = std::move(game);
    side_ = Side::Before;
    exhibit();
    look_again();
}

void Session::show_side(Side side)
{
    side_ = side;
    exhibit();
}

bool Session::is_exhibiting() const
{
    return game_ && place() == 0 && !std::holds_alternative<ReachChallenge>(game_->task());
}

// Solids that no script of the user's has made, so that its steps tell nothing of them.
void Session::exhibit()
{
    if (auto* const broken = std::get_if<CorruptedPointer>(&game_->task())) {
        after_ = at_end_ = {Snapshot{"s1", std::make_shared<const topology::Solid>(broken->sound),
                                     std::make_shared<const topology::Names>()}};
    } else if (auto* const which = std::get_if<WhichOperator>(&game_->task())) {
        Stepper lesson = which->lesson;
        lesson.go_to(which->after);
        std::vector<Snapshot> end = snapshots(lesson);
        lesson.go_to(which->before);
        after_ = at_end_ = snapshots(lesson);
        at_end_.insert(at_end_.end(), end.begin(), end.end()); // both fit into the picture
        if (side_ == Side::After) after_ = std::move(end);
    }
    selection.reset();
    ++generation_;
}

std::optional<ui::Message> Session::answer(std::string_view words)
{
    if (!game_) return translatable("no challenge is on");
    return game_->answer(words);
}

void Session::give_up_challenge()
{
    game_->give_up();
    const auto* const reach = std::get_if<ReachChallenge>(&game_->task());
    if (reach == nullptr) return;
    Game over = *game_;
    show(Stepper(reach->way));
    game_ = std::move(over);
}

} // namespace euler
