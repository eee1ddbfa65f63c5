#pragma once

#include <string>

#include "ui/app/app_options.h"

namespace mohr {

/// What the command line asks for; one file at most. \throws ui::OptionsEnd
ui::AppOptions parse_options(int argc, const char* const* argv, const std::string& version);

} // namespace mohr
