#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "femoop/methods/cross/distribution.h"

namespace femoop::cross {

/// Values by the labels of member ends, as a file lists them.
using Labelled = std::vector<std::pair<std::string, double>>;

/// The `cross` block of a model file: how a sheet is worked, and what it should come to.
struct Block {
    struct Row {
        std::string step; ///< FEM, BAL, CO, TOTAL
        Labelled values;
    };
    /// What holds a sway, or moves in it.
    struct Prop {
        std::optional<std::string> node;          ///< may be left out where there is one sway
        std::optional<Dof> dof;                   ///< ux or uy, in the axes of the node's support
        std::optional<Eigen::Vector2d> direction; ///< in place of `dof`
        std::optional<double> reaction;           ///< force on the structure that follows from the row TOTAL
    };
    /// A sheet of a structure that sways: with its props, or a sway alone.
    struct Stage {
        bool is_propped = false; ///< it names a prop
        std::vector<Prop> props;
        std::optional<Prop> sway; ///< the prop that moves in it; else in the order of the sways
        Labelled fixed_end;
        std::vector<Row> sheet;
        Labelled last;                 ///< `final`: exact, of this stage alone
        std::vector<double> reactions; ///< exact, of every prop; of a sway that of its own prop may stand alone
    };
    std::optional<std::string> load_case, order;
    std::optional<std::size_t> balances;
    std::optional<double> tolerance;
    int digits = 0;
    bool is_modified = false;
    bool is_by_halves = false;                             ///< `symmetry`
    std::vector<std::pair<std::string, Labelled>> factors; ///< joint by joint
    Labelled fixed_end;
    std::vector<Row> sheet;
    double sheet_atol = 1e-6;
    Labelled last; ///< `final`
    double rtol = 1e-6;
    std::vector<Stage> stages;
};

/// Nothing if the model has no such block. \throws ModelError with every place that cannot be read
std::optional<Block> block_of(const Model& model);

/// Joints named in order: "largest", "left-to-right", "all-at-once" or names of joints. \throws ModelError
void set_order(Procedure& procedure, const std::string& order, const Model& model, const Problem& problem);

/// The case, the far ends and the procedure that a block asks for; without a block the first case and the defaults.
CaseId case_of(const Model& model, const std::optional<Block>& block);
FarEnds far_ends_of(const Model& model, CaseId load_case, const Block& block);
Extent extent_of(const std::optional<Block>& block);
Procedure procedure_of(const Model& model, const Problem& problem, const Block& block);

/// Values for every end of a problem; ends that the file leaves out are absent. \throws ModelError (CrossNoSuchEnd)
std::vector<std::pair<EndId, double>> by_end(const Problem& problem, const Labelled& values, const std::string& place);

} // namespace femoop::cross
