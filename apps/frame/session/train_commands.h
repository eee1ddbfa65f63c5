#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/session/commands.h"
#include "femoop/methods/influence/train/train_library.h"

namespace frame {

/// What is done with the train that stands on the influence line, and the trains that can be taken from the library.
void add_train_commands(CommandTable& table);

/// The train of the model that is chosen to stand on the influence line; empty: none, or it is gone.
std::string chosen_train(const Session& session);

/// Asks for the influence line of a section force or a reaction in the envelope of trains, with the train that governs
/// where it is worst. \param which  nothing: the value of the greater magnitude \pre the envelope is shown and has values
void ask_governing(Workspace& workspace, const femoop::MovingEffect& effect,
                   std::optional<femoop::ExtremeKind> which = {});

/// The command that takes one.
struct LibraryCommand {
    std::string_view id, label; ///< the label is translatable
    const femoop::influence::LibraryTrain* train;
};
std::vector<LibraryCommand> library_commands(); ///< in the library's order

/// Stands a train of the library on the line that is looked at: it becomes one of the document's, on the line's path,
/// where it is none yet. \pre an influence line is shown
void take_from_library(Session& session, const femoop::influence::LibraryTrain& train);

} // namespace frame
