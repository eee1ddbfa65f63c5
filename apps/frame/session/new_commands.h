#pragma once

#include <span>
#include <string_view>

#include "apps/frame/session/commands.h"

namespace frame {

/// The kinds of structure that can be begun, in the order of the keys 1 to 5.
struct KindEntry {
    femoop::AnalysisKind kind;
    std::string_view id, label; ///< of the command that begins one; "Space frame"
    std::string_view change_id; ///< of the command that makes a structure one
};
std::span<const KindEntry> kinds();
std::string_view label_of(femoop::AnalysisKind kind);

/// New, which begins a plane frame and asks whether it is to be another kind, and a command for each of them.
void add_new_commands(CommandTable& table);

} // namespace frame
