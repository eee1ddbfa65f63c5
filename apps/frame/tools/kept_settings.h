#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/frame/tools/settings.h"
#include "femoop/model/quantity/units.h"

namespace frame {

/// The distance of the grid's lines that was typed, in a model of these units; nothing where it is a round one.
std::optional<double> typed_spacing(const ToolSettings& settings, const femoop::Units& units);

/// What of the settings is remembered from one time to the next: "grid on 0.75 m snap off".
std::string kept_words(const ToolSettings& settings);
/// What is not understood, such as a later version's words, changes nothing.
void take_up(ToolSettings& settings, std::string_view words);

} // namespace frame
