#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "femoop/element/member_properties.h"
#include "femoop/element/span_load.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

/// A model as numbers: what the analysis needs of nodes and members, in dense arrays and consistent units.
/// Held by the results too, so that they outlive the model.
struct Structure {
    struct MemberRow {
        std::array<NodeId, 2> nodes;
        std::uint32_t properties = 0; ///< index of Structure::properties
        std::int32_t extras = -1;     ///< index of Structure::extras, or -1
    };
    struct SupportRow {
        NodeId node;
        DofSet blocked;
        NodeVector springs{}; ///< 0 where there is none
        double angle = 0.0;   ///< [rad]
    };

    AnalysisKind kind = AnalysisKind::Frame2d;
    std::vector<Eigen::Vector3d> positions;
    std::vector<MemberRow> members;
    std::vector<MemberProperties> properties;
    std::vector<MemberExtras> extras;
    std::vector<Eigen::Vector3d> up; ///< parallel to extras; zero where the default holds
    std::vector<SupportRow> supports;
    std::vector<std::int32_t> support_of_node; ///< index of supports, or -1
    std::vector<bool> is_attached;             ///< does any member meet the node?
    bool has_constraints = false;              ///< any inextensible or rigid member

    MemberFrame frame(MemberId member) const;
    double size() const; ///< diagonal of the box around the nodes; 0 without any
    const MemberProperties& properties_of(MemberId member) const
    {
        return properties[members[member.index].properties];
    }
    const MemberExtras* extras_of(MemberId member) const
    {
        const std::int32_t at = members[member.index].extras;
        return at < 0 ? nullptr : &extras[static_cast<std::size_t>(at)];
    }
    const SupportRow* support_of(NodeId node) const
    {
        const std::int32_t at = support_of_node[node.index];
        return at < 0 ? nullptr : &supports[static_cast<std::size_t>(at)];
    }
};

/// The loads of one load case as numbers, in member axes.
struct CaseLoads {
    struct OnNode {
        NodeId node;
        NodeVector value{};
    };
    std::vector<OnNode> nodes;
    std::vector<OnNode> settlements;  ///< in the support's axes
    std::vector<std::uint32_t> first; ///< of each member's span loads; empty when no member is loaded
    std::vector<SpanLoad> span_loads;

    std::span<const SpanLoad> of(MemberId member) const
    {
        if (first.empty()) return {};
        return std::span(span_loads).subspan(first[member.index], first[member.index + 1] - first[member.index]);
    }
};

/// A load case or combination as a sum of load cases.
struct CaseTerms {
    struct Term {
        std::size_t load_case = 0;
        double factor = 1.0;
    };
    std::string name;
    std::vector<Term> terms;
};

Structure structure_of(const Model& model);
std::vector<CaseLoads> loads_of(const Model& model, const Structure& structure);
std::vector<CaseTerms> cases_of(const Model& model); ///< load cases, then combinations

} // namespace femoop
