#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"

namespace femoop {

/// What a structure is and how large, in the few words that a table or a page begins with.
std::string kind_text(AnalysisKind kind, const Translator& tr);  ///< "plane frame"
std::string size_text(const Model& model, const Translator& tr); ///< "4 nodes, 1 member"
/// "Roof over the market: 4 nodes, 1 member"; the size alone where there is no title.
std::string title_and_size_text(const Model& model, const Translator& tr);

/// "{0} node" or "{0} nodes", already translated, with the number in its place.
std::string counted(std::size_t n, std::string_view one, std::string_view many);

} // namespace femoop
