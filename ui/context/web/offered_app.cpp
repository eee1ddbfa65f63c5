#include "ui/context/offered_app.h"

#include <emscripten.h>

#include <exception>
#include <utility>

// clang-format off
EM_JS(void, web_answer, (const char* text), { Module['answered'].push(UTF8ToString(text)); });
// Module.copyOfDocument() is a list: the document, and the options that show it likewise. A reason is null where all is well.
EM_JS(void, web_offer_app, (const void* offered), {
    const asked = (call, ...words) => {
        Module['answered'] = [];
        const given = words.map((word) => allocateUTF8(word));
        Module['_web_' + call](offered, ...given);
        given.forEach((word) => _free(word));
        return Module['answered'];
    };
    Module['copyOfDocument'] = () => asked('copy_document');
    Module['description'] = () => asked('describe')[0];
    Module['results'] = () => asked('results')[0];
    Module['replaceDocument'] = (path) => asked('replace_document', path)[0] || null;
    Module['runCommand'] = (id, argument) => asked('run_command', id, argument)[0] || null;
});
EM_JS(void, web_withdraw_app, (), {
    for (const call of ['copyOfDocument', 'description', 'results', 'replaceDocument', 'runCommand']) delete Module[call];
});
// clang-format on

namespace {

void answer(const std::string& text) { web_answer(text.c_str()); }

/// What goes wrong is answered too: nothing is thrown into the page.
template <class Call> void answered(Call&& call)
try {
    call();
} catch (const std::exception& error) {
    answer(error.what());
}

} // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE void web_copy_document(const ui::OfferedApp* offered)
{
    answered([&] {
        const ui::ExportToApp copy = offered->calls().copy();
        answer(copy.document);
        for (const std::string& option : copy.options) answer(option);
    });
}

EMSCRIPTEN_KEEPALIVE void web_describe(const ui::OfferedApp* offered)
{
    answered([&] { answer(offered->calls().description()); });
}

EMSCRIPTEN_KEEPALIVE void web_results(const ui::OfferedApp* offered)
{
    answered([&] { answer(offered->calls().results()); });
}

EMSCRIPTEN_KEEPALIVE void web_replace_document(const ui::OfferedApp* offered, const char* path)
{
    answered([&] {
        if (const auto reason = offered->calls().replace(path)) answer(*reason);
    });
}

EMSCRIPTEN_KEEPALIVE void web_run_command(const ui::OfferedApp* offered, const char* id, const char* argument)
{
    answered([&] {
        if (const auto reason = offered->calls().run_command(id, argument)) answer(*reason);
    });
}

} // extern "C"

namespace ui {

OfferedApp::OfferedApp(AppCalls calls) : calls_(std::move(calls)) { web_offer_app(this); }
OfferedApp::~OfferedApp() { web_withdraw_app(); }

} // namespace ui
