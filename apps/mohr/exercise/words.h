#pragma once

#include <string>
#include <string_view>

#include "apps/mohr/exercise/exercise.h"
#include "ui/text/catalogue.h"

namespace mohr {

/// What is asked, with its unit and with what is given beside the state.
std::string question(Asked asked, const Exercise& exercise, const ui::Catalogue& tr);

/// The operation, not the number.
std::string_view hint(Asked asked, const Exercise& exercise);

} // namespace mohr
