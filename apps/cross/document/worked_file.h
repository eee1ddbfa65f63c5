#pragma once

#include <string>

#include "apps/cross/document/document.h"

namespace cross {

/// How far the sheets of a document are worked, with every branch, as a `cross` block holds it under "worked":
///
///     {"sheet": 0, "plays": [{"ways": [["C", "B"], ["C", null]], "way": 1, "at": 2}]}
///
/// "plays" are of the loads and of each sway; "ways" every branch from the start, joint after joint (null: all at
/// once); "at" so many turns along the branch "way". Nothing was worked: the block is without it.
std::string with_worked(const std::string& block_json, const Document& document);

/// Takes it out of the block into the document. Sheets and joints that the structure does not have are left out, with
/// what follows them: a structure that was changed is worked anew.
/// \throws ModelError  what of it cannot be read, each with its place
void read_worked(std::string& block_json, Document& document);

} // namespace cross
