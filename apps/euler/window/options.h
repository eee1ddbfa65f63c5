#pragma once

#include <string>

#include <cstddef>
#include <optional>

#include "ui/app/app_options.h"

namespace euler {

/// What the command line asks for.
struct Options : ui::AppOptions {    ///< files: one at most
    std::optional<std::size_t> step; ///< that the picture shows; the end of the script without it
};

/// \throws ui::OptionsEnd
Options parse_options(int argc, const char* const* argv, const std::string& version);

} // namespace euler
