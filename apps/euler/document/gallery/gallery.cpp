#include "apps/euler/document/gallery/gallery.h"

#include <array>
#include <cstddef>
#include <utility>

#include "apps/euler/document/gallery/compiled_scripts.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using ui::translatable;

/// In the order in which CMakeLists.txt lists the scripts.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> titles{{
    {"cube", translatable("Cube")},
    {"tetrahedron", translatable("Tetrahedron")},
    {"through_hole", translatable("Block with a through hole")},
    {"torus_by_rotation", translatable("Torus by rotation")},
    {"void", translatable("Block with a void")},
    {"hoffmann", translatable("Hoffmann's figure: hole and void")},
    {"torus", translatable("The smallest torus")},
    {"shell_and_hole", translatable("MSG and KSG: a shell and a hole")},
}};

} // namespace

std::vector<GalleryItem> gallery()
{
    const std::vector<std::string_view> scripts = compiled_scripts();
    std::vector<GalleryItem> items;
    for (std::size_t i = 0; i < titles.size(); ++i) items.push_back({titles[i].first, titles[i].second, scripts[i]});
    return items;
}

} // namespace euler
