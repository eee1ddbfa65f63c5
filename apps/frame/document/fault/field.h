#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "femoop/model/fault/fault.h"
#include "ui/text/message.h"

namespace frame {

/// A field of the panels and tables that stands for a word of the file.
struct Field {
    ui::Message label;   ///< in the panel of properties: "Depth h"
    ui::Message heading; ///< of the column in its table, without its unit
};

/// What is to be filled in or changed so that a fault goes.
struct Remedy {
    std::string list;  ///< as the file calls it: "sections"; "loads" for those of every kind; "" where it is unknown
    std::string id{};  ///< of the entry, where it is not the one that has the fault
    std::string key{}; ///< as the file calls the field: "h", "start spring rz"; "" where it is the part as a whole
};

Remedy remedy_of(const femoop::Fault& fault);

/// Nothing where no table has such a field.
std::optional<Field> field_of(const Remedy& remedy);

/// The label of the field; what the file calls it, where there is none.
ui::Message label_of(const Remedy& remedy);

/// What the app calls a list of the file: "Sections".
std::string_view title_of_list(std::string_view list);

} // namespace frame
