#include "femoop/plane/analysis/plate_mechanism.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

namespace femoop::plane {

namespace {

constexpr Eigen::Index most_parts = 300;    // of which the motions are sought together
constexpr double negligible_square = 1e-14; // of squares: 1e-7 of the body's size
constexpr double at_rest = 1e-9;

/// Parts that elements make edge by edge.
class RigidParts {
public:
    explicit RigidParts(const PlaneModel& model) : model_(model), of_element_(model.elements.size())
    {
        std::iota(of_element_.begin(), of_element_.end(), std::size_t{0});
        join_by_edges();
        for (std::size_t& root : of_element_) root = of_element_[root]; // a root comes before what it holds together
        std::vector<std::size_t> number(of_element_.size());
        for (std::size_t e = 0; e < of_element_.size(); ++e)
            number[e] = of_element_[e] == e ? n_++ : number[of_element_[e]];
        of_element_ = std::move(number);
    }

    std::size_t size() const { return n_; }
    std::size_t of(std::size_t element) const { return of_element_[element]; }

    /// Of every node the parts that meet there.
    std::vector<std::vector<std::size_t>> at_nodes() const
    {
        std::vector<std::vector<std::size_t>> parts(model_.points.size());
        for (std::size_t e = 0; e < of_element_.size(); ++e)
            for (const NodeId node : model_.elements[e].points)
                if (auto& here = parts[node.index]; std::ranges::find(here, of_element_[e]) == here.end())
                    here.push_back(of_element_[e]);
        return parts;
    }

private:
    std::size_t find(std::size_t i)
    {
        while (of_element_[i] != i) i = of_element_[i] = of_element_[of_element_[i]];
        return i;
    }

    void join_by_edges()
    {
        std::vector<std::array<std::size_t, 3>> edges; // ends, element
        for (std::size_t e = 0; e < model_.elements.size(); ++e) {
            const PlaneElement& element = model_.elements[e];
            for (const Shape::Edge edge : shape_of(element.kind).edges()) {
                const std::size_t a = element.points[static_cast<std::size_t>(edge[0])].index;
                const std::size_t b = element.points[static_cast<std::size_t>(edge[1])].index;
                edges.push_back({std::min(a, b), std::max(a, b), e});
            }
        }
        std::ranges::sort(edges);
        for (std::size_t i = 0; i + 1 < edges.size(); ++i)
            if (edges[i][0] == edges[i + 1][0] && edges[i][1] == edges[i + 1][1]) join(edges[i][2], edges[i + 1][2]);
    }

    void join(std::size_t a, std::size_t b)
    {
        const std::size_t p = find(a), q = find(b);
        of_element_[std::max(p, q)] = std::min(p, q);
    }

    const PlaneModel& model_;
    std::vector<std::size_t> of_element_;
    std::size_t n_ = 0;
};

/// The conditions on three motions of each part: (a, b, w) moves a point by a - w y, b + w x about the middle.
class MotionConditions {
public:
    MotionConditions(const PlaneStructure& structure, const RigidParts& parts)
        : structure_(structure), at_nodes_(parts.at_nodes())
    {
        Eigen::Vector2d low = structure.positions().front(), high = low;
        for (const Eigen::Vector2d& at : structure.positions()) low = low.cwiseMin(at), high = high.cwiseMax(at);
        middle_ = 0.5 * (low + high);
        size_ = (high - low).norm();
        squares_ = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(parts.size()),
                                         3 * static_cast<Eigen::Index>(parts.size()));
        for (std::size_t i = 0; i < at_nodes_.size(); ++i)
            if (!at_nodes_[i].empty()) add_node(NodeId(i));
        for (const Discretisation::Tie& tie : structure.discretisation()->ties) {
            const Eigen::Vector2d axis = tie.dof == Dof::ux ? Eigen::Vector2d::UnitX() : Eigen::Vector2d::UnitY();
            add({{tie.node, at_nodes_[tie.node.index].front(), 1.0},
                 {tie.leader, at_nodes_[tie.leader.index].front(), -1.0}},
                axis);
        }
        if (structure.model().analysis == StressState::Axisymmetric) // radial motions and turns strain a ring
            for (Eigen::Index p = 0; p < squares_.rows(); p += 3) squares_(p, p) += 1.0, squares_(p + 2, p + 2) += 1.0;
    }

    /// A basis of the motions that no condition stops, in its simplest form.
    Eigen::MatrixXd free_motions() const
    {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(squares_);
        const double largest = std::max(1.0, eigen.eigenvalues().maxCoeff());
        const Eigen::Index n = (eigen.eigenvalues().array() <= negligible_square * largest).count();
        return simplified(eigen.eigenvectors().leftCols(n));
    }

    Eigen::Vector2d moved(const Eigen::Vector3d& motion, const Eigen::Vector2d& at) const
    {
        const Eigen::Vector2d arm = (at - middle_) / size_;
        return {motion[0] - motion[2] * arm.y(), motion[1] + motion[2] * arm.x()};
    }

    /// The place that stays at rest. \pre it turns
    Eigen::Vector2d pole(const Eigen::Vector3d& motion) const
    {
        return middle_ + size_ * Eigen::Vector2d(-motion[1], motion[0]) / motion[2];
    }

    const std::vector<std::vector<std::size_t>>& at_nodes() const { return at_nodes_; }

private:
    struct Term {
        NodeId node;
        std::size_t part;
        double factor;
    };

    void add_node(NodeId node)
    {
        const Discretisation::SupportRow* support = structure_.discretisation()->support_of(node);
        const std::size_t first = at_nodes_[node.index].front();
        if (support != nullptr) {
            const Eigen::Vector2d x(std::cos(support->angle), std::sin(support->angle));
            const Eigen::Vector2d y(-x.y(), x.x());
            const auto holds = [&](Dof dof) {
                return support->blocked.contains(dof) || support->on_foundations.contains(dof);
            };
            if (holds(Dof::ux)) add({{node, first, 1.0}}, x);
            if (holds(Dof::uy)) add({{node, first, 1.0}}, y);
        }
        for (const std::size_t part : at_nodes_[node.index])
            if (part != first)
                for (const Eigen::Vector2d& axis : {Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.0, 1.0)})
                    add({{node, first, 1.0}, {node, part, -1.0}}, axis);
    }

    void add(const std::vector<Term>& terms, const Eigen::Vector2d& direction)
    {
        std::vector<std::pair<Eigen::Index, double>> row;
        for (const Term& term : terms) {
            const Eigen::Vector2d arm = (structure_.positions()[term.node.index] - middle_) / size_;
            const auto p = 3 * static_cast<Eigen::Index>(term.part);
            row.emplace_back(p, term.factor * direction.x());
            row.emplace_back(p + 1, term.factor * direction.y());
            row.emplace_back(p + 2, term.factor * (arm.x() * direction.y() - arm.y() * direction.x()));
        }
        for (const auto& [i, a] : row)
            for (const auto& [j, b] : row) squares_(i, j) += a * b;
    }

    /// Gauss-Jordan on the columns: each motion alone has one of the numbers.
    static Eigen::MatrixXd simplified(Eigen::MatrixXd basis)
    {
        Eigen::Index column = 0;
        for (Eigen::Index row = 0; row < basis.rows() && column < basis.cols(); ++row) {
            Eigen::Index best = 0;
            const double pivot = basis.row(row).tail(basis.cols() - column).cwiseAbs().maxCoeff(&best);
            if (pivot < 1e-6) continue;
            basis.col(column).swap(basis.col(column + best));
            basis.col(column) /= basis(row, column);
            for (Eigen::Index other = 0; other < basis.cols(); ++other)
                if (other != column) basis.col(other) -= basis(row, other) * basis.col(column);
            ++column;
        }
        return basis;
    }

    const PlaneStructure& structure_;
    std::vector<std::vector<std::size_t>> at_nodes_;
    Eigen::Vector2d middle_;
    double size_ = 1.0;
    Eigen::MatrixXd squares_;
};

std::string rounded_text(double value)
{
    std::ostringstream text;
    text.precision(4);
    text << (std::abs(value) < 1e-9 ? 0.0 : value);
    return text.str();
}
std::string place_text(const Eigen::Vector2d& at)
{
    return "(" + rounded_text(at.x()) + ", " + rounded_text(at.y()) + ")";
}

std::string direction_text(const Eigen::Vector2d& direction)
{
    if (std::abs(direction.y()) < 1e-6 * direction.norm()) return "x";
    return std::abs(direction.x()) < 1e-6 * direction.norm() ? "y" : place_text(direction.normalized());
}

/// The regions of the parts that a motion moves.
std::string moving_regions(const PlaneModel& model, const RigidParts& parts, const Eigen::VectorXd& motion)
{
    std::vector<bool> moves(model.regions.size());
    for (std::size_t e = 0; e < model.elements.size(); ++e)
        if (motion.segment<3>(3 * static_cast<Eigen::Index>(parts.of(e))).norm() > at_rest)
            moves[model.elements[e].region.index] = true;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < moves.size(); ++i)
        if (moves[i]) names.push_back(model.regions[i].id);
    return listed(names);
}

Mechanism described(const PlaneStructure& structure, const RigidParts& parts, const MotionConditions& conditions,
                    const Eigen::VectorXd& motion)
{
    Mechanism mechanism{.fault = {.kind = FaultKind::RegionMoves, .arguments = {}}, .motion = {}, .member_ends = {}};
    Eigen::Index first = 0;
    while (motion.segment<3>(first).norm() <= at_rest) first += 3;
    const Eigen::Vector3d of_first = motion.segment<3>(first);
    const std::string regions = moving_regions(structure.model(), parts, motion);
    if (std::abs(of_first[2]) <= at_rest) {
        mechanism.fault.arguments = {regions, direction_text(of_first.head<2>())};
    } else {
        mechanism.fault.kind = FaultKind::RegionTurns;
        mechanism.fault.arguments = {regions, place_text(conditions.pole(of_first)) + " " +
                                                  std::string(name(structure.model().units.length))};
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < structure.positions().size(); ++i) {
        NodeVector& u = mechanism.motion.emplace_back();
        if (conditions.at_nodes()[i].empty()) continue;
        const auto part = 3 * static_cast<Eigen::Index>(conditions.at_nodes()[i].front());
        const Eigen::Vector2d moved = conditions.moved(motion.segment<3>(part), structure.positions()[i]);
        u[0] = moved.x();
        u[1] = moved.y();
        largest = std::max(largest, moved.norm());
    }
    for (NodeVector& u : mechanism.motion)
        for (double& component : u) component /= largest;
    return mechanism;
}

} // namespace

std::vector<Mechanism> rigid_motions(const PlaneStructure& structure)
{
    const RigidParts parts(structure.model());
    if (static_cast<Eigen::Index>(parts.size()) > most_parts) return {};
    const MotionConditions conditions(structure, parts);
    const Eigen::MatrixXd free = conditions.free_motions();
    std::vector<Mechanism> mechanisms;
    for (const auto motion : free.colwise()) mechanisms.push_back(described(structure, parts, conditions, motion));
    return mechanisms;
}

} // namespace femoop::plane
