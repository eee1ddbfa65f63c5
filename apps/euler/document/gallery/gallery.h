#pragma once

#include <string_view>
#include <vector>

namespace euler {

/// A ready script. Its comments explain its steps, in English; their Portuguese stands in ui/text/pt_BR/gallery.po.
struct GalleryItem {
    std::string_view name;  ///< of its file in examples/: "cube"
    std::string_view title; ///< to be translated
    std::string_view script;
};

/// From the simplest on.
std::vector<GalleryItem> gallery();

} // namespace euler
