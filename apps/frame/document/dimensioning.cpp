#include "apps/frame/document/dimensioning.h"

#include <algorithm>

namespace frame {

DimensionPlace add_dimension(Document& document, DimensionLine dimension)
{
    document.companion.dimensions.push_back(std::move(dimension));
    return {document.companion.dimensions.size() - 1};
}

void continue_dimension(Document& document, DimensionPlace place, const std::string& node)
{
    std::vector<std::string>& nodes = document.companion.dimensions.at(place.dimension).nodes;
    if (std::ranges::find(nodes, node) == nodes.end()) nodes.push_back(node);
}

void set_node(Document& document, DimensionPlace place, std::size_t n, const std::string& node)
{
    std::vector<std::string>& nodes = document.companion.dimensions.at(place.dimension).nodes;
    if (std::ranges::find(nodes, node) == nodes.end()) nodes.at(n) = node;
}

void set_offset(Document& document, DimensionPlace place, double offset)
{
    document.companion.dimensions.at(place.dimension).offset = offset;
}

void set_direction(Document& document, DimensionPlace place, DimensionDirection direction)
{
    document.companion.dimensions.at(place.dimension).direction = direction;
}

} // namespace frame
