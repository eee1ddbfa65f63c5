#pragma once

#include "apps/cross/session/commands.h"
#include "apps/cross/window/cell_field.h"
#include "ui/widgets/number_field.h"

namespace cross {

/// A pupil's exercises: which one, how it is judged, the score; and of the cell that is being filled what is asked,
/// hints and what is said of its number.
class ExercisePanel {
public:
    /// Difficulty, seed, and what begins and ends.
    void show_beginning(Workspace& workspace, const CommandTable& commands);
    /// \pre the session has a paper
    void show_worksheet(Workspace& workspace, const CommandTable& commands, CellField& field, bool is_cell_drawn);
    bool is_typing() const { return fields_.is_typing(); }

private:
    void show_seed(Workspace& workspace);

    ui::NumberFields fields_;
};

} // namespace cross
