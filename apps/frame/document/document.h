#pragma once

#include "apps/frame/document/companion/companion.h"
#include "femoop/model/model.h"

namespace frame {

/// What the frame app edits and saves: a structure and its loads, and what stands beside it in the picture. A plain
/// value; the commands (command.h) are the only way to change it, and a history keeps its former states.
struct Document {
    femoop::Model model;
    Companion companion{}; ///< saved in a file of its own

    friend bool operator==(const Document&, const Document&) = default;
};

/// What the app begins with when no file is named: a portal frame with a beam load and a wind load.
Document starting_document();

/// About how much memory it takes [bytes]: a history is bounded by it.
std::size_t memory_footprint(const Document& document);

} // namespace frame
