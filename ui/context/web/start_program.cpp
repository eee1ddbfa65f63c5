#include "ui/context/start_program.h"

#include <emscripten.h>

#include <string>

#include "ui/text/catalogue.h"

// clang-format off
// The page of the other app reads the document as its standard input (page.js).
EM_JS(int, web_open_app, (const char* program, const char* document, const char* options), {
    if (!Module['openApp']) return 0;
    return Module['openApp'](UTF8ToString(program), UTF8ToString(document), UTF8ToString(options)) ? 1 : 0;
});
// clang-format on

namespace ui {

std::filesystem::path folder_of_programs() { return "/"; }

std::optional<Message> start_program(const ExportToApp& exported, const std::filesystem::path&)
{
    std::string options;
    for (const std::string& option : exported.options) options += option + "\n";
    if (web_open_app(exported.program.c_str(), exported.document.c_str(), options.c_str())) return std::nullopt;
    return Message(translatable("the browser did not open a page for {program}; allow this page to open others"),
                   {{"program", exported.program}});
}

std::optional<Message> become_program(const std::string& program, const std::vector<std::string>&,
                                      const std::filesystem::path&)
{
    return Message(translatable("{program} is opened as a page of the browser: {page}"),
                   {{"program", program}, {"page", program + ".html"}});
}

} // namespace ui
