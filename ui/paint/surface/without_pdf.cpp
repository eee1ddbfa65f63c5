#include "ui/paint/surface/pdf.h"

#include <stdexcept>

namespace ui {

void write_pdf(const std::filesystem::path& path, std::span<const PdfPage>, const Fonts&, const PdfLook&)
{
    throw std::runtime_error("file " + path.string() + ": this build writes no PDF; export .svg or .html and print it");
}

void write_pdf(const std::filesystem::path& path, const Picture&, const Fonts& fonts, const PdfLook& look)
{
    write_pdf(path, std::span<const PdfPage>(), fonts, look);
}

} // namespace ui
