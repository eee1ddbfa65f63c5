#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "femoop/model/fault/translator.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

/// The shortest decimal that reads back as the same double: 0.1, 25, 205000, 2.05e8, 8.333e-6, -0.0.
/// It is a JSON number when `value` is finite.
std::string number_text(double value);

/// What stands between a number's whole and its fraction in the reader's language.
inline char decimal_mark(const Translator& tr) { return tr(translatable(".")).front(); }

/// The text of a number with the reader's decimal mark.
std::string localized(std::string number, const Translator& tr);

/// A text that begins with a typographic minus or dash (U+2212, U+2013, U+2014), with a hyphen instead. Nothing if not.
std::optional<std::string> with_hyphen(std::string_view text);

/// A number with the unit it is counted in, for messages: "6 m", "-25 kN/m", "0.3".
std::string quantity_text(double value, Dimension dimension, const Units& units);

} // namespace femoop
