#pragma once

#include <optional>
#include <span>
#include <string>

#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

/// The structure and what happens to it, in sentences: for readers who cannot see the picture, and as the text that
/// stands for it on a page. Supports, members and loads are described one a line; then, with results, the degree of
/// static indeterminacy and for each case the largest displacement, the reactions and the extreme section forces
/// with their places. The same model always gives the same text.
///
/// Units  every number carries its unit; six significant digits
std::string describe(const Model& model, const std::optional<Results>& results, const Translator& tr);
/// The same with the results of some cases only.
std::string describe(const Model& model, const Results& results, std::span<const CaseId> cases, const Translator& tr);

} // namespace femoop
