#include "apps/plane/document/gallery/gallery.h"

#include <array>

#include "apps/plane/document/gallery/compiled_models.h"
#include "femoop/io/plane/plane_file.h"
#include "ui/text/catalogue.h"

namespace plane {

namespace {

/// In the order in which CMakeLists.txt lists the models.
constexpr std::array items{
    GalleryItem{"gallery.plate", ui::translatable("A quarter of a plate with a hole")},
    GalleryItem{"gallery.dam", ui::translatable("A gravity dam on rock")},
    GalleryItem{"gallery.cantilever", ui::translatable("A short cantilever with a fillet")},
};

} // namespace

std::span<const GalleryItem> gallery() { return items; }

Document gallery_document(std::size_t item) { return {femoop::plane::read_plane_model(compiled_models().at(item))}; }

} // namespace plane
