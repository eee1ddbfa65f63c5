#pragma once

#include "femoop/io/cross/sheet_check.h"

namespace femoop::cross {

/// The problem with its sways held where the block's first stage has props.
/// \throws ModelError (UnknownChoice) where they are not such that hold every sway once
Problem propped_as_in(const Block& block, const Model& model, const Problem& whole);

/// A block's stages: the loads with every sway held, then each sway alone. Of each the fixed-end moments, the sheet,
/// the forces of the props that follow from its row TOTAL, and the exact end moments and force
/// (femoop/methods/cross/props.h). \throws ModelError naming the place of what does not fit the structure
void check_stages(SheetCheck& check);

} // namespace femoop::cross
