#pragma once

#include <cstddef>
#include <optional>

#include "apps/euler/session/commands.h"
#include "ui/widgets/kept_field.h"

namespace euler {

/// The palette: every operator; once one is chosen its arguments, asked for one by one, and what it would do. While it
/// asks its field has the keyboard.
class OperatorsPanel {
public:
    void show(Workspace& workspace, const CommandTable& commands);

private:
    void list(Workspace& workspace, const CommandTable& commands);
    void show_draft(Workspace& workspace, const CommandTable& commands);
    void ask(Session& session);
    void handle_typed(Session& session);
    void suggest(const Session& session);

    ui::KeptField field_{ui::KeptField::Hold::UntilDone};
    std::optional<std::size_t> asked_; ///< argument that the field is for
    std::optional<Verb> verb_;
    std::optional<ui::Message> reason_; ///< why what was typed last was not taken
};

} // namespace euler
