#pragma once

#include <optional>

#include "femoop/model/model.h"
#include "ui/text/message.h"

namespace frame {

/// Why a change takes a node too far off; nothing where it takes none. Places nearer than a millionth of the
/// structure's extent are one, so a node that is very far off would make one of the others. Allowed are 1000 km, less
/// beside very short members, and as far as a node is already.
std::optional<ui::Message> why_beyond_coordinate_limit(const femoop::Model& before, const femoop::Model& after);

} // namespace frame
