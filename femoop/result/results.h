#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/discretisation/statics.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"
#include "femoop/result/curve.h"
#include "femoop/result/magnitudes.h"

namespace femoop {

namespace detail {
struct Solution;
}

/// What one load case or combination does to the structure.
class CaseResult {
public:
    const std::string& name() const;
    NodeVector displacement(NodeId node) const; ///< global axes, rotations in rad
    bool is_supported(NodeId node) const;       ///< has a support, so a reaction
    NodeVector reaction(NodeId node) const;     ///< what the support does to the structure, global axes
    Curve curve(MemberId member) const;         ///< the exact solution along the member
    Magnitudes magnitudes() const;              ///< goes through the whole structure
    /// Of a combination: sums by superposition, the largest residual of its load cases.
    Equilibrium equilibrium() const;

private:
    friend class Results;
    friend class CurveReader;
    CaseResult(std::shared_ptr<const detail::Solution> solution, std::size_t index);
    std::shared_ptr<const detail::Solution> solution_;
    std::size_t index_ = 0;
};

/// The solution of a model: all its load cases, then its combinations. Holds what it needs; the model
/// may change or go.
class Results {
public:
    explicit Results(std::shared_ptr<const detail::Solution> solution);

    AnalysisKind analysis() const;
    std::size_t n_cases() const;
    std::size_t n_members() const;
    std::size_t n_nodes() const;
    CaseResult operator[](CaseId id) const;
    CaseResult at(std::string_view name) const; ///< \throws std::out_of_range naming the cases there are
    MemberGeometry geometry(MemberId member) const;
    const Indeterminacy& indeterminacy() const;
    const std::vector<Fault>& warnings() const; ///< such as FaultKind::NearlySingular

private:
    std::shared_ptr<const detail::Solution> solution_;
};

} // namespace femoop
