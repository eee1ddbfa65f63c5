#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Hiding the results from a class, and what it sketches of them meanwhile.
void add_predict_commands(CommandTable& table);

/// Hides every result, for a class to guess, or brings back those that were shown; the moments too, where they were
/// guessed.
void hide_or_reveal(Workspace& workspace);

/// A result, which is kept from sight then.
bool is_hideable(Show item);

/// Why no moments can be sketched now; nothing where they can.
std::optional<ui::Message> why_not_predict(const Workspace& workspace);

/// Takes up the tool that sketches, and hides the results.
void begin_to_predict(Workspace& workspace);

/// Whether the hand is at it and something was sketched, so that Esc and Del mean the sketch.
bool is_predicting(const Workspace& workspace);

} // namespace frame
