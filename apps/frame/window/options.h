#pragma once

#include <optional>
#include <string>

#include "apps/drawing/show.h"
#include "apps/frame/document/drawing_names.h"
#include "ui/app/app_options.h"

namespace frame {

/// What the command line asks for.
struct Options : ui::AppOptions { ///< files: one at most without a screen
    std::optional<ShowSet> show;
    std::optional<std::string> load_case;
};

/// \throws ui::OptionsEnd
Options parse_options(int argc, const char* const* argv, const std::string& version);

} // namespace frame
