#pragma once

#include <cstddef>
#include <variant>

#include "femoop/model/ids.h"

namespace drawing {

/// Places in the lists of a model that femoop itself has no ids for.
struct LoadCasePlace {
    std::size_t load_case = 0;
    friend auto operator<=>(LoadCasePlace, LoadCasePlace) = default;
};
struct CombinationPlace {
    std::size_t combination = 0;
    friend auto operator<=>(CombinationPlace, CombinationPlace) = default;
};
struct NodeLoadPlace {
    std::size_t load_case = 0, load = 0;
    friend auto operator<=>(NodeLoadPlace, NodeLoadPlace) = default;
};
struct SettlementPlace {
    std::size_t load_case = 0, settlement = 0;
    friend auto operator<=>(SettlementPlace, SettlementPlace) = default;
};
struct MemberLoadPlace {
    std::size_t load_case = 0, load = 0;
    friend auto operator<=>(MemberLoadPlace, MemberLoadPlace) = default;
};

/// A dimension line among those that are drawn.
struct DimensionPlace {
    std::size_t dimension = 0;
    friend auto operator<=>(DimensionPlace, DimensionPlace) = default;
};

/// Anything that a picture shows or a document has and that can be selected.
using Part = std::variant<femoop::NodeId, femoop::MemberId, femoop::MaterialId, femoop::SectionId, LoadCasePlace,
                          CombinationPlace, NodeLoadPlace, SettlementPlace, MemberLoadPlace, DimensionPlace>;

} // namespace drawing
