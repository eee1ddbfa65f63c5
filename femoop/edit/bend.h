#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"

namespace femoop {

enum class BendCurve : std::uint8_t { Arc, Parabola };

/// What a straight member becomes: a curve of straight parts through its ends.
struct Bend {
    BendCurve curve = BendCurve::Arc;
    double rise = 0.0; ///< of the curve's middle over the chord; negative to the other side
    std::size_t n_parts = 12;
};

inline constexpr std::size_t least_bend_parts = 2, most_bend_parts = 200;

/// The least rise that bends a member, a millionth of its length: below it the model is what it would be without.
double least_bend_rise(const Model& model, MemberId member);

/// Why a rise of 0, or of next to nothing, bends nothing.
inline constexpr std::string_view no_rise = translatable(
    "such a rise leaves the member straight; give a greater one, negative to the other side");

/// The nodes and members that were one member, from its first end to its last.
struct BentMember {
    std::vector<NodeId> nodes; ///< between the ends
    std::vector<MemberId> members;
};

/// Bends a member into an arc of a circle or a parabola, as a chain of straight members whose nodes lie on the curve:
///
///                              o--o--o        -
///       A o---------o B  ->   o       o       | rise
///                          A o         o B    -
///
/// A parabola's nodes stand at equal distances along the chord, those of an arc along the curve. The curve lies in the
/// plane of the structure, to the left of the way from the first end to the last; in space in the plane of the local
/// axes x and y, to the side of y. What the member bears follows, by its share of the length, as `split_member` cuts
/// it: a load per length of the member acts per length of the parts, a projected one per projected length still.
/// Releases, springs and offsets stay at the outer ends.
///
/// \pre    no truss, whose chain of bars would move; the member has a length
/// \throws std::invalid_argument, with the model as it was, for a rise below the least one or no number, too few or many
///         parts
BentMember bend_member(Model& model, MemberId member, const Bend& bend);

} // namespace femoop
