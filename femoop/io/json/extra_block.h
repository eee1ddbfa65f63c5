#pragma once

#include <optional>
#include <string_view>

#include "femoop/io/json/json_document.h"
#include "femoop/model/model.h"

namespace femoop {

/// What stands in a block of the file that is read apart from the model, such as "cross"; nothing without the block.
/// \throws ModelError where it is not JSON
std::optional<JsonDocument> extra_block(const Model& model, std::string_view key);

} // namespace femoop
