#pragma once

#include <string>

#include "apps/frame/document/document.h"
#include "apps/frame/document/part.h"

namespace frame {

/// Commands on the dimension lines of a document. They throw std::out_of_range, with the document as it was, where the
/// line is not there.

/// \pre its nodes are there, and no two are one \returns its place
DimensionPlace add_dimension(Document& document, DimensionLine dimension);
/// Goes on to one more node, on the same line; nothing where it has the node.
void continue_dimension(Document& document, DimensionPlace place, const std::string& node);
/// Another node in the place of its `n`-th; nothing where the line has the node already.
void set_node(Document& document, DimensionPlace place, std::size_t n, const std::string& node);
void set_offset(Document& document, DimensionPlace place, double offset);
void set_direction(Document& document, DimensionPlace place, DimensionDirection direction);

} // namespace frame
