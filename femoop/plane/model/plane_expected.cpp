#include "femoop/plane/model/plane_expected.h"

namespace femoop::plane {

namespace {

using enum PlaneComponent;

constexpr std::array<std::string_view, 10> quantity_names{"displacement", "stress", "strain",    "extreme", "reaction",
                                                          "resultant",    "energy", "frequency", "count",   "area"};
constexpr std::array<std::string_view, 26> component_names{
    "ux", "uy", "ur",  "ut", "sx", "sy", "sz",  "txy", "s1", "s2", "tmax", "mises", "tresca",
    "sr", "st", "trt", "ex", "ey", "ez", "gxy", "fx",  "fy", "mz", "N",    "V",     "M"};

Dimension dimension_of(PlaneComponent component)
{
    if (component <= ut) return dimension::length;
    if (component <= trt) return dimension::stress;
    if (component <= gxy) return dimension::none;
    return component == mz || component == M ? dimension::moment : dimension::force;
}

} // namespace

std::string_view name(PlaneQuantity quantity) { return quantity_names[static_cast<std::size_t>(quantity)]; }
std::string_view name(PlaneComponent component) { return component_names[static_cast<std::size_t>(component)]; }

std::vector<PlaneComponent> components_of(PlaneQuantity quantity)
{
    switch (quantity) {
    case PlaneQuantity::Displacement: return {ux, uy, ur, ut};
    case PlaneQuantity::Stress:
    case PlaneQuantity::Extreme: return {sx, sy, sz, txy, s1, s2, tmax, Mises, Tresca, sr, st, trt};
    case PlaneQuantity::Strain: return {ex, ey, ez, gxy};
    case PlaneQuantity::Reaction: return {fx, fy, mz};
    case PlaneQuantity::Resultant: return {N, V, M};
    default: return {};
    }
}

Dimension dimension_of(const PlaneExpected& check)
{
    switch (check.quantity) {
    case PlaneQuantity::Energy: return dimension::moment;
    case PlaneQuantity::Frequency: return dimension::frequency;
    case PlaneQuantity::Count: return dimension::none;
    case PlaneQuantity::Area: return dimension::area;
    default: return check.component ? dimension_of(*check.component) : dimension::none;
    }
}

} // namespace femoop::plane
