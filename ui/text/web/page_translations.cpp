#include "ui/text/compiled_translations.h"

#include <emscripten.h>

#include <algorithm>
#include <cstdlib>
#include <string>

// clang-format off
// A page fetches them where they are wanted (ui/app/web/page.js); under node they lie beside the program.
EM_JS(char*, web_portuguese, (), {
    if (typeof Module['portuguese'] === 'string') return allocateUTF8(Module['portuguese']);
    if (typeof require !== 'function') return 0;
    return allocateUTF8(require('fs').readFileSync(__dirname + '/pt_BR.po', 'utf8'));
});
// clang-format on

namespace ui {

namespace {

/// Empty until the page has them.
const std::string& joined_portuguese()
{
    static std::string text;
    if (!text.empty()) return text;
    if (char* const loaded = web_portuguese()) {
        text = loaded;
        std::free(loaded);
    }
    return text;
}

} // namespace

std::vector<std::string_view> compiled_portuguese()
{
    std::vector<std::string_view> files;
    std::string_view rest = joined_portuguese();
    while (!rest.empty()) { // join.py puts a form feed between them
        const std::size_t end = std::min(rest.find('\f'), rest.size());
        files.push_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return files;
}

} // namespace ui
