#include "femoop/section/shape.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace femoop {

namespace {

constexpr ShapeDimension dim_b{"b", &SectionShape::b};
constexpr ShapeDimension dim_h{"h", &SectionShape::h};
constexpr ShapeDimension dim_d{"d", &SectionShape::d};
constexpr ShapeDimension dim_t{"t", &SectionShape::t};
constexpr ShapeDimension dim_bf{"bf", &SectionShape::bf};
constexpr ShapeDimension dim_tf{"tf", &SectionShape::tf};
constexpr ShapeDimension dim_tw{"tw", &SectionShape::tw};

constexpr std::array all{dim_b, dim_h, dim_d, dim_t, dim_bf, dim_tf, dim_tw};
constexpr std::array sizes_of_rectangle{dim_b, dim_h};
constexpr std::array sizes_of_circle{dim_d};
constexpr std::array sizes_of_tube{dim_d, dim_t};
constexpr std::array sizes_of_box{dim_b, dim_h, dim_t};
constexpr std::array sizes_of_flanged{dim_h, dim_bf, dim_tf, dim_tw};
constexpr std::array sizes_of_angle{dim_h, dim_b, dim_t};

constexpr std::array kinds{SectionShapeKind::Rectangle, SectionShapeKind::Circle, SectionShapeKind::Tube,
                           SectionShapeKind::Box,       SectionShapeKind::I,      SectionShapeKind::T,
                           SectionShapeKind::L,         SectionShapeKind::C};
constexpr std::array<std::string_view, kinds.size()> kind_names{"rectangle", "circle", "tube", "box",
                                                                "i",         "t",      "l",    "c"};

/// `small` must be less than `large` / `divisor`.
struct Limit {
    ShapeDimension small;
    ShapeDimension large;
    double divisor;
    std::string_view formula;
};
constexpr std::array limits_of_tube{Limit{dim_t, dim_d, 2.0, "d/2"}};
constexpr std::array limits_of_box{Limit{dim_t, dim_b, 2.0, "b/2"}, Limit{dim_t, dim_h, 2.0, "h/2"}};
constexpr std::array limits_of_i{Limit{dim_tf, dim_h, 2.0, "h/2"}, Limit{dim_tw, dim_bf, 1.0, "bf"}};
constexpr std::array limits_of_t{Limit{dim_tf, dim_h, 1.0, "h"}, Limit{dim_tw, dim_bf, 1.0, "bf"}};
constexpr std::array limits_of_l{Limit{dim_t, dim_b, 1.0, "b"}, Limit{dim_t, dim_h, 1.0, "h"}};

std::span<const Limit> limits(SectionShapeKind kind)
{
    switch (kind) {
    case SectionShapeKind::Tube: return limits_of_tube;
    case SectionShapeKind::Box: return limits_of_box;
    case SectionShapeKind::I:
    case SectionShapeKind::C: return limits_of_i;
    case SectionShapeKind::T: return limits_of_t;
    case SectionShapeKind::L: return limits_of_l;
    case SectionShapeKind::Rectangle:
    case SectionShapeKind::Circle: break;
    }
    return {};
}

bool needs(SectionShapeKind kind, std::string_view key)
{
    for (const ShapeDimension& dimension : dimensions(kind))
        if (dimension.key == key) return true;
    return false;
}

} // namespace

std::string_view name(SectionShapeKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::span<const SectionShapeKind> section_shape_kinds() { return kinds; }

std::span<const ShapeDimension> shape_dimensions() { return all; }

std::span<const ShapeDimension> dimensions(SectionShapeKind kind)
{
    switch (kind) {
    case SectionShapeKind::Rectangle: return sizes_of_rectangle;
    case SectionShapeKind::Circle: return sizes_of_circle;
    case SectionShapeKind::Tube: return sizes_of_tube;
    case SectionShapeKind::Box: return sizes_of_box;
    case SectionShapeKind::L: return sizes_of_angle;
    case SectionShapeKind::I:
    case SectionShapeKind::T:
    case SectionShapeKind::C: break;
    }
    return sizes_of_flanged;
}

std::optional<ShapeFault> why_not(const SectionShape& shape)
{
    for (const ShapeDimension& dimension : all) {
        const std::optional<Quantity>& value = shape.*dimension.value;
        const bool needed = needs(shape.kind, dimension.key);
        if (needed && !value) return ShapeFault{.flaw = ShapeFlaw::Missing, .key = dimension.key};
        if (!needed && value) return ShapeFault{.flaw = ShapeFlaw::Unneeded, .key = dimension.key};
        if (needed && !(std::isfinite(value->value()) && value->value() > 0.0))
            return ShapeFault{.flaw = ShapeFlaw::NotPositive, .key = dimension.key, .value = value->value()};
    }
    for (const Limit& limit : limits(shape.kind)) {
        const double value = (shape.*limit.small.value)->value();
        const double largest = (shape.*limit.large.value)->value() / limit.divisor;
        if (!(value < largest))
            return ShapeFault{.flaw = ShapeFlaw::TooLarge,
                              .key = limit.small.key,
                              .value = value,
                              .limit_key = limit.formula,
                              .limit = largest};
    }
    return std::nullopt;
}

std::string message(const ShapeFault& fault)
{
    std::ostringstream text;
    text << fault.key;
    switch (fault.flaw) {
    case ShapeFlaw::Missing: text << " is missing"; break;
    case ShapeFlaw::Unneeded: text << " is no dimension of this shape"; break;
    case ShapeFlaw::NotPositive: text << " is " << fault.value << ", which is not a positive length"; break;
    case ShapeFlaw::TooLarge:
        text << " is " << fault.value << ", which is not less than " << fault.limit_key << " = " << fault.limit;
        break;
    }
    return text.str();
}

} // namespace femoop
