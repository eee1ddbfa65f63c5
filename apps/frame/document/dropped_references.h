#pragma once

#include <optional>

#include "femoop/model/model.h"
#include "ui/text/message.h"

namespace frame {

/// What a step took from a model that nobody pointed at: load cases out of combinations that stay, and expected results
/// whose place is gone. Nothing where nothing went unseen.
std::optional<ui::Message> dropped_references(const femoop::Model& before, const femoop::Model& after);

} // namespace frame
