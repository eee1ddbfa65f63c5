#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "femoop/model/load.h"
#include "femoop/plane/model/field.h"
#include "femoop/plane/model/ids.h"

namespace femoop::plane {

enum class CurveLoadKind : std::uint8_t {
    Traction, ///< force per area of the face
    Line,     ///< force per length of the curve
    Pressure  ///< force per area, pushing into the material
};

/// What acts along curves.
struct CurveLoad {
    std::vector<CurveId> curves;
    CurveLoadKind kind = CurveLoadKind::Traction;
    std::optional<Field> qx, qy;      ///< of a traction or a line load
    std::optional<Field> value;       ///< of a pressure
    LoadAxes axes = LoadAxes::Global; ///< local: x along the curve, y to its left

    friend bool operator==(const CurveLoad&, const CurveLoad&) = default;
};

struct BodyForce { ///< force per volume
    std::optional<Field> bx, by;
    friend bool operator==(const BodyForce&, const BodyForce&) = default;
};
struct TemperatureRise {
    std::optional<Field> rise; ///< [K]
    friend bool operator==(const TemperatureRise&, const TemperatureRise&) = default;
};
/// The body turns steadily about a place of the plane, or about the axis of revolution.
struct SteadyRotation {
    Quantity omega;              ///< [rad / time]
    std::vector<Quantity> about; ///< x and y; the origin when empty
    friend bool operator==(const SteadyRotation&, const SteadyRotation&) = default;
};

/// What acts inside regions.
struct RegionLoad {
    std::vector<RegionId> regions; ///< all when empty
    std::variant<BodyForce, TemperatureRise, SteadyRotation> load;

    friend bool operator==(const RegionLoad&, const RegionLoad&) = default;
};

/// Imposed displacements of blocked or sprung directions of points or curves, in the axes of their support.
struct PlaneSettlement {
    std::optional<NodeId> point;
    std::vector<CurveId> curves;
    std::optional<Field> ux, uy;

    friend bool operator==(const PlaneSettlement&, const PlaneSettlement&) = default;
};

struct PlaneLoadCase {
    std::string id;
    double self_weight = 0.0;     ///< factor on density x gravity, along -y
    std::vector<NodeLoad> points; ///< forces on points
    std::vector<CurveLoad> curves;
    std::vector<RegionLoad> regions;
    std::vector<PlaneSettlement> settlements;

    friend bool operator==(const PlaneLoadCase&, const PlaneLoadCase&) = default;
};

} // namespace femoop::plane
