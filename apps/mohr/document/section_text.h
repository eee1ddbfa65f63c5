#pragma once

#include <string_view>
#include <variant>

#include "femoop/methods/mohr/section_stress.h"
#include "femoop/model/quantity/units.h"
#include "ui/text/message.h"

namespace mohr {

/// What sections are counted in.
inline constexpr femoop::Units newtons_and_mm{.length = femoop::LengthUnit::mm, .force = femoop::ForceUnit::N};

/// The section that a text names, in mm, or why it names none: a rolled profile, "IPE 300", or a shape with its
/// dimensions, "i h=300mm bf=150mm tf=12mm tw=8mm"; bare dimensions are in mm. "turned" behind it lays it on its side.
std::variant<femoop::mohr::SectionFigure, ui::Message> section_figure(std::string_view text);

} // namespace mohr
