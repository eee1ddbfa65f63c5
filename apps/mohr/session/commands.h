#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "apps/mohr/session/session.h"
#include "ui/command/menu_builder.h"
#include "ui/workspace/document_workspace.h"

namespace mohr {

/// What the panel at the left shows.
enum class Topic : std::uint8_t { State, Construction, Exercises };

/// A session and the panels around its picture.
struct Workspace : ui::DocumentWorkspace<Workspace, Session> {
    using DocumentWorkspace::DocumentWorkspace;

    /// Goes on with what would lose an exercise: at once where none is being done, else the window asks first.
    void leave_exercise(std::function<void(Workspace&)> then);
    void leave_document(std::function<void(Workspace&)> then); ///< as every app does, once the exercise is left

    Topic topic = Topic::State;
    ExerciseTopic exercise_topic = ExerciseTopic::PlaneStress;
    std::uint32_t next_exercise = 1; ///< what the next one is drawn from
    bool is_asking_next = false;     ///< the next question's field gets the keyboard once it is shown
    /// What is to be done once the user has said that the exercise ends.
    std::function<void(Workspace&)> after_exercise{};
};

using CommandTable = ui::CommandTable<Workspace>;

/// Everything that the app can do, by name.
CommandTable command_table();

using TopicEntry = ui::Choice<Topic>;
std::span<const TopicEntry> topics(); ///< in the order of their tabs
using SubjectEntry = ui::Choice<Subject>;
std::span<const SubjectEntry> subjects();
using ExerciseTopicEntry = ui::Choice<ExerciseTopic>;
std::span<const ExerciseTopicEntry> exercise_topics();
using CriterionEntry = ui::Choice<std::optional<femoop::mohr::Criterion>>;
std::span<const CriterionEntry> criteria();

} // namespace mohr
