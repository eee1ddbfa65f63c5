#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/plane/document/attributes.h"
#include "apps/plane/document/number.h"
#include "apps/plane/session/commands.h"

namespace plane {

/// What can be given to what is selected: supports, holes, loads; cases and the kind of analysis.
void add_part_commands(CommandTable& table);

/// "Curve C3", "Region R1", "Face without a region".
ui::Message title(const Session& session, const Part& part);
/// The same of one part; of several "3 curves", or "Selected: 5" where they are of different kinds. \pre there are parts
ui::Message title(const Session& session, const std::vector<Part>& parts);
ui::Message title(const Session& session, femoop::CaseId id); ///< "Load case G", "Combination C"

/// The numbers of a part, without those of its loads.
std::vector<Number> numbers_of(const Session& session, const Part& part);
/// Those that all parts have, where they are of one kind.
std::vector<Number> numbers_of(const Session& session, const std::vector<Part>& parts);

/// The parts, if all of them are of this kind.
template <class Kind> std::vector<Kind> all_of_kind(const std::vector<Part>& parts)
{
    std::vector<Kind> all;
    for (const Part& part : parts) {
        if (!std::holds_alternative<Kind>(part)) return {};
        all.push_back(std::get<Kind>(part));
    }
    return all;
}

/// The numbers of a load of the case that is shown, which all of these curves or regions have.
template <class Id>
std::vector<Number> numbers_of_load(const Session& session, const std::vector<Id>& holders, const LoadPlaces& places)
{
    std::vector<std::vector<Number>> each;
    for (std::size_t i = 0; i < holders.size(); ++i)
        each.push_back(numbers(session.model(), session.load_case, places[i], holders[i]));
    return numbers_of_all(each);
}

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
/// Changes the supports of the object form that the parts have.
void change_supports(Workspace& workspace, const std::vector<Part>& parts, const ui::Message& label,
                     const std::function<void(femoop::plane::PlaneSupport&)>& command);

} // namespace plane
