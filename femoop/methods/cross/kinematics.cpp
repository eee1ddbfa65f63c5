#include "femoop/methods/cross/kinematics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace femoop::cross {

namespace {

constexpr double no_pivot = 1e-9;   // of a row of direction cosines
constexpr double no_motion = 1e-12; // of the unit displacement of a mode
constexpr double no_misfit = 1e-9;  // of the largest imposed displacement

using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Unknown {
    NodeId node;
    int axis = 0;
};

class Ties {
public:
    Ties(const Discretisation& structure, const std::vector<bool>& is_free,
         const std::vector<Eigen::Vector2d>& settlements)
        : structure_(structure), settlements_(settlements)
    {
        for (std::size_t i = 0; i < structure.positions.size(); ++i)
            axes_.push_back(support_axes(structure, NodeId(i)));
        number(is_free);
    }

    Motion solve(const std::vector<AxialTie>& ties)
    {
        fill(ties);
        eliminate();
        Motion motion;
        motion.is_contradictory = is_contradictory();
        motion.imposed = displacements({});
        for (std::size_t column = 0; column < unknowns_.size(); ++column)
            if (row_of_[column] < 0) motion.modes.push_back(mode(static_cast<Eigen::Index>(column)));
        std::reverse(motion.modes.begin(), motion.modes.end());
        return motion;
    }

private:
    /// Vertical displacements first, then horizontal ones from the last node: what is left free and propped is
    /// horizontal, at the first node that can be.
    void number(const std::vector<bool>& is_free)
    {
        column_of_.assign(2 * is_free.size(), -1);
        for (const int axis : {1, 0})
            for (std::size_t i = 0; i < is_free.size(); ++i) {
                const std::size_t node = axis == 1 ? i : is_free.size() - 1 - i;
                if (!is_free[node] || is_blocked(NodeId(node), axis)) continue;
                column_of_[2 * node + static_cast<std::size_t>(axis)] = static_cast<Eigen::Index>(unknowns_.size());
                unknowns_.push_back({NodeId(node), axis});
            }
    }

    bool is_blocked(NodeId node, int axis) const
    {
        const Discretisation::SupportRow* support = structure_.support_of(node);
        return support != nullptr && support->blocked.contains(axis == 0 ? Dof::ux : Dof::uy);
    }

    void fill(const std::vector<AxialTie>& ties)
    {
        const auto n = static_cast<Eigen::Index>(unknowns_.size());
        table_ = Table::Zero(static_cast<Eigen::Index>(ties.size()), n + 1);
        for (std::size_t i = 0; i < ties.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            table_(row, n) = ties[i].elongation;
            largest_ = std::max(largest_, std::abs(ties[i].elongation));
            add(row, ties[i].a, -ties[i].direction);
            add(row, ties[i].b, ties[i].direction);
        }
    }

    void add(Eigen::Index row, NodeId node, const Eigen::Vector2d& direction)
    {
        const Eigen::Vector2d along = axes_[node.index] * direction;
        for (const int axis : {0, 1}) {
            const Eigen::Index column = column_of_[2 * node.index + static_cast<std::size_t>(axis)];
            if (column >= 0) table_(row, column) += along[axis];
            else {
                const double settled = along[axis] * settlements_[node.index][axis];
                table_(row, table_.cols() - 1) -= settled;
                largest_ = std::max(largest_, std::abs(settled));
            }
        }
    }

    void eliminate()
    {
        row_of_.assign(unknowns_.size(), -1);
        for (Eigen::Index column = 0; column + 1 < table_.cols() && n_pivots_ < table_.rows(); ++column) {
            Eigen::Index best = 0;
            const Eigen::Index left = table_.rows() - n_pivots_;
            if (table_.col(column).tail(left).cwiseAbs().maxCoeff(&best) < no_pivot) continue;
            table_.row(n_pivots_).swap(table_.row(n_pivots_ + best));
            clear_column(column);
            row_of_[static_cast<std::size_t>(column)] = n_pivots_++;
        }
    }

    void clear_column(Eigen::Index column)
    {
        const Eigen::Index n = table_.cols() - column;
        table_.row(n_pivots_).tail(n) /= table_(n_pivots_, column);
        for (Eigen::Index row = 0; row < table_.rows(); ++row) {
            const double factor = table_(row, column);
            if (row == n_pivots_ || factor == 0.0) continue;
            table_.row(row).tail(n) -= factor * table_.row(n_pivots_).tail(n);
            table_(row, column) = 0.0;
        }
    }

    bool is_contradictory() const
    {
        const Eigen::Index left = table_.rows() - n_pivots_;
        return left > 0 && !(table_.rightCols<1>().tail(left).cwiseAbs().maxCoeff() <= no_misfit * largest_);
    }

    /// Displacements of all nodes, one unknown moving by 1 (or none, and the imposed ones).
    std::vector<Eigen::Vector2d> displacements(std::optional<Eigen::Index> moving) const
    {
        std::vector<Eigen::Vector2d> u(axes_.size(), Eigen::Vector2d::Zero());
        if (!moving) u = settlements_;
        for (std::size_t column = 0; column < unknowns_.size(); ++column) {
            double value = moving == static_cast<Eigen::Index>(column) ? 1.0 : 0.0;
            if (row_of_[column] >= 0)
                value = moving ? -table_(row_of_[column], *moving) : table_(row_of_[column], table_.cols() - 1);
            if (moving && std::abs(value) < no_motion) value = 0.0;
            u[unknowns_[column].node.index][unknowns_[column].axis] = value;
        }
        for (std::size_t node = 0; node < u.size(); ++node) u[node] = axes_[node].transpose() * u[node];
        return u;
    }

    Motion::Mode mode(Eigen::Index column) const
    {
        const Unknown& unknown = unknowns_[static_cast<std::size_t>(column)];
        return {.node = unknown.node,
                .direction = axes_[unknown.node.index].row(unknown.axis).transpose(),
                .displacement = displacements(column)};
    }

    const Discretisation& structure_;
    const std::vector<Eigen::Vector2d>& settlements_;
    std::vector<Eigen::Matrix2d> axes_;
    std::vector<Unknown> unknowns_;
    std::vector<Eigen::Index> column_of_; ///< of each node's two displacements; -1 where it is prescribed
    std::vector<Eigen::Index> row_of_;    ///< that solves a column; -1 where the displacement stays free
    Table table_;
    Eigen::Index n_pivots_ = 0;
    double largest_ = 0.0;
};

} // namespace

Eigen::Matrix2d support_axes(const Discretisation& structure, NodeId node)
{
    const Discretisation::SupportRow* support = structure.support_of(node);
    if (support == nullptr || support->angle == 0.0) return Eigen::Matrix2d::Identity();
    const double c = std::cos(support->angle), s = std::sin(support->angle);
    return (Eigen::Matrix2d() << c, s, -s, c).finished();
}

Motion motion_of(const Discretisation& structure, const std::vector<bool>& is_free, const std::vector<AxialTie>& ties,
                 const std::vector<Eigen::Vector2d>& settlements)
{
    return Ties(structure, is_free, settlements).solve(ties);
}

} // namespace femoop::cross
