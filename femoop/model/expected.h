#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "femoop/model/dof.h"
#include "femoop/model/ids.h"
#include "femoop/model/load.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/quantity.h"

namespace femoop {

enum class ExpectedAnalysis : std::uint8_t { Linear, PDelta, Buckling, Modal, Plastic };
enum class ExpectedQuantity : std::uint8_t {
    Displacement,
    Reaction,
    SectionForce,
    Extreme,
    LoadFactor,
    Frequency,
    CollapseFactor
};

/// What can be read along a member: section forces, then local displacements.
/// In plane models and grillages V is Vy and M is Mz.
enum class MemberComponent : std::uint8_t { N, Vy, Vz, T, My, Mz, u, v, w };

inline constexpr std::size_t n_member_components = 9;
inline constexpr std::array<MemberComponent, n_member_components> all_member_components{
    MemberComponent::N,  MemberComponent::Vy, MemberComponent::Vz, MemberComponent::T, MemberComponent::My,
    MemberComponent::Mz, MemberComponent::u,  MemberComponent::v,  MemberComponent::w};

/// The name that files and tables use: N V M u v in plane models, V M T v in grillages, N Vy Vz T My Mz u v w in 3D;
/// "" for a component that the model lacks.
std::string_view name(MemberComponent component, AnalysisKind kind);
std::optional<MemberComponent> find_member_component(std::string_view name, AnalysisKind kind);

enum class Side : std::uint8_t { Before, After }; ///< of a jump: the - side and the + side
enum class ExtremeKind : std::uint8_t { Max, Min };

/// One check of a verification case: a result, its value and how near is near enough.
struct Expected {
    ExpectedAnalysis analysis = ExpectedAnalysis::Linear;
    ExpectedQuantity quantity = ExpectedQuantity::Displacement;
    std::optional<CaseId> load_case;
    std::optional<NodeId> node;
    std::optional<Dof> dof;
    std::optional<MemberId> member;
    std::optional<MemberComponent> component;
    std::optional<Position> at;
    std::optional<Side> side;
    std::optional<ExtremeKind> extreme;
    std::optional<int> mode; ///< `which` of a load factor or a frequency, from 1
    Quantity value;
    std::optional<double> rtol;   ///< 1e-6 when absent
    std::optional<Quantity> atol; ///< 0 when absent
    std::string source;

    friend bool operator==(const Expected&, const Expected&) = default;
};

Dimension dimension_of(const Expected& check); ///< of its value

} // namespace femoop
