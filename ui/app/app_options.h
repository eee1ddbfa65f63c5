#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ui/app/command_line.h"
#include "ui/app/settings.h"
#include "ui/files/draft.h"
#include "ui/paint/geometry.h"

namespace ui {

/// What the command line of every app asks for.
struct AppOptions {
    std::vector<std::filesystem::path> files;
    std::optional<std::filesystem::path> screenshot; ///< draw one picture, without a screen, and leave
    bool is_bare = false;                            ///< the picture with its tools, without menus and panels
    bool has_no_tools = false;                       ///< without the bar of tools
    bool is_still = false;                           ///< nothing moves by itself
    bool describe = false;                           ///< print the document in words, without a screen, and leave
    std::optional<std::filesystem::path> play;       ///< a scenario, without a screen
    std::filesystem::path pictures = ".";            ///< where a scenario's pictures go
    std::optional<std::filesystem::path> frames;     ///< where every frame of a scenario goes, for a film
    std::optional<std::filesystem::path> link;       ///< folder of a link with the program that has started this one
    double scale = 1.0;                              ///< physical pixels of a logical one, without a screen
    Settings settings;                               ///< that were asked for; after `complete` all but the units
    Settings asked_for;                              ///< after `complete` those of them that were

    bool is_headless() const { return screenshot || play || describe; }
};

/// What is not asked for is as it was left in a window, for a window alone: pictures, scenarios and descriptions are
/// the same for everybody. The rest is what suits a first time. \param folder  where it is kept
void complete(AppOptions& options, const std::optional<DraftFolder>& folder);
/// The file of it in that folder.
std::filesystem::path settings_file(const DraftFolder& folder);

/// The command line was a question (`--help`, `--version`) or a mistake: what to print, and the exit status.
class OptionsEnd : public std::runtime_error {
public:
    OptionsEnd(const std::string& text, int exit_status) : std::runtime_error(text), status(exit_status) {}
    static OptionsEnd mistake(const std::string& text) { return {text, 2}; }
    int status;
};

/// What an app says of the options that mean its own document.
struct OptionWords {
    std::string files;    ///< "model files (.json) to open, each in a tab"
    std::string describe; ///< "print the model and its results in words and leave; needs no display"
};

/// What the program of an app says of itself.
struct ProgramWords {
    std::string name;    ///< "mohr"
    std::string version; ///< "0.1.0"
    std::string purpose; ///< "Shows Mohr's circle at work: ..."
    OptionWords options;
};
/// The options of every app, which `read` puts into these. \pre they outlive it
CommandLine app_command_line(const ProgramWords& words, AppOptions& options);

/// Reads the command line of an app of one document. \param own  options of its own
/// \throws OptionsEnd, also of a second file
void parse_one_file(const ProgramWords& words, AppOptions& options, int argc, const char* const* argv,
                    const std::vector<CommandLine::Option>& own = {});

/// The value of an option that names one of a list. \throws OptionsEnd where there is none
template <class Value> struct NamedOption {
    std::string option;         ///< "frame: --theme"
    std::string found;          ///< what was typed
    std::string list;           ///< "light, dark, print, projector"
    std::optional<Value> value; ///< nothing: it names none

    Value operator()() const
    {
        if (!value) throw OptionsEnd::mistake(option + ": found \"" + found + "\", wanted one of " + list);
        return *value;
    }
};

} // namespace ui
