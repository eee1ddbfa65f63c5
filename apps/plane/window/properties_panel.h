#pragma once

#include <vector>

#include "apps/plane/document/number.h"
#include "apps/plane/document/rename.h"
#include "apps/plane/session/commands.h"
#include "ui/widgets/number_field.h"

namespace plane {

/// What is selected, with everything that can be given to it.
void properties_panel(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields);

/// The name of an entry, which can be typed.
void name_row(Workspace& workspace, ui::NumberFields& fields, const Named& entry);
/// A row for each number; what is typed and dragged there changes the document, in a step named after whose it is.
void number_rows(Workspace& workspace, ui::NumberFields& fields, const ui::Message& whose,
                 const std::vector<Number>& all);

/// The numbers of the case that is shown: the factor of self-weight of a load case, the factors of a combination.
void case_number_rows(Workspace& workspace, ui::NumberFields& fields);

/// A number as its field shows it: with its unit in the label, rounded, and as it is edited.
struct ShownNumber {
    std::string label, text, exact;
    std::optional<double> value; ///< in the unit shown
};
ShownNumber shown(const Session& session, const Number& number);
/// What was typed or dragged in the field of a number.
void take_number(Workspace& workspace, ui::NumberFields& fields, const ui::Message& whose, const Number& number,
                 const ui::NumberFieldEvent& event);

} // namespace plane
