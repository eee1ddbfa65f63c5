#include "ui/context/image_clipboard.h"

#include <emscripten.h>

#include "ui/text/catalogue.h"

// clang-format off
EM_JS(int, web_copy_png, (const char* path), {
    if (!navigator.clipboard || typeof ClipboardItem === 'undefined') return 0;
    const picture = new Blob([FS.readFile(UTF8ToString(path))], { type: 'image/png' });
    navigator.clipboard.write([new ClipboardItem({ 'image/png': picture })]).catch((error) => err(error.message));
    return 1;
});
// clang-format on

namespace ui {

std::optional<Message> copy_png(const std::filesystem::path& png)
{
    if (web_copy_png(png.c_str())) return std::nullopt;
    return Message(translatable("this browser takes no pictures on its clipboard; export the picture instead"));
}

} // namespace ui
