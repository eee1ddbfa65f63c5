#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "femoop/analysis/assembler.h"
#include "femoop/analysis/unrestrained_rotation.h"

namespace femoop {

/// Which restrained rotations loads drive.
///
///      A o=======B=======o C      what loads do about the line A-C spins the chain; what bends it does not
///
/// Accuracy  a moment counts when it is more than 1e-9 of those that come to its nodes, before they cancel and whether
///           a support takes them or not: what is left of moments square to the axis is rounding
class DrivenRotations {
public:
    /// F: the load vectors [unknowns x cases]. They must live as long as this.
    DrivenRotations(const Assembler& assembler, const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F)
        : assembler_(assembler), loads_(loads), F_(F)
    {}

    bool contains(const ArtificialRestraint& rotation);

private:
    bool is_driven(const ArtificialRestraint& rotation, std::size_t load_case);
    const std::vector<double>& moments_at_nodes(std::size_t load_case);

    const Assembler& assembler_;
    const std::vector<CaseLoads>& loads_;
    const Eigen::MatrixXd& F_;
    std::vector<std::vector<double>> moments_; ///< of each case and node; added up when first asked for
};

} // namespace femoop
