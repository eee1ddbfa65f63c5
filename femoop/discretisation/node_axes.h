#pragma once

#include <cstddef>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/element/element.h"

namespace femoop {

/// The axes that the nodes' displacements are counted in: global ones, but turned by its angle at an inclined support.
///
///      u global = R u node        R turns ux and uy by the support's angle, counter-clockwise
class NodeAxes {
public:
    explicit NodeAxes(const Discretisation& structure);

    bool are_turned() const { return !turns_.empty(); } ///< any
    bool are_turned(NodeId node) const { return are_turned() && turns_[node.index].sine != 0.0; }
    bool are_turned(const ElementDofs& dofs) const;

    /// The columns of a matrix over an element's degrees of freedom, from global axes to its nodes': M R.
    template <class Matrix> void turn_columns(const ElementDofs& dofs, Matrix& M) const
    {
        visit(dofs, [&](const Turn& turn, Eigen::Index x, Eigen::Index y) {
            for (Eigen::Index i = 0; i < M.rows(); ++i) turn_back(turn, M(i, x), M(i, y));
        });
    }
    /// The same of its rows: R' M.
    template <class Matrix> void turn_rows(const ElementDofs& dofs, Matrix& M) const
    {
        visit(dofs, [&](const Turn& turn, Eigen::Index x, Eigen::Index y) {
            for (Eigen::Index j = 0; j < M.cols(); ++j) turn_back(turn, M(x, j), M(y, j));
        });
    }

    /// An element's stiffness: R' K R.
    template <class Matrix> void turn(const ElementDofs& dofs, Matrix& K) const
    {
        turn_columns(dofs, K);
        turn_rows(dofs, K);
    }

    /// Displacements of all nodes, the model's degrees of freedom one after the other, from the nodes' axes to global.
    template <class Scalar> void to_global(std::vector<Scalar>& displacements) const
    {
        const std::size_t n = dofs_.size();
        for (std::size_t node = 0; node < turns_.size(); ++node)
            if (turns_[node].sine != 0.0) {
                Scalar &x = displacements[node * n], &y = displacements[node * n + 1];
                const Scalar along = x, across = y;
                x = Scalar(turns_[node].cosine) * along - Scalar(turns_[node].sine) * across;
                y = Scalar(turns_[node].sine) * along + Scalar(turns_[node].cosine) * across;
            }
    }

private:
    struct Turn {
        double cosine = 1.0, sine = 0.0;
    };

    template <class Scalar> static void turn_back(const Turn& turn, Scalar& x, Scalar& y)
    {
        const Scalar along = x, across = y;
        x = Scalar(turn.cosine) * along + Scalar(turn.sine) * across;
        y = Scalar(turn.cosine) * across - Scalar(turn.sine) * along;
    }

    /// Calls visit(turn, place of ux, place of uy) for every node of the element whose axes are turned.
    template <class Visit> void visit(const ElementDofs& dofs, Visit&& visit) const
    {
        if (turns_.empty()) return;
        const auto n = static_cast<Eigen::Index>(dofs.of_each_node.size());
        for (std::size_t i = 0; i < dofs.nodes.size(); ++i)
            if (are_turned(dofs.nodes[i])) {
                const Eigen::Index first = static_cast<Eigen::Index>(i) * n;
                visit(turns_[dofs.nodes[i].index], first, first + 1); // ux and uy come first where they are known
            }
    }

    std::span<const Dof> dofs_;
    std::vector<Turn> turns_; ///< of every node; empty where none is turned
};

} // namespace femoop
