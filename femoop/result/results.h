#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"
#include "femoop/result/curve.h"

namespace femoop {

/// One number per degree of freedom ux uy uz rx ry rz (or force fx fy fz mx my mz); those that the model lacks are 0.
using NodeVector = std::array<double, n_dofs>;

/// How many more forces there are than equations of equilibrium to find them.
///
/// total = external + internal; 0 is statically determinate. Springs and settlements count as supports.
/// Source  [Kassimali, ch. 3] for `external` (reactions less the equations of the whole),
///         `total` from the rank of the equilibrium equations of all nodes.
struct Indeterminacy {
    int external = 0;
    int internal = 0;
    bool has_foundation = false; ///< a continuous foundation makes the true number infinite: the two leave it out
    int total() const { return external + internal; }
};

/// Equilibrium of the structure as a whole, and of its worst node.
struct Equilibrium {
    double residual = 0.0;      ///< largest out-of-balance force over the largest load
    NodeVector sum_loads{};     ///< moments about the origin
    NodeVector sum_reactions{}; ///< supports, springs and foundations
};

/// How large the numbers of a case are, those that cancel included (what heat would do to members that cannot give
/// way), and what the structure's size makes of one kind out of the other. A number far below is nothing but rounding.
struct Magnitudes {
    double force = 0.0;
    double moment = 0.0;
    double displacement = 0.0;
    double rotation = 0.0;
};

struct MemberFrame {
    Eigen::Matrix3d axes;  ///< rows x' y' z' in global axes
    Eigen::Vector3d start; ///< first end of the flexible part
    Eigen::Vector3d end;   ///< its second end
    double length = 0.0;
};

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

/// The solution of a model: all its load cases, then its combinations. Holds what it needs; the model may change or go.
class Results {
public:
    explicit Results(std::shared_ptr<const detail::Solution> solution);

    AnalysisKind analysis() const;
    std::size_t n_cases() const;
    std::size_t n_members() const;
    std::size_t n_nodes() const;
    CaseResult operator[](CaseId id) const;
    CaseResult at(std::string_view name) const; ///< \throws std::out_of_range naming the cases there are
    MemberFrame frame(MemberId member) const;
    const Indeterminacy& indeterminacy() const;
    const std::vector<Fault>& warnings() const; ///< such as FaultKind::NearlySingular

private:
    std::shared_ptr<const detail::Solution> solution_;
};

} // namespace femoop
