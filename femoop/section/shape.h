#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "femoop/model/property.h"

namespace femoop {

/// A shape's dimension: the key it has in a model file and where `SectionShape` keeps it.
struct ShapeDimension {
    std::string_view key;
    std::optional<Quantity> SectionShape::*value = nullptr;
};

std::string_view name(SectionShapeKind kind); ///< "rectangle", "circle", "tube", "box", "i", "t", "l" or "c"
std::span<const SectionShapeKind> section_shape_kinds();
std::span<const ShapeDimension> dimensions(SectionShapeKind kind); ///< those that the kind needs, in the usual order
std::span<const ShapeDimension> shape_dimensions();                ///< those of every kind

/// What is wrong with a dimension of a shape.
enum class ShapeFlaw : std::uint8_t {
    Missing,     ///< the kind needs it
    Unneeded,    ///< the kind has no such dimension
    NotPositive, ///< zero, negative or not finite
    TooLarge     ///< the parts would overlap: `value` must be less than `limit`
};

struct ShapeFault {
    ShapeFlaw flaw = ShapeFlaw::Missing;
    std::string_view key;         ///< the dimension: "tf"
    double value = 0.0;           ///< what was found (NotPositive, TooLarge)
    std::string_view limit_key{}; ///< what it must stay below, as a formula: "h/2" (TooLarge)
    double limit = 0.0;           ///< the value of that formula
};

/// Why the shape cannot be a cross-section; nothing if it can. Tube t < d/2; box t < b/2 and t < h/2;
/// i and c tf < h/2 and tw < bf; t tf < h and tw < bf; l t < b and t < h.
std::optional<ShapeFault> why_not(const SectionShape& shape);

std::string message(const ShapeFault& fault); ///< English: `tf is 0.2, which is not less than h/2 = 0.15`

} // namespace femoop
