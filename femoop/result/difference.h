#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

enum class ComparedQuantity : std::uint8_t { SectionForce, Reaction, Displacement };

/// One case of a model with its results.
struct ComparedCase {
    const Model* model; ///< not null
    CaseResult result;
};

/// What a node or a member of the present structure has, and what that of the same name had before.
struct Difference {
    ComparedQuantity quantity = ComparedQuantity::SectionForce;
    std::variant<NodeId, MemberId> part;
    std::variant<Dof, MemberComponent> component;
    double now = 0.0;
    std::optional<double> then{};  ///< absent where there was no such part, or no support there
    std::optional<double> share{}; ///< of a section force: the section, as a share of the member's length
    bool is_as_long = true; ///< of a section force: the member was as long, so that the section stood where it does
    double size = 0.0;      ///< of such values: what is rounding beside it is no change

    std::optional<double> change() const
    {
        return then ? std::optional(without_rounding(now - *then, size)) : std::nullopt;
    }
};

/// Section forces of every member, then reactions of every support, then displacements of every node, in the order of the
/// present model; 0 where a value is nothing but rounding. Section forces are held against each other at one section: of
/// the ends and those where either is largest or smallest, where they differ most. None where the two are of different
/// analyses. Each is found when it is asked for.
class Differences {
public:
    /// Both models outlive it.
    Differences(const ComparedCase& now, const ComparedCase& then);

    std::size_t size() const;
    Difference operator[](std::size_t place) const; ///< \pre place < size()

private:
    Difference force(MemberId member, MemberComponent component) const;
    Difference reaction(NodeId node, Dof dof) const;
    Difference displacement(NodeId node, Dof dof) const;

    ComparedCase now_, then_;
    Magnitudes now_sizes_, then_sizes_;
    std::vector<MemberComponent> components_;
    std::vector<Dof> dofs_;
    std::vector<NodeId> supported_;
};

} // namespace femoop
