#pragma once

#include "apps/drawing/show.h"
#include "femoop/result/results.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace drawing {

/// The results of the case that is drawn, with the exact solution of every member at hand.
class SolvedCase {
public:
    explicit SolvedCase(femoop::CaseResult of_case) : result(std::move(of_case)) {}

    femoop::CaseResult result;
    std::vector<femoop::Curve> curves;         ///< of the members
    std::vector<femoop::NodeVector> reactions; ///< of the supports

    const femoop::Curve& operator[](femoop::MemberId member) const { return curves[member.index]; }
    /// The largest absolute value of a section force in the whole structure, rounding included.
    double largest(femoop::MemberComponent component) const;

private:
    mutable std::array<std::optional<double>, femoop::n_member_components> largest_{}; ///< each when first asked for
};

/// Nothing when the results lack the case.
std::optional<SolvedCase> solved_case(const femoop::Results& results, femoop::CaseId id);

/// The section forces that a request means for a kind of model: M is Mz in the plane, My and Mz in space. Those that
/// the model lacks are left out.
std::vector<femoop::MemberComponent> components(Show item, femoop::AnalysisKind kind);

/// The section forces whose diagrams are asked for, each once, in the order in which they are drawn.
std::vector<femoop::MemberComponent> shown_components(const ShowSet& show, femoop::AnalysisKind kind);

/// The largest absolute value of a section force in the whole structure; 0 where it is nothing but rounding beside the
/// other forces and the reactions, moments being compared with forces times `size`, the structure's.
double largest_value(const SolvedCase& solved, femoop::MemberComponent component, double size);

/// 1, 2 or 5 times a power of ten, not above the value. \pre value > 0 and finite.
double round_below(double value);

} // namespace drawing
