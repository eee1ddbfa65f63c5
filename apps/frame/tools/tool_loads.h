#pragma once

#include <span>
#include <string_view>

#include "apps/frame/tools/settings.h"

namespace frame {

/// A load that the load tool and its commands can put, in the words of a kind of structure.
struct ToolLoadEntry {
    ToolLoad load;
    std::string_view command; ///< "load.force_down"
    std::string_view label;   ///< translatable: "Add a force ↓"
    std::string_view name;    ///< translatable: "Force ↓"
};

/// Those of a structure of this kind. In a plane frame "→" is x and "↓" against y; in space and in a grillage, where z
/// is up, every axis has its own.
std::span<const ToolLoadEntry> tool_loads(femoop::AnalysisKind kind);
/// The entry of the load; in a structure that lacks this one the first of its sort.
const ToolLoadEntry& entry_of(const ToolLoad& load, femoop::AnalysisKind kind);

} // namespace frame
