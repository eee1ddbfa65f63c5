#pragma once

#include <optional>
#include <string>

#include "apps/cross/document/pupil.h"

namespace cross {

/// The exercise that a `cross` block holds under "exercise"; nothing where there is none.
/// \throws ModelError  what of it is none, each with its place
std::optional<Pupil> pupil_in(const std::string& block_json);

/// The block with the exercise, or without it; all else in it stays.
std::string with_pupil(const std::string& block_json, const std::optional<Pupil>& pupil);

} // namespace cross
