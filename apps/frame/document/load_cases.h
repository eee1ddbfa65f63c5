#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/frame/document/document.h"
#include "apps/frame/document/part.h"

namespace frame {

/// Commands on load cases and combinations. Both share one set of names. All throw std::out_of_range, with the document
/// as it was, where the case is not there.

/// The place of a load case or combination in its list. \pre id.index < model.n_cases()
Part part_of(const femoop::Model& model, femoop::CaseId id);
/// The case that a part is; nothing for a part of another kind.
std::optional<femoop::CaseId> case_id_of(const femoop::Model& model, const Part& part);

/// An empty load case behind the others, under the next free number.
femoop::CaseId add_load_case(Document& document);
/// All load cases together, each with the factor 1. \pre there is one
femoop::CaseId add_combination(Document& document);
/// The same under a name made fresh, behind the others of its kind.
femoop::CaseId copy_case(Document& document, femoop::CaseId id);

/// Why the case cannot have this name; nothing where it can.
std::optional<ui::Message> why_not_rename(const femoop::Model& model, femoop::CaseId id, std::string_view name);
/// \pre why_not_rename gives no reason
void rename(Document& document, femoop::CaseId id, std::string name);

/// Puts the self-weight into a load case, whole, or takes it out.
void set_self_weight(Document& document, LoadCasePlace place, double factor);

} // namespace frame
