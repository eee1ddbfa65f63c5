#pragma once

#include <string_view>

#include "ui/text/catalogue.h"
#include "ui/text/number_format.h"

namespace ui {

/// What stands between a number's whole and its fraction.
constexpr DecimalMark decimal_mark(Language language)
{
    return language == Language::Portuguese ? DecimalMark::Comma : DecimalMark::Point;
}

/// As the web names it (BCP 47): "en", "pt-BR".
constexpr std::string_view language_tag(Language language) { return language == Language::Portuguese ? "pt-BR" : "en"; }

} // namespace ui
