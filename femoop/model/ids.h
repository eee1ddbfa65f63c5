#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace femoop {

/// A dense index that cannot be mistaken for another: `NodeId{3}` is the fourth node of a model.
/// Ids stay valid while the list that they index keeps its order; the names that a user types are the `id` strings.
template <class Tag> struct Id {
    std::uint32_t index = 0;

    constexpr Id() = default;
    constexpr explicit Id(std::size_t i) : index(static_cast<std::uint32_t>(i)) {}
    friend constexpr auto operator<=>(Id, Id) = default;
};

using NodeId = Id<struct NodeTag>;
using MaterialId = Id<struct MaterialTag>;
using SectionId = Id<struct SectionTag>;
using MemberId = Id<struct MemberTag>;
using CaseId = Id<struct CaseTag>; ///< load cases first, then combinations, in file order
using PathId = Id<struct PathTag>;
using TrainId = Id<struct TrainTag>;

} // namespace femoop
