#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/drawing/quantity_typed.h"
#include "apps/frame/document/document.h"
#include "apps/frame/document/part.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/quantity.h"
#include "ui/text/display_units.h"
#include "ui/text/message.h"

namespace frame {

/// Names one number of a document: a part of it, and the number's place among those of the part.
struct NumberId {
    Part part;
    std::size_t place = 0;

    friend bool operator==(const NumberId&, const NumberId&) = default;
};

enum class Need { Required, Optional };

/// A number that the user may change: a coordinate, a modulus, the value of a load.
struct Number {
    NumberId id;
    ui::Message label; ///< without its unit
    ui::Measure measure = ui::Measure::Plain;
    Need presence = Need::Required;
    std::optional<femoop::Quantity> value; ///< absent where the file says nothing, such as a shear modulus
};

/// All the numbers of a part, in the order in which a person would ask for them. \pre has(model, part)
std::vector<Number> numbers(const femoop::Model& model, const Part& part);

/// One number that several parts have in common, such as the x of three nodes.
struct SharedNumber {
    Number of_first;
    std::vector<NumberId> ids; ///< of each part
    bool is_mixed = false;     ///< the parts have different values
};

/// The numbers that all of the parts have. \pre every part is there, and all are of one kind
std::vector<SharedNumber> shared_numbers(const femoop::Model& model, std::span<const Part> parts);

/// The command behind every number field. \throws std::out_of_range if the document has no such number.
void set_number(Document& document, const NumberId& number, const femoop::Quantity& value);
/// Takes an optional number away. \throws std::out_of_range; std::invalid_argument where it is required.
void clear_number(Document& document, const NumberId& number);

using drawing::base_units;
using drawing::quantity_typed;

} // namespace frame
