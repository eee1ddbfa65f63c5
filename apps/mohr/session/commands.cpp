#include "apps/mohr/session/commands.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "ui/scenario/words.h"
#include "ui/text/number_format.h"
#include "ui/workspace/file_commands.h"

namespace mohr {

namespace fm = femoop::mohr;
using fm::Criterion;
using ui::Key;
using ui::Message;
using ui::Reason;
using ui::translatable;
using Menu = ui::MenuBuilder<Workspace>;

namespace {

constexpr std::string_view state_menu = translatable("State");
constexpr std::string_view plane_menu = translatable("Plane");
constexpr std::string_view exercise_menu = translatable("Exercises");
constexpr std::string_view show_menu = translatable("Show");

constexpr std::array subject_entries{
    SubjectEntry{Subject::PlaneStress, "state.plane_stress", translatable("Plane stress"), {{Key::Digit1, {}}}},
    SubjectEntry{
        Subject::PlaneStrain, "state.plane_strain", translatable("Plane strain: σz = ν(σx + σy)"), {{Key::Digit2, {}}}},
    SubjectEntry{Subject::Strain, "state.strain", translatable("Strain"), {{Key::Digit3, {}}}},
    SubjectEntry{Subject::Rosette, "state.rosette", translatable("Strain rosette"), {{Key::Digit4, {}}}},
    SubjectEntry{Subject::Inertia, "state.inertia", translatable("Second moments of area"), {{Key::Digit5, {}}}},
    SubjectEntry{Subject::SpaceStress, "state.space_stress", translatable("Stress in space"), {{Key::Digit6, {}}}},
    SubjectEntry{Subject::Section, "state.section", translatable("Fibre of a section"), {{Key::Digit7, {}}}},
};

constexpr std::array criterion_entries{
    CriterionEntry{std::nullopt, "criterion.none", translatable("No criterion")},
    CriterionEntry{Criterion::Tresca, "criterion.tresca", "Tresca"},
    CriterionEntry{Criterion::VonMises, "criterion.von_mises", "von Mises"},
    CriterionEntry{Criterion::Rankine, "criterion.rankine", "Rankine"},
    CriterionEntry{Criterion::MohrCoulomb, "criterion.mohr_coulomb", "Mohr–Coulomb"},
    CriterionEntry{Criterion::DruckerPrager, "criterion.drucker_prager", "Drucker–Prager"},
    CriterionEntry{Criterion::HoekBrown, "criterion.hoek_brown", "Hoek–Brown"},
};

Reason why_not_another_state(const Workspace& workspace)
{
    if (!workspace.session.practice()) return std::nullopt;
    return workspace.session.why_state_stays();
}

Reason why_no_gauges(const Workspace& workspace)
{
    if (workspace.session.document().subject == Subject::Rosette) return why_not_another_state(workspace);
    return translatable("only a rosette has gauges");
}

void add_state_commands(CommandTable& table)
{
    Menu menu(table, state_menu);
    menu.choices(
        subject_entries, [](const Workspace& workspace) { return workspace.session.document().subject; },
        [](Workspace& workspace, Subject subject) { workspace.session.set_subject(subject); }, why_not_another_state);
    menu.step(
        {"state.rosette_45", translatable("Gauges at 0°, 45° and 90°")},
        [](Workspace& workspace) { workspace.session.set_gauges(fm::rosette_45_degrees); }, why_no_gauges);
    menu.step(
        {"state.rosette_60", translatable("Gauges at 0°, 60° and 120°")},
        [](Workspace& workspace) { workspace.session.set_gauges(fm::rosette_60_degrees); }, why_no_gauges);
}

Reason why_no_angle(const Workspace& workspace)
{
    if (workspace.session.is_concealing()) return translatable("an exercise keeps its plane until it is done");
    if (is_in_space(workspace.session.document().subject))
        return translatable("in space the plane is turned by its normal, on the sphere");
    return std::nullopt;
}

/// Turns to an angle that the state has, or says that it has none.
void turn_to(Session& session, std::optional<double> angle)
{
    if (angle) session.set_angle(*angle * 180.0 / std::numbers::pi);
    else session.notify(Message(translatable("every direction is principal")));
}

void turn_by(Session& session, double degrees) { session.set_angle(session.document().angle + degrees); }

void play(Workspace& workspace, bool is_on)
{
    workspace.session.is_playing = is_on;
    if (!is_on) workspace.session.settle();
}

void add_plane_commands(CommandTable& table)
{
    Menu menu(table, plane_menu);
    menu.step(
        {"plane.x", translatable("To the face x"), {{Key::X, {}}}},
        [](Workspace& workspace) { workspace.session.set_angle(0.0); }, why_no_angle);
    menu.step(
        {"plane.first", translatable("To the first principal direction"), {{Key::A, {}}}},
        [](Workspace& workspace) { turn_to(workspace.session, workspace.session.solution().principal.angle); },
        why_no_angle);
    menu.step(
        {"plane.shear", translatable("To the largest shear"), {{Key::M, {}}}},
        [](Workspace& workspace) { turn_to(workspace.session, workspace.session.solution().shear_angle); },
        why_no_angle);
    menu.step(
        {"plane.forward", translatable("Turn by 1° counter-clockwise"), {{Key::Right, {}}}},
        [](Workspace& workspace) { turn_by(workspace.session, 1.0); }, why_no_angle);
    menu.step(
        {"plane.back", translatable("Turn by 1° clockwise"), {{Key::Left, {}}}},
        [](Workspace& workspace) { turn_by(workspace.session, -1.0); }, why_no_angle);
    menu.toggle(
        {"plane.play", translatable("Let it turn"), {{Key::Space, {}}}},
        [](const Workspace& workspace) { return workspace.session.is_playing; }, play, why_no_angle);
}

void step_forward(Workspace& workspace)
{
    const auto step = workspace.session.step();
    workspace.session.show_construction(step ? *step + 1 : 1);
}

void step_back(Workspace& workspace)
{
    const auto step = workspace.session.step();
    workspace.session.show_construction(step ? std::max<std::size_t>(*step, 2) - 1 : 1);
}

void add_construction_commands(CommandTable& table)
{
    Menu menu(table, translatable("Construction"));
    menu.step({"construction.first", translatable("From the beginning"), {{Key::Home, {}}}},
              [](Workspace& workspace) { workspace.session.show_construction(1); });
    menu.step({"construction.next", translatable("Next step"), {{Key::PageDown, {}}}}, step_forward);
    menu.step({"construction.back", translatable("Step back"), {{Key::PageUp, {}}}}, step_back);
    menu.step({"construction.last", translatable("To the end"), {{Key::End, {}}}},
              [](Workspace& workspace) { workspace.session.show_construction(workspace.session.n_steps()); });
    menu.step({"construction.whole", translatable("The whole circle again"), {{Key::W, {}}}},
              [](Workspace& workspace) { workspace.session.show_construction(std::nullopt); });
}

Reason why_not_record(const Workspace& workspace)
{
    if (has_path(workspace.session.document().subject)) return std::nullopt;
    return translatable("a loading path has plane stresses or strains");
}

Reason why_no_path(const Workspace& workspace)
{
    if (workspace.session.solution().path.size() > 1) return std::nullopt;
    return translatable("a loading path needs two states; add them with R");
}

Reason why_not_clear(const Workspace& workspace)
{
    if (Reason reason = why_not_record(workspace)) return reason;
    if (!workspace.session.document().path().empty()) return std::nullopt;
    return translatable("there is no loading path; add states with R");
}

void add_path_commands(CommandTable& table)
{
    Menu menu(table, translatable("Loading path"));
    menu.step(
        {"path.record", translatable("Add this state"), {{Key::R, {}}}},
        [](Workspace& workspace) { workspace.session.record_path_state(); }, why_not_record);
    menu.step(
        {"path.play", translatable("Go along it"), {{Key::L, {}}}},
        [](Workspace& workspace) { workspace.session.play_path(); }, why_no_path);
    menu.step(
        {"path.clear", translatable("Clear it")}, [](Workspace& workspace) { workspace.session.clear_path(); },
        why_not_clear);
}

constexpr std::array exercise_topic_entries{
    ExerciseTopicEntry{ExerciseTopic::PlaneStress, "exercise.plane_stress", translatable("About plane stress")},
    ExerciseTopicEntry{ExerciseTopic::PlaneStrain, "exercise.plane_strain", translatable("About plane strain")},
    ExerciseTopicEntry{ExerciseTopic::Strain, "exercise.strain", translatable("About strains and Hooke's law")},
    ExerciseTopicEntry{ExerciseTopic::Rosette, "exercise.rosette", translatable("About strain rosettes")},
    ExerciseTopicEntry{ExerciseTopic::Inertia, "exercise.inertia", translatable("About second moments of area")},
    ExerciseTopicEntry{ExerciseTopic::Space, "exercise.space", translatable("About stress in space")},
    ExerciseTopicEntry{ExerciseTopic::Criteria, "exercise.criteria", translatable("About criteria of failure")},
};

void choose_topic(Workspace& workspace, ExerciseTopic topic)
{
    workspace.exercise_topic = topic;
    workspace.topic = Topic::Exercises;
}

void begin_exercise(Workspace& workspace, Difficulty difficulty)
{
    workspace.session.begin_exercise(workspace.exercise_topic, difficulty, workspace.next_exercise++);
    workspace.topic = Topic::Exercises;
    workspace.has_panels = true;
    workspace.is_asking_next = true;
}

/// Once one that is being done is left.
ui::MenuBuilder<Workspace>::Run begin(Difficulty difficulty)
{
    return [difficulty](Workspace& workspace) {
        workspace.leave_exercise([difficulty](Workspace& left) { begin_exercise(left, difficulty); });
    };
}

Reason why_not_give_up(const Workspace& workspace)
{
    if (workspace.session.is_concealing()) return std::nullopt;
    return translatable("there is no exercise to be done");
}

Reason why_not_end(const Workspace& workspace)
{
    if (workspace.session.practice()) return std::nullopt;
    return translatable("there is no exercise to be done");
}

void add_exercise_commands(CommandTable& table)
{
    Menu menu(table, exercise_menu);
    menu.choices(
        exercise_topic_entries, [](const Workspace& workspace) { return workspace.exercise_topic; }, choose_topic);
    menu.step({"exercise.easy", translatable("An easy exercise")}, begin(Difficulty::Easy));
    menu.step({"exercise.medium", translatable("A usual exercise")}, begin(Difficulty::Medium));
    menu.step({"exercise.hard", translatable("A hard exercise")}, begin(Difficulty::Hard));
    menu.step(
        {"exercise.give_up", translatable("Show the answers")},
        [](Workspace& workspace) { workspace.session.give_up_exercise(); }, why_not_give_up);
    menu.step(
        {"exercise.end", translatable("End the exercise")},
        [](Workspace& workspace) { workspace.leave_exercise([](Workspace& left) { left.session.end_exercise(); }); },
        why_not_end);
}

constexpr std::array topic_entries{
    TopicEntry{Topic::State, "panel.state", translatable("State")},
    TopicEntry{Topic::Construction, "panel.construction", translatable("Construction")},
    TopicEntry{Topic::Exercises, "panel.exercises", translatable("Exercises")},
};

Reason why_no_criterion(const Workspace& workspace)
{
    if (workspace.session.document().subject != Subject::Inertia) return std::nullopt;
    return translatable("second moments of area do not fail");
}

void add_criterion_commands(CommandTable& table)
{
    Menu(table, translatable("Criterion"))
        .choices(
            criterion_entries, [](const Workspace& workspace) { return workspace.session.document().criterion; },
            [](Workspace& workspace, std::optional<Criterion> criterion) {
                workspace.session.set_criterion(criterion);
            },
            why_no_criterion);
}

using LookEntry = ui::Choice<bool Look::*>;
constexpr std::array looks{
    LookEntry{&Look::pole, "view.show.pole", translatable("Pole and its lines"), {{Key::O, ui::shift}}},
    LookEntry{&Look::special,
              "view.show.special",
              translatable("Principal and largest-shear elements"),
              {{Key::E, ui::shift}}},
    LookEntry{&Look::space, "view.show.space", translatable("Circles of the third direction"), {{Key::T, ui::shift}}},
    LookEntry{&Look::envelope, "view.show.envelope", translatable("What the criterion allows"), {{Key::C, ui::shift}}},
    LookEntry{&Look::both_rules,
              "view.show.both_rules",
              translatable("Both rules of the shear's sign side by side"),
              {{Key::B, ui::shift}}},
};

constexpr std::array rules{
    ui::Choice<fm::ShearRule>{fm::ShearRule::ClockwiseUp, "view.rule.clockwise_up",
                              translatable("Shear up where it turns the element clockwise")},
    ui::Choice<fm::ShearRule>{fm::ShearRule::TensorDown, "view.rule.axis_down",
                              translatable("Shear axis down, signs of the axes x′y′")},
};

void add_show_commands(CommandTable& table)
{
    ui::standard::add_look_switches(table, show_menu, looks);
    Menu(table, show_menu)
        .choices(
            rules, [](const Workspace& workspace) { return workspace.session.look.rule; },
            [](Workspace& workspace, fm::ShearRule rule) { workspace.session.set_rule(rule); });
}

void add_view_commands(CommandTable& table)
{
    ui::standard::add_panels(table);
    ui::standard::add_topics(table, topic_entries);
    ui::standard::add_projector(table);
    ui::standard::add_offer(table);
    ui::standard::add_themes(table);
    ui::standard::add_export_scales(table);
    ui::standard::add_languages(table);
}

// ---- what a scenario gives ----

/// "1 12 MPa": the first number of the state.
Reason set_number(Workspace& workspace, const ui::Argument& argument)
{
    const auto words = argument.words();
    const auto place = words.empty() ? std::nullopt : ui::number_typed(words.front());
    const std::size_t most = workspace.session.document().state().size();
    if (!place || *place < 1.0 || *place > static_cast<double>(most) || words.size() < 2)
        return argument.wanted("a place from 1 to " + std::to_string(most) + " and a number");
    return workspace.session.set_number({Group::State, static_cast<std::size_t>(*place) - 1}, ui::joined(words, 1));
}

Reason set_section(Workspace& workspace, const ui::Argument& argument)
{
    return workspace.session.set_number({Group::Section, 0}, std::string(argument.text));
}

Reason set_direction(Workspace& workspace, const ui::Argument& argument)
{
    const auto n = argument.numbers(4);
    if (!n || !(n->at(0) == 1.0 || n->at(0) == 2.0 || n->at(0) == 3.0))
        return argument.wanted("1, 2 or 3 and three numbers");
    return workspace.session.set_direction(static_cast<int>(n->at(0)) - 1, {n->at(1), n->at(2), n->at(3)});
}

Reason set_principal(Workspace& workspace, const ui::Argument& argument)
{
    const auto n = argument.numbers(3);
    if (!n) return argument.wanted("two values and an angle");
    if (is_in_space(workspace.session.document().subject))
        return workspace.session.set_principal({n->at(0), n->at(1), n->at(2)});
    return workspace.session.set_principal(n->at(0), n->at(1), n->at(2));
}

Reason go_to_step(Workspace& workspace, const ui::Argument& argument)
{
    const auto n = argument.number();
    if (!n || *n < 1.0) return argument.wanted("a step from 1 to " + std::to_string(workspace.session.n_steps()));
    workspace.session.show_construction(static_cast<std::size_t>(*n));
    return std::nullopt;
}

Reason answer(Workspace& workspace, const ui::Argument& argument)
{
    const auto words = argument.words();
    const auto place = words.size() == 2 ? ui::number_typed(words.front()) : std::nullopt;
    if (!place || *place < 1.0) return argument.wanted("the question's number and an answer");
    return workspace.session.answer(static_cast<std::size_t>(*place) - 1, words.back());
}

Reason turn(Workspace& workspace, const ui::Argument& argument)
{
    const auto angle = argument.number();
    return angle ? workspace.session.set_angle(*angle) : argument.wanted("an angle in degrees");
}

Reason set_normal(Workspace& workspace, const ui::Argument& argument)
{
    const auto n = argument.numbers(3);
    return n ? workspace.session.set_normal({n->at(0), n->at(1), n->at(2)}) : argument.wanted("three numbers");
}

void add_arguments(CommandTable& table)
{
    table.with_argument("state.set", set_number);
    table.with_argument("state.section", set_section);
    table.with_argument("state.direction", set_direction);
    table.with_argument("state.principal", set_principal);
    table.with_argument("construction.step", go_to_step);
    table.with_argument("exercise.answer", answer);
    table.with_argument("plane.turn", turn);
    table.with_argument("plane.normal", set_normal);
}

} // namespace

void Workspace::leave_exercise(std::function<void(Workspace&)> then)
{
    if (session.is_concealing()) after_exercise = std::move(then);
    else then(*this);
}

void Workspace::leave_document(std::function<void(Workspace&)> then)
{
    leave_exercise(
        [then = std::move(then)](Workspace& workspace) { workspace.DocumentWorkspace::leave_document(then); });
}

std::span<const TopicEntry> topics() { return topic_entries; }
std::span<const SubjectEntry> subjects() { return subject_entries; }
std::span<const ExerciseTopicEntry> exercise_topics() { return exercise_topic_entries; }
std::span<const CriterionEntry> criteria() { return criterion_entries; }

CommandTable command_table()
{
    CommandTable table;
    ui::standard::add_file_commands(
        table, {.exported = translatable("Export picture or results…"), .described = translatable("State in words")});
    ui::standard::add_undo_and_redo(table);
    add_state_commands(table);
    add_plane_commands(table);
    add_construction_commands(table);
    add_criterion_commands(table);
    add_path_commands(table);
    add_exercise_commands(table);
    add_show_commands(table);
    add_view_commands(table);
    ui::standard::add_help(table);
    add_arguments(table);
    return table;
}

} // namespace mohr
