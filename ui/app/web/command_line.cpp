#include "ui/app/command_line.h"

#include <algorithm>
#include <string_view>

#include "ui/app/app_options.h"

namespace ui {

void read(const CommandLine& line, int argc, const char* const* argv)
{
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (!word.starts_with("--")) {
            files.emplace_back(word);
            continue;
        }
        const std::string name(word.substr(0, word.find('=')));
        const auto option = std::find_if(line.options.begin(), line.options.end(),
                                         [&](const CommandLine::Option& one) { return one.name == name; });
        if (option == line.options.end())
            throw OptionsEnd::mistake("The following argument was not expected: " + std::string(word));
        const bool has_value = name.size() < word.size();
        if (option->value.empty() || has_value) option->take(std::string(word.substr(name.size() + has_value)));
        else if (++i < argc) option->take(argv[i]);
        else throw OptionsEnd::mistake(name + ": 1 required TEXT missing");
    }
    if (!files.empty()) line.take_files(files);
}

} // namespace ui
