#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/element/element_loads.h"
#include "femoop/element/span_load.h"
#include "femoop/load/case_terms.h"
#include "femoop/model/model.h"

namespace femoop {

/// The loads of one load case as numbers, in member axes.
struct CaseLoads {
    struct OnNode {
        NodeId node;
        NodeVector value{};
    };
    struct OnElement {
        std::size_t element; ///< index of Elements
        std::vector<EdgeLoad> edge_loads;
        std::vector<BodyLoad> body_loads;
        std::vector<ThermalLoad> thermal_loads{};

        ElementLoads loads() const
        {
            return {.edge_loads = edge_loads, .body_loads = body_loads, .thermal_loads = thermal_loads};
        }
    };
    std::vector<OnNode> nodes;
    std::vector<OnNode> settlements;  ///< in the support's axes
    std::vector<std::uint32_t> first; ///< of each member's span loads; empty when no member is loaded
    std::vector<SpanLoad> span_loads;
    std::vector<OnElement> elements; ///< loads on elements that are no members

    std::span<const SpanLoad> of(MemberId member) const
    {
        if (first.empty()) return {};
        return std::span(span_loads).subspan(first[member.index], first[member.index + 1] - first[member.index]);
    }
};

std::vector<CaseLoads> loads_of(const Model& model, const Discretisation& structure);

} // namespace femoop
