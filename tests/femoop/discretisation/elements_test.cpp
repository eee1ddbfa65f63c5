// What every element must hold to, behind the interface that all analyses use.
#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "femoop/discretisation/elements.h"
#include "tests/femoop/analysis/random_structure.h"

using namespace femoop;

namespace {

/// Of some structures of every model, also with members that a constraint takes strains from.
template <class Check> void for_every_element(Check&& check)
{
    for (const AnalysisKind kind : every_model)
        for (unsigned seed = 1; seed <= 4; ++seed) {
            Model model = random_structure(kind, seed);
            if (seed % 2 == 0) model.members[seed % model.members.size()].inextensible = true;
            const Discretisation structure = discretise(model);
            const Elements elements(structure);
            CAPTURE(name(kind));
            CAPTURE(seed);
            for (std::size_t i = 0; i < elements.size(); ++i) {
                CAPTURE(model.members[i].id);
                check(elements[i], structure, MemberId(i));
            }
        }
}

/// The nodes of an element in a rigid motion: a shift along an axis, or a turn about one.
Eigen::VectorXd rigid_motion(const ElementDofs& dofs, const Discretisation& structure, Dof motion)
{
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(index(motion)) % 3);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(dofs.size()));
    Eigen::Index row = 0;
    for (const NodeId node : dofs.nodes) {
        const Eigen::Vector3d& at = structure.positions[node.index];
        Eigen::Vector3d shift = unit, turn = Eigen::Vector3d::Zero();
        if (is_rotation(motion)) {
            shift = unit.cross(at);
            turn = unit;
        }
        for (const Dof dof : dofs.of_each_node) {
            const auto axis = static_cast<Eigen::Index>(index(dof)) % 3;
            u[row++] = is_rotation(dof) ? turn[axis] : shift[axis];
        }
    }
    return u;
}

bool keeps_the_model(AnalysisKind kind, Dof motion)
{
    if (is_3d(kind)) return true;
    const bool in_plane = motion == Dof::ux || motion == Dof::uy || motion == Dof::rz;
    return in_plane == (kind != AnalysisKind::Grillage);
}

} // namespace

TEST_CASE("An element's matrices have a row for each of its degrees of freedom")
{
    for_every_element([](const Element& element, const Discretisation&, MemberId) {
        const auto n = static_cast<Eigen::Index>(element.dofs().size());
        ElementMatrix K;
        element.stiffness(K);
        CHECK(K.rows() == n);
        CHECK(K.cols() == n);
        CHECK(element.strains().cols() == n);
        ElementVector f;
        element.equivalent_forces({}, f);
        CHECK(f.size() == n);
        CHECK(f.isZero(0.0));
    });
}

TEST_CASE("An element's stiffness is symmetric, and the same to 32 digits")
{
    for_every_element([](const Element& element, const Discretisation&, MemberId) {
        ElementMatrix K;
        element.stiffness(K);
        const double largest = std::max(K.cwiseAbs().maxCoeff(), 1e-300);
        CHECK((K - K.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * largest);
        CHECK((K - rounded(element.precise_stiffness())).cwiseAbs().maxCoeff() <= 1e-12 * largest);
    });
}

TEST_CASE("A rigid motion of an element's nodes strains it no more than its ends behind joints make good")
{
    for_every_element([](const Element& element, const Discretisation& structure, MemberId member) {
        if (structure.properties_of(member).xy.foundation > 0.0) return; // strained by where it lies
        const ElementDofs dofs = element.dofs();
        const Eigen::MatrixXd A = element.strains();
        const Eigen::MatrixXd of_own = A.rightCols(static_cast<Eigen::Index>(dofs.n_own));
        for (const Dof motion : all_dofs) {
            if (!keeps_the_model(structure.kind, motion)) continue;
            Eigen::VectorXd strain = A * rigid_motion(dofs, structure, motion);
            if (of_own.cols() > 0) strain -= of_own * of_own.completeOrthogonalDecomposition().solve(strain).eval();
            CHECK(strain.norm() < 1e-11);
        }
    });
}

TEST_CASE("Members that follow one another and are alike share one stiffness, others do not")
{
    Model model;
    model.analysis = AnalysisKind::Frame2d;
    const MaterialId steel = model.add(Material{.id = "steel", .E = 210e6});
    Section section{.id = "I"};
    section.A = 0.01;
    section.Iz = 2e-4;
    const SectionId I = model.add(section);
    for (const double x : {0.0, 3.0, 6.0, 10.0, 13.0})
        model.add(Node{.id = std::to_string(model.nodes.size()), .at = {x, 0.0}});
    for (std::size_t i = 0; i + 1 < model.nodes.size(); ++i)
        model.add(
            Member{.id = std::to_string(i), .nodes = {NodeId(i), NodeId(i + 1)}, .material = steel, .section = I});
    const Discretisation structure = discretise(model);
    const Elements elements(structure);
    CHECK(elements[0].stiffness_group() == elements[1].stiffness_group());
    CHECK(elements[1].stiffness_group() != elements[2].stiffness_group());
    CHECK(elements[2].stiffness_group() != elements[3].stiffness_group());
}
