#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ui {

/// What a program is told by whoever starts it: files and options, from a terminal or from the address of its page.
struct CommandLine {
    struct Option {
        std::string name;  ///< "--theme"
        std::string value; ///< "NAME", as the help calls it; "" of one that is only given or not
        std::string words; ///< what it does
        std::function<void(const std::string&)> take;
        std::string needs{}; ///< another that must be given with it
    };

    std::string program; ///< "mohr"
    std::string version; ///< "0.1.0"
    std::string purpose; ///< "Shows Mohr's circle at work: ..."
    std::string words_of_files;
    std::function<void(const std::vector<std::string>&)> take_files;
    std::vector<Option> options{};
};

/// Reads what was typed, `--name value` or `--name=value`, and hands it out in any order. A page, which nobody asks for
/// help, has a reader of its own. \throws OptionsEnd
void read(const CommandLine& line, int argc, const char* const* argv);

} // namespace ui
