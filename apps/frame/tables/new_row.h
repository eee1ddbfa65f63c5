#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/frame/document/document.h"
#include "apps/frame/tables/columns.h"

namespace frame {

/// Adds a part to the document that its cells are still to be written to. Its name is empty where one that is made
/// from the cells will do. \pre !is_result(kind)
Part append(Document& document, TableKind kind);

/// Gives a new part a name in the manner of the others, if it has none.
void give_name(femoop::Model& model, const Part& part);

/// What cannot be about a row as a whole, as a sentence: a member from a node to itself, a load without a value.
std::optional<std::string> why_not_row(const femoop::Model& model, const Part& part, const ui::Catalogue& tr);

/// The part's name, where another of its kind has it too.
std::optional<std::string> double_name(const femoop::Model& model, const Part& part);

/// Takes loads from their load cases to others, behind the loads that are there.
void move_loads(Document& document, std::vector<CaseMove> moves);

} // namespace frame
