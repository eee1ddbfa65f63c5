#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "femoop/model/dof.h"
#include "femoop/model/fault/fault.h"

namespace femoop {

/// One way in which a structure moves without strain.
struct Mechanism {
    Fault fault;                    ///< the motion in words, with a remedy
    std::vector<NodeVector> motion; ///< of every node, global axes; the largest translation (else rotation) is 1
    std::vector<std::array<Eigen::Vector3d, 2>> member_ends; ///< translations of every member's own two ends
};

/// The motion in words alone: what mends a structure does not help where forces were released. \param sentence  of its
/// fault
std::string without_remedy(const std::string& sentence);

/// A structure that can move cannot be solved: its independent mechanisms. Of very many only the first are described.
/// Where it is not held as a rigid body, that is said first.
class MechanismError : public ModelError {
public:
    explicit MechanismError(std::vector<Mechanism> mechanisms, std::size_t n_more = 0, std::vector<Fault> causes = {});
    const std::vector<Mechanism>& mechanisms() const { return mechanisms_; }
    std::size_t n_more() const { return n_more_; } ///< at least so many more were found
    const std::vector<Fault>& causes() const { return causes_; }

private:
    std::vector<Mechanism> mechanisms_;
    std::size_t n_more_;
    std::vector<Fault> causes_;
};

} // namespace femoop
