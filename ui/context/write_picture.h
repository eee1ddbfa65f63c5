#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ui/paint/color.h"
#include "ui/paint/picture.h"
#include "ui/paint/text_measure.h"
#include "ui/text/message.h"

namespace ui {

/// What a picture gets when it leaves the window.
struct PictureLook {
    Color background;
    std::string title;      ///< of a PDF document
    double png_scale = 2.0; ///< pixels of a PNG for a logical one
};

/// Writes it as the name's end says: .png, .svg or .pdf, in letters of any size. \returns why it cannot be written
std::optional<Message> write_picture(const std::filesystem::path& path, const Picture& picture, const Fonts& fonts,
                                     const PictureLook& look);

/// Puts it on the clipboard, as a PNG. \returns why it could not
std::optional<Message> copy_picture(const Picture& picture, const Fonts& fonts, const PictureLook& look);

} // namespace ui
