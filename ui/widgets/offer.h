#pragma once

#include <cstdint>
#include <optional>

#include "ui/files/linked_copy.h"
#include "ui/text/catalogue.h"

namespace ui {

enum class OfferAnswer : std::uint8_t { TakeOver, Keep };

/// What a linked program offers, with both answers, in a line of the menu bar, where it covers nothing.
/// \pre within a menu bar
std::optional<OfferAnswer> show_offer(const OfferWords& words, const Catalogue& tr);

} // namespace ui
