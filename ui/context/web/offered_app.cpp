#include "ui/context/offered_copy.h"

#include <emscripten.h>

#include <exception>
#include <iostream>
#include <string>
#include <utility>

// clang-format off
EM_JS(void, web_add_to_copy, (const char* part), { Module['copied'].push(UTF8ToString(part)); });
// A list: the document, and the options that show it likewise.
EM_JS(void, web_offer_copy, (const void* offered), {
    Module['copyOfDocument'] = () => {
        Module['copied'] = [];
        Module['_web_copy_document'](offered);
        return Module['copied'];
    };
});
EM_JS(void, web_withdraw_copy, (), { delete Module['copyOfDocument']; });
// clang-format on

extern "C" EMSCRIPTEN_KEEPALIVE void web_copy_document(const ui::OfferedCopy* offered)
try {
    const ui::ExportToApp copy = offered->copy()();
    web_add_to_copy(copy.document.c_str());
    for (const std::string& option : copy.options) web_add_to_copy(option.c_str());
} catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
}

namespace ui {

OfferedCopy::OfferedCopy(Copy copy) : copy_(std::move(copy)) { web_offer_copy(this); }
OfferedCopy::~OfferedCopy() { web_withdraw_copy(); }

} // namespace ui
