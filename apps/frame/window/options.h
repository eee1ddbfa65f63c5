#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/frame/view/show.h"
#include "ui/paint/geometry.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace frame {

/// What the command line asks for.
struct Options {
    std::vector<std::filesystem::path> files;        ///< one at most without a screen
    std::optional<std::filesystem::path> screenshot; ///< draw one picture, without a screen, and leave
    bool describe = false;                           ///< print model and results in words, without a screen, and leave
    std::optional<std::filesystem::path> play;       ///< a scenario, without a screen
    std::filesystem::path pictures = ".";            ///< where a scenario's pictures go
    std::optional<std::filesystem::path> frames;     ///< where every frame of a scenario goes, for a film
    ui::Size size{1280.0, 800.0};                    ///< logical pixels
    double scale = 1.0;                              ///< physical pixels of a logical one, without a screen
    ui::ThemeName theme = ui::ThemeName::Light;
    ui::Language language = ui::Language::English;
    std::optional<ui::UnitSystem> units;
    std::optional<ShowSet> show;
    std::optional<std::string> load_case;

    bool is_headless() const { return screenshot || play || describe; }
};

/// The command line was a question (`--help`, `--version`) or a mistake: what to print, and the exit status.
class OptionsEnd : public std::runtime_error {
public:
    OptionsEnd(const std::string& text, int exit_status) : std::runtime_error(text), status(exit_status) {}
    int status;
};

/// \throws OptionsEnd
Options parse_options(int argc, const char* const* argv);

} // namespace frame
