#include "ui/context/write_picture.h"

#include <array>
#include <exception>
#include <string>
#include <system_error>
#include <unistd.h>

#include "ui/context/image_clipboard.h"
#include "ui/context/rasterize.h"
#include "ui/files/ending.h"
#include "ui/paint/surface/pdf.h"
#include "ui/paint/surface/svg.h"
#include "ui/paint/surface/write_file.h"
#include "ui/text/catalogue.h"
#include "ui/workbench/file_sentences.h"

namespace ui {

namespace {

/// A name in the folder for temporary files, which goes with its file.
class ScratchFile {
public:
    ScratchFile() : path_(std::filesystem::temp_directory_path() / ("cremona-" + std::to_string(getpid()) + ".png")) {}
    ~ScratchFile()
    {
        std::error_code nobody_cares;
        std::filesystem::remove(path_, nobody_cares);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace

std::optional<Message> write_picture(const std::filesystem::path& path, const Picture& picture, const Fonts& fonts,
                                     const PictureLook& look)
{
    static const std::array<std::string, 3> endings{".png", ".svg", ".pdf"};
    if (const auto reason = why_not_ending(path, endings)) return reason;
    try {
        if (has_ending(path, ".pdf")) write_pdf(path, picture, fonts, {look.background, look.title});
        else if (has_ending(path, ".svg")) write_file(path, svg_document(picture, fonts, look.background));
        else write_png(path, rasterized(picture, fonts, {.scale = look.png_scale, .background = look.background}));
    } catch (const std::exception& error) {
        return not_written(path, error);
    }
    return std::nullopt;
}

std::optional<Message> copy_picture(const Picture& picture, const Fonts& fonts, const PictureLook& look)
{
    const ScratchFile file;
    if (auto reason = write_picture(file.path(), picture, fonts, look)) return reason;
    return copy_png(file.path());
}

} // namespace ui
