#include "apps/plane/view/mesh_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ui/text/catalogue.h"

namespace plane {

using femoop::plane::Formulation;
using ui::translatable;

std::string_view method_word(std::string_view method)
{
    using Word = std::pair<std::string_view, std::string_view>;
    static constexpr std::array<Word, 8> words{{
        {"auto", translatable("automatic")},
        {"mapped", translatable("mapped")},
        {"trilateral", translatable("trilateral")},
        {"sweep", translatable("swept")},
        {"delaunay", translatable("Delaunay")},
        {"front", translatable("advancing front")},
        {"quadtree", translatable("quadtree")},
        {"quads", translatable("quadrilaterals")},
    }};
    const auto found = std::ranges::find(words, method, &Word::first);
    return found == words.end() ? method : found->second;
}

std::string_view formulation_word(Formulation formulation)
{
    switch (formulation) {
    case Formulation::Reduced: return translatable("reduced integration");
    case Formulation::BBar: return translatable("B-bar");
    case Formulation::Incompatible: return translatable("incompatible modes");
    case Formulation::Standard: break;
    }
    return translatable("standard");
}

} // namespace plane
