#include "apps/plane/discretize/following_mesh.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "femoop/shape/shape.h"

namespace discretize {

namespace {

using topology::CellNode;
using topology::FlatVector;

constexpr CellNode not_free = static_cast<CellNode>(-1);

bool is_meshed_alike(const PlaneModel& a, const PlaneModel& b)
{
    const auto are_alike = [](const auto& first, const auto& second, auto same) {
        return std::equal(first.begin(), first.end(), second.begin(), second.end(), same);
    };
    return a.mesh == b.mesh &&
           are_alike(a.points, b.points, [](const auto& p, const auto& q) { return p.size == q.size; }) &&
           are_alike(a.curves, b.curves,
                     [](const auto& p, const auto& q) {
                         return p.shape.has_value() == q.shape.has_value() &&
                                (!p.shape || p.shape->divide == q.shape->divide);
                     }) &&
           are_alike(a.regions, b.regions,
                     [](const auto& p, const auto& q) { return p.mesh == q.mesh && p.is_hole == q.is_hole; });
}

bool are_bordered_alike(const std::vector<FaceOutline>& a, const std::vector<FaceOutline>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const FaceOutline& p, const FaceOutline& q) {
        return p.region == q.region && p.loops == q.loops && p.inner_edges == q.inner_edges &&
               p.inner_vertices == q.inner_vertices;
    });
}

/// The same edges between the same vertices, of the same curves.
bool is_divided_alike(const Drawing& a, const Drawing& b)
{
    const topology::Solid &of_a = a.subdivision().solid(), &of_b = b.subdivision().solid();
    if (of_a.vertices().n_rows() != of_b.vertices().n_rows() || of_a.edges().n_rows() != of_b.edges().n_rows())
        return false;
    const auto same_edge = [&](topology::EdgeId e) {
        return of_b.edges().has(e) && of_a.start(of_a.plus(e)) == of_b.start(of_b.plus(e)) &&
               of_a.end(of_a.plus(e)) == of_b.end(of_b.plus(e)) &&
               a.owner(a.subdivision().part(e).curve) == b.owner(b.subdivision().part(e).curve);
    };
    for (const topology::EdgeId e : of_a.edges())
        if (!same_edge(e)) return false;
    return true;
}

} // namespace

/// How the nodes inside go along with those on curves.
class FollowingMesh::Net {
public:
    explicit Net(const RegionMesh& mesh)
        : mesh_(mesh), is_held_(mesh.nodes.size()), number_(mesh.nodes.size(), not_free)
    {
        for (const auto& node : mesh.of_vertex)
            if (node) is_held_[*node] = true;
        for (const NodeOnEdge& on : mesh.on_edges) is_held_[on.node] = true;
        list_springs();
        factorize();
    }

    /// \param moves  of every node; given of those that are held
    void complete(std::vector<FlatVector>& moves) const
    {
        Eigen::MatrixX2d forces = Eigen::MatrixX2d::Zero(n_free_, 2);
        for (const Spring& spring : springs_)
            for (const auto& [a, b] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)})
                if (!is_held_[a] && is_held_[b])
                    forces.row(row(a)) += spring.stiffness * Eigen::RowVector2d(moves[b].x, moves[b].y);
        if (n_free_ > 0) forces = solver_.solve(forces).eval();
        for (std::size_t i = 0; i < number_.size(); ++i)
            if (number_[i] != not_free) moves[i] = {forces(row(i), 0), forces(row(i), 1)};
        for (const MeshedElement& element : mesh_.elements) complete(element, moves);
    }

private:
    struct Spring {
        std::size_t a, b;
        double stiffness;
    };

    Eigen::Index row(std::size_t node) const { return static_cast<Eigen::Index>(number_[node]); }

    /// Each side of an element is one, so that a side between two is two.
    void list_springs()
    {
        for (const MeshedElement& element : mesh_.elements) {
            const femoop::Shape& shape = femoop::shape_of(element.kind);
            for (const femoop::Shape::Edge side : shape.edges()) {
                const std::size_t a = element.nodes[static_cast<std::size_t>(side[0])],
                                  b = element.nodes[static_cast<std::size_t>(side[1])];
                const FlatVector along = mesh_.nodes[b] - mesh_.nodes[a];
                springs_.push_back({a, b, 1.0 / (along.x * along.x + along.y * along.y)});
                for (const std::size_t node : {a, b})
                    if (!is_held_[node] && number_[node] == not_free) number_[node] = static_cast<CellNode>(n_free_++);
            }
        }
    }

    void factorize()
    {
        std::vector<Eigen::Triplet<double>> entries;
        for (const Spring& spring : springs_) {
            for (const std::size_t node : {spring.a, spring.b})
                if (!is_held_[node]) entries.emplace_back(row(node), row(node), spring.stiffness);
            if (is_held_[spring.a] || is_held_[spring.b]) continue;
            entries.emplace_back(row(spring.a), row(spring.b), -spring.stiffness);
            entries.emplace_back(row(spring.b), row(spring.a), -spring.stiffness);
        }
        Eigen::SparseMatrix<double> K(n_free_, n_free_);
        K.setFromTriplets(entries.begin(), entries.end());
        solver_.compute(K);
    }

    /// Middle nodes that no curve has go as the ends of their side do, the centre as all of them.
    void complete(const MeshedElement& element, std::vector<FlatVector>& moves) const
    {
        const auto node = [&](int i) { return element.nodes[static_cast<std::size_t>(i)]; };
        for (const femoop::Shape::Edge side : femoop::shape_of(element.kind).edges())
            if (side.size() > 2 && !is_held_[node(side[2])])
                moves[node(side[2])] = 0.5 * (moves[node(side[0])] + moves[node(side[1])]);
        if (element.kind != femoop::ShapeKind::Q9) return;
        FlatVector sum;
        for (int i = 0; i < 8; ++i) sum = sum + (i < 4 ? -0.25 : 0.5) * moves[node(i)];
        moves[node(8)] = sum;
    }

    const RegionMesh& mesh_;
    std::vector<bool> is_held_;    ///< of each node: a curve or a point has it
    std::vector<CellNode> number_; ///< of corners that are not: among the unknowns
    Eigen::Index n_free_ = 0;
    std::vector<Spring> springs_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

FollowingMesh::FollowingMesh(const Drawing& drawing, const RegionMesh& mesh)
    : drawing_(drawing), outlines_(outlines_of(drawing)), mesh_(mesh), net_(std::make_unique<const Net>(mesh_))
{}

FollowingMesh::~FollowingMesh() = default;

std::optional<RegionMesh> FollowingMesh::in(const Drawing& drawing) const
{
    if (!is_meshed_alike(drawing_.model(), drawing.model()) || !is_divided_alike(drawing_, drawing) ||
        !are_bordered_alike(outlines_, outlines_of(drawing)))
        return std::nullopt;
    RegionMesh moved = mesh_;
    const topology::PlanarSubdivision& plane = drawing.subdivision();
    for (const NodeOnEdge& on : moved.on_edges) moved.nodes[on.node] = place_on_edge(plane, on.edge, on.share);
    for (const topology::VertexId v : plane.solid().vertices())
        if (const auto node = moved.of_vertex[v.index]) moved.nodes[*node] = plane.at(v);
    std::vector<FlatVector> moves;
    for (std::size_t i = 0; i < moved.nodes.size(); ++i) moves.push_back(moved.nodes[i] - mesh_.nodes[i]);
    net_->complete(moves);
    for (std::size_t i = 0; i < moves.size(); ++i) moved.nodes[i] = mesh_.nodes[i] + moves[i];
    return moved;
}

} // namespace discretize
