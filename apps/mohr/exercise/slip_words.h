#pragma once

#include "ui/text/catalogue.h"

namespace mohr {

// Of mistakes that are made in the plane and in space.
inline constexpr auto no_root = ui::translatable("the square root is missing");
inline constexpr auto sign_turned = ui::translatable("the sign is turned");

} // namespace mohr
