#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "femoop/model/component.h"
#include "femoop/model/dof.h"
#include "femoop/model/expected.h"
#include "femoop/model/ids.h"
#include "femoop/model/load.h"
#include "femoop/model/quantity/quantity.h"

namespace femoop {

/// Members that loads move along: each begins at the node where the one before ended, whatever its own direction.
struct LoadPath {
    std::string id;
    std::vector<MemberId> members;

    friend bool operator==(const LoadPath&, const LoadPath&) = default;
};

/// One of the model's paths, or its members spelled out.
using LoadPathReference = std::variant<PathId, std::vector<MemberId>>;

/// What a moving load is asked for: a displacement or a reaction of a node, or what can be read along a member; without
/// a place the largest along it.
struct MovingEffect {
    ExpectedQuantity quantity = ExpectedQuantity::SectionForce; ///< Displacement, Reaction, SectionForce or Extreme
    std::optional<NodeId> node;
    std::optional<Dof> dof;
    std::optional<MemberId> member;
    std::optional<MemberComponent> component;
    std::optional<Position> at;
    std::optional<Side> side;

    friend bool operator==(const MovingEffect&, const MovingEffect&) = default;
};

/// The size of a reaction in the plane: both of its force components are one. It is derived; no load moves for it.
inline bool is_resultant(const MovingEffect& effect)
{
    return effect.quantity == ExpectedQuantity::Reaction && effect.node && !effect.dof;
}

/// An influence line that the model asks for.
struct InfluenceLineDefinition {
    std::string id;
    LoadPathReference path;
    MovingEffect effect;
    std::vector<Component> load; ///< the unit load or couple, global axes; none: down

    friend bool operator==(const InfluenceLineDefinition&, const InfluenceLineDefinition&) = default;
};

/// Where a train's uniform load lies.
enum class UniformExtent : std::uint8_t {
    Adverse,    ///< on every part of the path where it makes the effect worse
    WholeSpans, ///< on those whole members of the path where it does
    Everywhere, ///< on the whole path, always
    Outside     ///< as Adverse, but not from `gap` behind the last axle to `gap` before the leading one
};

/// A distance between two axles that may have any value of a range.
struct SpacingRange {
    std::size_t spacing = 0; ///< counted from 0, behind the leading axle
    Quantity min, max;

    friend bool operator==(const SpacingRange&, const SpacingRange&) = default;
};

/// A force that stands once, where it is worst: of one size for moments, and of another for all else where there is one.
struct ConcentratedForce {
    Quantity for_moments;
    std::optional<Quantity> for_others;

    friend bool operator==(const ConcentratedForce&, const ConcentratedForce&) = default;
};

/// Axles at fixed distances, a uniform load and single forces that move along a path.
struct Train {
    std::string id;
    LoadPathReference path;
    std::vector<Quantity> axles;    ///< along `load`, from the leading one
    std::vector<Quantity> spacings; ///< behind each axle but the last
    std::vector<SpacingRange> spacing_ranges;
    bool both_directions = false;
    double impact = 1.0;             ///< on the axles alone
    std::optional<Quantity> uniform; ///< per length of path
    UniformExtent uniform_extent = UniformExtent::Adverse;
    std::optional<Quantity> gap; ///< 0 when absent
    std::vector<ConcentratedForce> concentrated;
    std::vector<Component> load; ///< the direction of a unit, global axes; none: down

    friend bool operator==(const Train&, const Train&) = default;
};

/// The worst of some trains, never two together, times a factor, beside a case that stays.
struct MovingEnvelope {
    std::string id;
    std::vector<TrainId> trains;
    std::optional<CaseId> with;
    double factor = 1.0;

    friend bool operator==(const MovingEnvelope&, const MovingEnvelope&) = default;
};

/// What moves over a structure, and what is asked of it. Ids are unique in each list.
struct MovingLoads {
    std::vector<LoadPath> paths;
    std::vector<InfluenceLineDefinition> influence_lines;
    std::vector<Train> trains;
    std::vector<MovingEnvelope> envelopes;

    friend bool operator==(const MovingLoads&, const MovingLoads&) = default;
};

} // namespace femoop
