#pragma once

#include <string>

#include "apps/euler/session/commands.h"

namespace euler {

/// The palette: every operator; once one is chosen its arguments, asked for one by one, and what it would do.
class OperatorsPanel {
public:
    void show(Desk& desk, const CommandTable& commands);
    /// Something is typed into it.
    bool is_typing() const { return is_typing_; }

private:
    void list(Desk& desk, const CommandTable& commands);
    void show_draft(Desk& desk, const CommandTable& commands);
    void ask(Session& session);
    bool suggest(const Session& session); ///< \returns whether another argument is asked for than before

    std::string typed_;
    std::optional<std::size_t> asked_; ///< argument that `typed_` is for
    std::optional<Verb> verb_;
    std::optional<ui::Phrase> reason_; ///< why what was typed last was not taken
    bool is_typing_ = false;
};

} // namespace euler
