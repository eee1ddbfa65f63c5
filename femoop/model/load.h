#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "femoop/model/component.h"
#include "femoop/model/dof.h"
#include "femoop/model/ids.h"
#include "femoop/model/quantity/quantity.h"

namespace femoop {

/// Forces and moments on a node, global axes.
struct NodeLoad {
    NodeId node;
    std::vector<Component> components;

    friend bool operator==(const NodeLoad&, const NodeLoad&) = default;
};

/// Imposed displacements of blocked or sprung degrees of freedom, in the support's axes; rotations in rad.
struct Settlement {
    NodeId node;
    std::vector<Component> components;

    friend bool operator==(const Settlement&, const Settlement&) = default;
};

/// A place along a member: a length from its first end, or a percentage of its length ("50%").
struct Percent {
    double value = 0.0;
    friend bool operator==(const Percent&, const Percent&) = default;
};
using Position = std::variant<Quantity, Percent>;

enum class LoadAxes : std::uint8_t { Global, Local };

/// Load per unit length that varies linearly from `from` to `to`.
struct DistributedLoad {
    struct Value {
        Dof dof = Dof::uy;
        Quantity start;              ///< value at `from`
        std::optional<Quantity> end; ///< value at `to`; the same as start when absent
        friend bool operator==(const Value&, const Value&) = default;
    };
    std::vector<Value> values;
    std::optional<Position> from, to; ///< the whole member when absent
    LoadAxes axes = LoadAxes::Global;
    bool projected = false; ///< per unit of the length projected square to each component; global axes only

    friend bool operator==(const DistributedLoad&, const DistributedLoad&) = default;
};

/// Concentrated forces and moments at a place inside the member.
struct PointLoad {
    Position at;
    std::vector<Component> components;
    LoadAxes axes = LoadAxes::Global;

    friend bool operator==(const PointLoad&, const PointLoad&) = default;
};

/// Forces and moments on the member's own ends, inside its releases and springs.
struct EndLoads {
    std::vector<Component> start, end;
    LoadAxes axes = LoadAxes::Global;

    friend bool operator==(const EndLoads&, const EndLoads&) = default;
};

/// Rise of temperature at the +y' and -y' fibres, linear between them [K].
struct TemperatureLoad {
    Quantity top, bottom;

    friend bool operator==(const TemperatureLoad&, const TemperatureLoad&) = default;
};

/// A member built too long by `elongation` (too short if negative).
struct Misfit {
    Quantity elongation;

    friend bool operator==(const Misfit&, const Misfit&) = default;
};

/// A load on a member; several on one member add up.
struct MemberLoad {
    MemberId member;
    std::variant<DistributedLoad, PointLoad, EndLoads, TemperatureLoad, Misfit> load;

    friend bool operator==(const MemberLoad&, const MemberLoad&) = default;
};

/// Loads that act together.
struct LoadCase {
    std::string id;
    double self_weight = 0.0; ///< factor on density x gravity x A, down: -y in plane models, -z otherwise
    std::vector<NodeLoad> nodes;
    std::vector<Settlement> settlements;
    std::vector<MemberLoad> members;

    friend bool operator==(const LoadCase&, const LoadCase&) = default;
};

/// A weighted sum of load cases and of other combinations (no circles).
struct Combination {
    struct Term {
        CaseId of;
        double factor = 1.0;
        friend bool operator==(const Term&, const Term&) = default;
    };
    std::string id;
    std::vector<Term> terms;

    friend bool operator==(const Combination&, const Combination&) = default;
};

} // namespace femoop
