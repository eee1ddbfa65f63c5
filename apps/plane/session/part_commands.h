#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/plane/document/number.h"
#include "apps/plane/session/commands.h"

namespace plane {

/// What can be given to what is selected: supports, holes, loads; cases and the kind of analysis.
void add_part_commands(CommandTable& table);

/// "Curve C3", "Region R1", "Face without a region".
ui::Message title(const Session& session, const Part& part);
ui::Message title(const Session& session, femoop::CaseId id); ///< "Load case G", "Combination C"

/// The numbers of a part, without those of its loads.
std::vector<Number> numbers_of(const Session& session, const Part& part);
/// Those of the loads of the case that is shown on a curve or in a face's region, one load after the other.
std::vector<Number> numbers_of_loads(const Session& session, const Part& part);
/// A change of a number, named after whose it is: a part, a material, a case.
Change change_of(const ui::Message& whose, const Number& number, const std::optional<femoop::Quantity>& value,
                 Step step);
/// What is wrong with what was typed into a field, which itself shows where.
std::string reason_of(const Session& session, const femoop::Fault& fault);
/// Reads a number as it is typed, empty where it is taken away, and changes it. \returns why not
std::optional<ui::Message> set_typed(Workspace& workspace, const ui::Message& whose, const Number& number,
                                     std::string_view text);

/// The support of a selected point or curve; null where there is none.
const femoop::plane::PlaneSupport* support_of(const Session& session, const Part& part);
/// Changes the support of the object form that the part has.
void change_support(Workspace& workspace, const Part& part, const ui::Message& label,
                    const std::function<void(femoop::plane::PlaneSupport&)>& command);

} // namespace plane
