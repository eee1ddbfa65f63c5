#include "apps/mohr/session/commands.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "ui/desk/file_commands.h"

namespace mohr {

namespace fm = femoop::mohr;
using fm::Criterion;
using ui::Key;
using ui::Phrase;
using ui::translatable;

namespace {

constexpr std::string_view state_menu = translatable("State");
constexpr std::string_view plane_menu = translatable("Plane");
constexpr std::string_view criterion_menu = translatable("Criterion");
constexpr std::string_view show_menu = translatable("Show");

constexpr std::array subject_entries{
    SubjectEntry{Subject::PlaneStress, "state.plane_stress", translatable("Plane stress")},
    SubjectEntry{Subject::PlaneStrain, "state.plane_strain", translatable("Plane strain: σz = ν(σx + σy)")},
    SubjectEntry{Subject::Strain, "state.strain", translatable("Strain")},
    SubjectEntry{Subject::Rosette, "state.rosette", translatable("Strain rosette")},
    SubjectEntry{Subject::Inertia, "state.inertia", translatable("Second moments of area")},
    SubjectEntry{Subject::SpaceStress, "state.space_stress", translatable("Stress in space")},
    SubjectEntry{Subject::Section, "state.section", translatable("Fibre of a section")},
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

std::optional<Phrase> why_not_another_state(const Desk& desk)
{
    if (!desk.session.practice()) return std::nullopt;
    return exercise_keeps_state;
}

void add_state_commands(CommandTable& table)
{
    for (std::size_t i = 0; i < subject_entries.size(); ++i) {
        const SubjectEntry& entry = subject_entries[i];
        const Key key = static_cast<Key>(static_cast<int>(Key::Digit1) + static_cast<int>(i));
        table.add({.id = entry.id,
                   .menu = state_menu,
                   .label = entry.label,
                   .shortcuts = {{key, {}}},
                   .run = [subject = entry.subject](Desk& desk) { desk.session.set_subject(subject); },
                   .why_not = why_not_another_state,
                   .is_on = [subject = entry.subject](
                                const Desk& desk) { return desk.session.document().subject == subject; }});
    }
}

/// The usual rosettes.
void add_rosette_commands(CommandTable& table)
{
    struct Entry {
        std::string_view id, label;
        std::array<double, 3> gauges;
    };
    constexpr std::array entries{
        Entry{"state.rosette_45", translatable("Gauges at 0°, 45° and 90°"), fm::rosette_45_degrees},
        Entry{"state.rosette_60", translatable("Gauges at 0°, 60° and 120°"), fm::rosette_60_degrees},
    };
    for (const Entry& entry : entries)
        table.add({.id = entry.id,
                   .menu = state_menu,
                   .label = entry.label,
                   .run = [gauges = entry.gauges](Desk& desk) { desk.session.set_gauges(gauges); },
                   .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                       if (desk.session.document().subject == Subject::Rosette) return why_not_another_state(desk);
                       return translatable("only a rosette has gauges");
                   }});
}

std::optional<Phrase> why_no_angle(const Desk& desk)
{
    if (desk.session.is_concealing()) return translatable("an exercise keeps its plane until it is done");
    if (is_in_space(desk.session.document().subject))
        return translatable("in space the plane is turned by its normal, on the sphere");
    return std::nullopt;
}

/// Turns to an angle that the state has, or says that it has none.
void turn_to(Session& session, std::optional<double> angle)
{
    if (angle) session.set_angle(*angle * 180.0 / std::numbers::pi);
    else session.tell(Phrase(translatable("every direction is principal")));
}

void add_plane_commands(CommandTable& table)
{
    struct Entry {
        std::string_view id, label;
        Key key;
        void (*run)(Session&);
    };
    constexpr std::array entries{
        Entry{"plane.x", translatable("To the face x"), Key::X, [](Session& s) { s.set_angle(0.0); }},
        Entry{"plane.first", translatable("To the first principal direction"), Key::A,
              [](Session& s) { turn_to(s, s.solution().principal.angle); }},
        Entry{"plane.shear", translatable("To the largest shear"), Key::M,
              [](Session& s) { turn_to(s, s.solution().shear_angle); }},
        Entry{"plane.forward", translatable("Turn by 1° counter-clockwise"), Key::Right,
              [](Session& s) { s.set_angle(s.document().angle + 1.0); }},
        Entry{"plane.back", translatable("Turn by 1° clockwise"), Key::Left,
              [](Session& s) { s.set_angle(s.document().angle - 1.0); }},
    };
    for (const Entry& entry : entries)
        table.add({.id = entry.id,
                   .menu = plane_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, {}}},
                   .run = [run = entry.run](Desk& desk) { run(desk.session); },
                   .why_not = why_no_angle});
    table.add({.id = "plane.play",
               .menu = plane_menu,
               .label = translatable("Let it turn"),
               .shortcuts = {{Key::Space, {}}},
               .run =
                   [](Desk& desk) {
                       desk.session.is_playing = !desk.session.is_playing;
                       if (!desk.session.is_playing) desk.session.settle();
                   },
               .why_not = why_no_angle,
               .is_on = [](const Desk& desk) { return desk.session.is_playing; }});
}

void add_construction_commands(CommandTable& table)
{
    struct Entry {
        std::string_view id, label;
        Key key;
        std::optional<std::size_t> (*next)(const Session&);
    };
    constexpr std::array entries{
        Entry{"construction.first", translatable("From the beginning"), Key::Home,
              [](const Session&) -> std::optional<std::size_t> { return 1; }},
        Entry{"construction.next", translatable("Next step"), Key::PageDown,
              [](const Session& s) -> std::optional<std::size_t> { return s.step() ? *s.step() + 1 : 1; }},
        Entry{"construction.back", translatable("Step back"), Key::PageUp,
              [](const Session& s) -> std::optional<std::size_t> {
                  return s.step() ? std::max<std::size_t>(*s.step(), 2) - 1 : 1;
              }},
        Entry{"construction.last", translatable("To the end"), Key::End,
              [](const Session& s) -> std::optional<std::size_t> { return s.n_steps(); }},
        Entry{"construction.whole", translatable("The whole circle again"), Key::W,
              [](const Session&) -> std::optional<std::size_t> { return std::nullopt; }},
    };
    for (const Entry& entry : entries)
        table.add({.id = entry.id,
                   .menu = translatable("Construction"),
                   .label = entry.label,
                   .shortcuts = {{entry.key, {}}},
                   .run = [next = entry.next](Desk& desk) { desk.session.show_construction(next(desk.session)); }});
}

void add_path_commands(CommandTable& table)
{
    constexpr std::string_view menu = translatable("Loading path");
    const auto why_not = [](const Desk& desk) -> std::optional<Phrase> {
        if (has_path(desk.session.document().subject)) return std::nullopt;
        return translatable("a loading path has plane stresses or strains");
    };
    const auto why_no_path = [](const Desk& desk) -> std::optional<Phrase> {
        if (desk.session.solution().path.size() > 1) return std::nullopt;
        return translatable("a loading path needs two states; add them with R");
    };
    table.add({.id = "path.record",
               .menu = menu,
               .label = translatable("Add this state"),
               .shortcuts = {{Key::R, {}}},
               .run = [](Desk& desk) { desk.session.record_path_state(); },
               .why_not = why_not});
    table.add({.id = "path.play",
               .menu = menu,
               .label = translatable("Go along it"),
               .shortcuts = {{Key::L, {}}},
               .run = [](Desk& desk) { desk.session.play_path(); },
               .why_not = why_no_path});
    table.add({.id = "path.clear",
               .menu = menu,
               .label = translatable("Clear it"),
               .run = [](Desk& desk) { desk.session.clear_path(); },
               .why_not = why_not});
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

void add_exercise_topic_commands(CommandTable& table)
{
    for (const ExerciseTopicEntry& entry : exercise_topic_entries)
        table.add({.id = entry.id,
                   .menu = translatable("Exercises"),
                   .label = entry.label,
                   .run =
                       [topic = entry.topic](Desk& desk) {
                           desk.exercise_topic = topic;
                           desk.topic = Topic::Exercises;
                       },
                   .is_on = [topic = entry.topic](const Desk& desk) { return desk.exercise_topic == topic; }});
}

void begin_exercise(Desk& desk, Difficulty difficulty)
{
    desk.session.begin_exercise(desk.exercise_topic, difficulty, desk.next_exercise++);
    desk.topic = Topic::Exercises;
    desk.has_panels = true;
    desk.is_asking_next = true;
}

void add_exercise_commands(CommandTable& table)
{
    struct Entry {
        std::string_view id, label;
        Difficulty difficulty;
    };
    constexpr std::array entries{
        Entry{"exercise.easy", translatable("An easy exercise"), Difficulty::Easy},
        Entry{"exercise.medium", translatable("A usual exercise"), Difficulty::Medium},
        Entry{"exercise.hard", translatable("A hard exercise"), Difficulty::Hard},
    };
    constexpr std::string_view menu = translatable("Exercises");
    for (const Entry& entry : entries)
        table.add(
            {.id = entry.id, .menu = menu, .label = entry.label, .run = [difficulty = entry.difficulty](Desk& desk) {
                 desk.leave_exercise([difficulty](Desk& left) { begin_exercise(left, difficulty); });
             }});
    const auto why_not = [](const Desk& desk) -> std::optional<Phrase> {
        if (desk.session.is_concealing()) return std::nullopt;
        return translatable("there is no exercise to be done");
    };
    table.add({.id = "exercise.give_up",
               .menu = menu,
               .label = translatable("Show the answers"),
               .run = [](Desk& desk) { desk.session.give_up_exercise(); },
               .why_not = why_not});
    table.add({.id = "exercise.end",
               .menu = menu,
               .label = translatable("End the exercise"),
               .run = [](Desk& desk) { desk.leave_exercise([](Desk& left) { left.session.end_exercise(); }); },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   if (desk.session.practice()) return std::nullopt;
                   return translatable("there is no exercise to be done");
               }});
}

constexpr std::array topic_entries{
    TopicEntry{Topic::State, "panel.state", translatable("State")},
    TopicEntry{Topic::Construction, "panel.construction", translatable("Construction")},
    TopicEntry{Topic::Exercises, "panel.exercises", translatable("Exercises")},
};

void add_criterion_commands(CommandTable& table)
{
    for (const CriterionEntry& entry : criterion_entries)
        table.add({.id = entry.id,
                   .menu = criterion_menu,
                   .label = entry.label,
                   .run = [criterion = entry.criterion](Desk& desk) { desk.session.set_criterion(criterion); },
                   .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                       if (desk.session.document().subject != Subject::Inertia) return std::nullopt;
                       return translatable("second moments of area do not fail");
                   },
                   .is_on = [criterion = entry.criterion](
                                const Desk& desk) { return desk.session.document().criterion == criterion; }});
}

struct LookEntry {
    bool Look::*item;
    std::string_view id, label;
    Key key;
};
constexpr std::array looks{
    LookEntry{&Look::pole, "view.show.pole", translatable("Pole and its lines"), Key::O},
    LookEntry{&Look::special, "view.show.special", translatable("Principal and largest-shear elements"), Key::E},
    LookEntry{&Look::space, "view.show.space", translatable("Circles of the third direction"), Key::T},
    LookEntry{&Look::envelope, "view.show.envelope", translatable("What the criterion allows"), Key::C},
    LookEntry{&Look::both_rules, "view.show.both_rules", translatable("Both rules of the shear's sign side by side"),
              Key::B},
};

struct RuleEntry {
    fm::ShearRule rule;
    std::string_view id, label;
};
constexpr std::array rules{
    RuleEntry{fm::ShearRule::ClockwiseUp, "view.rule.clockwise_up",
              translatable("Shear up where it turns the element clockwise")},
    RuleEntry{fm::ShearRule::TensorDown, "view.rule.axis_down",
              translatable("Shear axis down, signs of the axes x′y′")},
};

void add_show_commands(CommandTable& table)
{
    ui::standard::add_look_switches(table, show_menu, looks);
    for (const RuleEntry& entry : rules)
        table.add({.id = entry.id,
                   .menu = show_menu,
                   .label = entry.label,
                   .run = [rule = entry.rule](Desk& desk) { desk.session.set_rule(rule); },
                   .is_on = [rule = entry.rule](const Desk& desk) { return desk.session.look.rule == rule; }});
}

void add_view_commands(CommandTable& table)
{
    ui::standard::add_panels(table);
    ui::standard::add_topics(table, topic_entries);
    ui::standard::add_projector(table);
    ui::standard::add_themes(table);
    ui::standard::add_export_scales(table);
    ui::standard::add_languages(table);
}

} // namespace

void Desk::leave_exercise(std::function<void(Desk&)> then)
{
    if (session.is_concealing()) after_exercise = std::move(then);
    else then(*this);
}

void Desk::leave_document(std::function<void(Desk&)> then)
{
    leave_exercise([then = std::move(then)](Desk& desk) { desk.DocumentDesk::leave_document(then); });
}

void Desk::open(const std::filesystem::path& path)
{
    leave_document([path](Desk& desk) { desk.session.open(path); });
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
    add_rosette_commands(table);
    add_plane_commands(table);
    add_construction_commands(table);
    add_criterion_commands(table);
    add_path_commands(table);
    add_exercise_topic_commands(table);
    add_exercise_commands(table);
    add_show_commands(table);
    add_view_commands(table);
    ui::standard::add_help(table);
    return table;
}

} // namespace mohr
