#pragma once

#include "apps/mohr/session/commands.h"
#include "ui/widgets/number_field.h"

namespace mohr {

/// Questions with fields for the answers, and what became of them.
class ExercisesPanel {
public:
    void show(Workspace& workspace, const CommandTable& commands);
    bool is_typing() const { return fields_.is_typing(); }

private:
    void show_question(Workspace& workspace, std::size_t place);

    ui::NumberFields fields_;
};

} // namespace mohr
