#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/expected.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/plane/model/ids.h"

namespace femoop::plane {

enum class PlaneQuantity : std::uint8_t {
    Displacement,
    Stress,
    Strain,
    Extreme,
    Reaction,
    Resultant,
    Energy,
    Frequency,
    Count,
    Area
};

/// What a check reads, of all quantities.
///
///      ux uy   ur ut about a place       sx sy sz txy   s1 >= s2 in the plane   tmax = (s1 - s2) / 2   mises tresca
///      ex ey ez gxy                      sr st trt about a place                fx fy mz               N V M
enum class PlaneComponent : std::uint8_t {
    ux,
    uy,
    ur,
    ut,
    sx,
    sy,
    sz,
    txy,
    s1,
    s2,
    tmax,
    Mises,
    Tresca,
    sr,
    st,
    trt,
    ex,
    ey,
    ez,
    gxy,
    fx,
    fy,
    mz,
    N,
    V,
    M
};

std::string_view name(PlaneQuantity quantity);
std::string_view name(PlaneComponent component);
/// The components that a quantity has; none of an energy.
std::vector<PlaneComponent> components_of(PlaneQuantity quantity);

enum class StressReading : std::uint8_t {
    Smoothed, ///< recovered in patches of elements
    Element,  ///< of the element that holds the place
    Gauss     ///< at integration points
};

/// One check of a verification case: a result, its value and how near is near enough.
struct PlaneExpected {
    ExpectedAnalysis analysis = ExpectedAnalysis::Linear;
    PlaneQuantity quantity = PlaneQuantity::Displacement;
    std::optional<CaseId> load_case;
    std::optional<PlaneComponent> component;
    std::optional<NodeId> point;
    std::optional<CurveId> curve;
    std::optional<RegionId> region;
    std::vector<Quantity> at;    ///< x and y, or empty
    std::vector<Quantity> about; ///< x and y; the origin when empty
    std::vector<Quantity> cut;   ///< x1 y1 x2 y2, or empty
    std::optional<StressReading> read;
    std::optional<ExtremeKind> extreme;
    std::optional<int> rank; ///< `which` of a frequency or an area, from 1
    std::string counted;     ///< the component of a count
    Quantity value;
    std::optional<double> rtol;   ///< 1e-6 when absent
    std::optional<Quantity> atol; ///< 0 when absent
    std::string source;

    friend bool operator==(const PlaneExpected&, const PlaneExpected&) = default;
};

Dimension dimension_of(const PlaneExpected& check); ///< of its value

} // namespace femoop::plane
