#pragma once

#include <span>
#include <string_view>

#include "apps/plane/document/document.h"

namespace plane {

/// A ready drawing.
struct GalleryItem {
    std::string_view id;    ///< of its command
    std::string_view title; ///< to be translated
};
std::span<const GalleryItem> gallery();

/// \pre item < gallery().size()
Document gallery_document(std::size_t item);

} // namespace plane
