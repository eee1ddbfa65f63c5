#include "apps/mohr/session/session.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "apps/mohr/document/file.h"
#include "apps/mohr/session/report.h"
#include "femoop/files/whole_file.h"
#include "femoop/model/quantity/number_text.h"
#include "ui/text/number_format.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::Message;
using ui::translatable;

namespace {

constexpr double turning_speed = 30.0;  ///< degrees a second
constexpr double stretch_seconds = 1.5; ///< of a stretch of the loading path
constexpr std::uintmax_t most_bytes = 1'000'000;

} // namespace

Session::Session() : EditedDocument(textbook_state())
{
    eye.look(0.6, 0.45);
    solve_again();
}

void Session::solve_again() { solution_ = solve(document(), look.rule); }

bool Session::would_leave_exercise(const Document& next) const
{
    if (!practice_) return false;
    const Document given = document_of(practice_->exercise());
    return next.subject != given.subject || next.state() != given.state() || next.elasticity != given.elasticity;
}

std::string_view Session::why_state_stays() const
{
    if (is_concealing())
        return translatable(
            "an exercise has this state; type the answers into its fields, or end it: Exercises, End the exercise");
    return translatable(
        "the exercise that was answered has this state; take another one, or end it: Exercises, End the exercise");
}

std::optional<Message> Session::apply(Edit edit, const Message& label)
{
    path_time_.reset(); // what is done by hand ends what moves by itself
    if (would_leave_exercise(edit.document)) return Message(why_state_stays());
    if (edit.fault) return edit.fault->reason;
    history_.apply(std::move(edit.document), label);
    solve_again();
    return std::nullopt;
}

void Session::drag(Edit edit, const Message& label)
{
    if (edit.fault || would_leave_exercise(edit.document)) return;
    history_.drag(std::move(edit.document), label);
    solve_again();
}

void Session::settle()
{
    history_.settle();
    grip_.reset();
    solve_again();
}

void Session::grip(Handle handle, const Drawn& drawn)
{
    is_playing = false;
    path_time_.reset();
    history_.settle();
    grip_ = Grip{handle, document(), solution_, drawn, frame()};
}

void Session::drag_to(ui::Point at, bool is_fine) { drag(dragged(*grip_, at, is_fine), label_of(grip_->handle)); }

std::optional<Message> Session::why_not_here() const
{
    if (would_leave_exercise(document())) return Message(why_state_stays());
    return std::nullopt;
}

std::optional<Message> Session::set_number(NumberId number, std::string_view text)
{
    return apply(with_number(document(), number, text), translatable("Change a number"));
}

std::optional<Message> Session::set_angle(double degrees)
{
    if (is_concealing()) return Message(translatable("an exercise keeps its plane until it is done"));
    return apply(with_angle(document(), degrees), translatable("Turn the plane"));
}

std::optional<Message> Session::set_normal(const std::array<double, 3>& normal)
{
    if (is_concealing()) return Message(translatable("an exercise keeps its plane until it is done"));
    return apply(with_normal(document(), normal), translatable("Turn the plane"));
}

std::optional<Message> Session::set_principal(double first, double second, double degrees)
{
    if (is_in_space(document().subject))
        return Message(translatable("in space there are three principal values, and directions instead of an angle"));
    return apply(with_principal(document(), first, second, degrees), translatable("Change the principal values"));
}

std::optional<Message> Session::set_principal(const std::array<double, 3>& values)
{
    fm::SpacePrincipal principal = solution_.space_principal;
    principal.values = values;
    return apply(with_space_principal(document(), principal), translatable("Change the principal values"));
}

std::optional<Message> Session::set_direction(int direction, const std::array<double, 3>& along)
{
    const Eigen::Vector3d v(along[0], along[1], along[2]);
    if (!(v.stableNorm() > 0.0)) return Message(translatable("the direction is 0, 0, 0"));
    return apply(with_space_principal(document(), fm::with_direction(solution_.space_principal, direction, v)),
                 translatable("Turn the principal directions"));
}

void Session::set_gauges(const std::array<double, 3>& degrees)
{
    Document next = document();
    for (std::size_t i = 0; i < 3; ++i) next.state()[i] = femoop::number_text(degrees[i]);
    Edit edit{next, why_not(next)};
    if (const auto reason = apply(std::move(edit), translatable("Turn the gauges"))) notify(*reason);
}

void Session::set_subject(Subject subject)
{
    Document next = document();
    next.subject = subject;
    Edit edit{next, why_not(next)};
    if (const auto reason = apply(std::move(edit), translatable("Change the kind of state"))) notify(*reason);
}

void Session::set_criterion(std::optional<fm::Criterion> criterion)
{
    Document next = document();
    next.criterion = criterion;
    Edit edit{next, why_not(next)};
    if (const auto reason = apply(std::move(edit), translatable("Choose a criterion"))) notify(*reason);
}

void Session::set_rule(fm::ShearRule rule)
{
    look.rule = rule;
    solve_again();
}

void Session::begin_exercise(ExerciseTopic topic, Difficulty difficulty, std::uint32_t seed)
{
    practice_.reset();
    is_playing = false;
    const Exercise next = exercise(topic, difficulty, seed);
    apply({document_of(next)}, translatable("Begin an exercise"));
    practice_.emplace(next);
}

std::optional<Message> Session::answer(std::size_t place, std::string_view words)
{
    const auto number = ui::number_typed(words);
    if (!practice_ || place >= practice_->answers().size()) return Message(translatable("there is no such question"));
    if (!number) return Message(translatable("this is no number"));
    practice_->answer(place, *number);
    return std::nullopt;
}

void Session::give_up_exercise()
{
    if (practice_) practice_->give_up();
}

void Session::restart(Document document)
{
    begin(std::move(document));
    is_playing = false;
    path_time_.reset();
    practice_.reset();
    grip_.reset();
    solve_again();
}

void Session::new_document() { restart(textbook_state()); }

std::optional<Notice> Session::read(const std::filesystem::path& path)
{
    const files::WholeFile file = files::read_whole_file(path, most_bytes);
    if (file.hindrance) return ui::lasting(ui::not_opened(path, file.hindrance));
    auto read = read_file_text(file.text);
    if (const auto* faults = std::get_if<std::vector<Message>>(&read))
        return ui::lasting(ui::not_opened(path, *faults));
    restart(std::get<Document>(std::move(read)));
    return std::nullopt;
}

// Letters and numbers, which no language changes.
std::string Session::about(const ui::Catalogue&) const { return is_concealing() ? std::string() : status_text(*this); }

bool Session::is_news(const std::string& text) const
{
    const auto read = read_file_text(text);
    const auto* const other = std::get_if<Document>(&read);
    return other != nullptr && file_text_of_section(with_section_of(document(), *other)) != linked_text();
}

void Session::adopt(const std::string& text)
{
    const auto read = read_file_text(text);
    const auto* const other = std::get_if<Document>(&read);
    if (other == nullptr) return;
    Document next = with_section_of(document(), *other);
    auto fault = why_not(next);
    if (const auto reason = apply({std::move(next), std::move(fault)}, translatable("Take over from the frame")))
        notify(*reason);
}

void Session::tick(double seconds)
{
    ui::tick(notice, seconds);
    if (path_time_) follow_path(seconds);
    if (!is_playing) return;
    drag(with_angle(document(), document().angle + turning_speed * seconds), translatable("Turn the plane"));
}

std::size_t Session::n_steps() const { return construction_of(document(), solution_).size(); }

void Session::show_construction(std::optional<std::size_t> step)
{
    step_ = step;
    if (step_) step_ = std::clamp<std::size_t>(*step_, 1, n_steps());
}

void Session::record_path_state() { apply(with_path_state(document()), translatable("Add to the loading path")); }

void Session::clear_path() { apply(without_path(document()), translatable("Clear the loading path")); }

void Session::play_path()
{
    is_playing = false;
    settle();
    path_time_ = 0.0;
}

void Session::follow_path(double seconds)
{
    const auto n_stretches = static_cast<double>(std::max<std::size_t>(solution_.path.size(), 2) - 1);
    *path_time_ = std::min(1.0, *path_time_ + seconds / (stretch_seconds * n_stretches));
    const double largest = fitting_frame(document(), solution_).largest;
    fm::PlaneState state = fm::state_on(solution_.path, *path_time_);
    for (double* part : {&state.x, &state.y, &state.xy}) *part = rounded(*part, largest, 5);
    drag(with_plane(document(), state), translatable("Go along the loading path"));
    if (*path_time_ < 1.0) return;
    path_time_.reset();
    settle();
}

Frame Session::frame() const
{
    const bool is_construction = step_ || is_concealing();
    return fitting_frame(document(), solution_, is_construction ? Content::Circles : Content::All);
}

Scene Session::scene() const
{
    const Frame frame = grip_ ? grip_->frame : this->frame();
    if (is_concealing()) return {document(), solution_, look, frame, eye, practice_->steps_shown(), hover, true};
    return {document(), solution_, look, frame, eye, step_, hover};
}

} // namespace mohr
