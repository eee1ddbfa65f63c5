#include "femoop/plane/analysis/plate_mechanism.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

#include "femoop/algebra/symmetric_eigen.h"
#include "femoop/result/element_field.h"

namespace femoop::plane {

namespace {

constexpr Eigen::Index most_parts = 300;    // of which the motions are sought together
constexpr double negligible_square = 1e-14; // of squares: 1e-7 of the body's size
constexpr double at_rest = 1e-9;

/// Parts that elements make edge by edge.
class RigidParts {
public:
    explicit RigidParts(const PlaneStructure& structure)
        : structure_(structure), of_element_(structure.model().elements.size())
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

    /// The parts that meet at a node.
    std::vector<std::size_t> at(NodeId node) const
    {
        std::vector<std::size_t> parts;
        for (const std::uint32_t e : structure_.elements_of(node))
            if (std::ranges::find(parts, of_element_[e]) == parts.end()) parts.push_back(of_element_[e]);
        return parts;
    }
    /// One of them. \pre an element has the node
    std::size_t one_at(NodeId node) const { return of_element_[structure_.elements_of(node).front()]; }

private:
    std::size_t find(std::size_t i)
    {
        while (of_element_[i] != i) i = of_element_[i] = of_element_[of_element_[i]];
        return i;
    }

    void join_by_edges()
    {
        const std::vector<PlaneElement>& elements = structure_.model().elements;
        for (std::size_t e = 0; e < elements.size(); ++e)
            for (const Shape::Edge edge : shape_of(elements[e].kind).edges()) {
                const NodeId a = elements[e].points[static_cast<std::size_t>(edge[0])];
                const NodeId b = elements[e].points[static_cast<std::size_t>(edge[1])];
                for (const auto& other : {structure_.edges().find(a, b), structure_.edges().find(b, a)})
                    if (other) join(e, other->element.index);
            }
    }

    void join(std::size_t a, std::size_t b)
    {
        const std::size_t p = find(a), q = find(b);
        of_element_[std::max(p, q)] = std::min(p, q);
    }

    const PlaneStructure& structure_;
    std::vector<std::size_t> of_element_;
    std::size_t n_ = 0;
};

/// The conditions on three motions of each part: (a, b, w) moves a point by a - w y, b + w x about the middle.
class MotionConditions {
public:
    MotionConditions(const PlaneStructure& structure, const RigidParts& parts) : structure_(structure), parts_(parts)
    {
        Eigen::Vector2d low = structure.positions().front(), high = low;
        for (const Eigen::Vector2d& at : structure.positions()) low = low.cwiseMin(at), high = high.cwiseMax(at);
        middle_ = 0.5 * (low + high);
        size_ = (high - low).norm();
        squares_ = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(parts.size()),
                                         3 * static_cast<Eigen::Index>(parts.size()));
        for (std::size_t i = 0; i < structure.positions().size(); ++i)
            if (!structure.elements_of(NodeId(i)).empty()) add_node(NodeId(i));
        for (const Discretisation::Tie& tie : structure.discretisation()->ties) {
            const Eigen::Vector2d axis = tie.dof == Dof::ux ? Eigen::Vector2d::UnitX() : Eigen::Vector2d::UnitY();
            add({{tie.node, parts.one_at(tie.node), 1.0}, {tie.leader, parts.one_at(tie.leader), -1.0}}, axis);
        }
        if (structure.model().analysis == StressState::Axisymmetric) // radial motions and turns strain a ring
            for (Eigen::Index p = 0; p < squares_.rows(); p += 3) squares_(p, p) += 1.0, squares_(p + 2, p + 2) += 1.0;
    }

    /// A basis of the motions that no condition stops, in its simplest form.
    Eigen::MatrixXd free_motions() const
    {
        const SymmetricEigen eigen = symmetric_eigen(squares_);
        const double largest = std::max(1.0, eigen.values.maxCoeff());
        const Eigen::Index n = (eigen.values.array() <= negligible_square * largest).count();
        return simplified(eigen.vectors.leftCols(n));
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

private:
    struct Term {
        NodeId node;
        std::size_t part;
        double factor;
    };

    void add_node(NodeId node)
    {
        const Discretisation::SupportRow* support = structure_.discretisation()->support_of(node);
        const std::size_t first = parts_.one_at(node);
        if (support != nullptr) {
            const Eigen::Vector2d x(std::cos(support->angle), std::sin(support->angle));
            const Eigen::Vector2d y(-x.y(), x.x());
            const auto holds = [&](Dof dof) {
                return support->blocked.contains(dof) || support->on_foundations.contains(dof);
            };
            if (holds(Dof::ux)) add({{node, first, 1.0}}, x);
            if (holds(Dof::uy)) add({{node, first, 1.0}}, y);
        }
        if (parts_.size() == 1) return;
        for (const std::size_t part : parts_.at(node))
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
    const RigidParts& parts_;
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
        if (structure.elements_of(NodeId(i)).empty()) continue;
        const auto part = 3 * static_cast<Eigen::Index>(parts.one_at(NodeId(i)));
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
    const RigidParts parts(structure);
    if (static_cast<Eigen::Index>(parts.size()) > most_parts) return {};
    const MotionConditions conditions(structure, parts);
    const Eigen::MatrixXd free = conditions.free_motions();
    std::vector<Mechanism> mechanisms;
    for (const auto motion : free.colwise()) mechanisms.push_back(described(structure, parts, conditions, motion));
    return mechanisms;
}

bool strains(const PlaneStructure& structure, const std::vector<double>& u)
{
    constexpr double rounding = 1e-11; // of the motion, over the element's size
    const std::vector<PlaneElement>& elements = structure.model().elements;
    return std::any_of(elements.begin(), elements.end(), [&, e = std::size_t{0}](const PlaneElement& element) mutable {
        const ElementField inside(structure.element(ElementId(e++)), u);
        const Eigen::Vector2d at = structure.positions()[element.points.front().index];
        double size = 0.0;
        for (const NodeId node : element.points) size = std::max(size, (structure.positions()[node.index] - at).norm());
        const ContinuumElement::StrainColumns strain = inside.strains(inside.element().formulation().points());
        return strain.cwiseAbs().maxCoeff() * size > rounding * inside.node_displacements().cwiseAbs().maxCoeff();
    });
}

} // namespace femoop::plane
