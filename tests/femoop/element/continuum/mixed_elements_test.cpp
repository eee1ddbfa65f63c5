#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "femoop/analysis/assembler.h"
#include "femoop/discretisation/equations.h"
#include "femoop/element/continuum/continuum_element.h"
#include "femoop/material/linear_elastic.h"
#include "femoop/model/model.h"
#include "femoop/solver/symmetric_solver.h"
#include "tests/femoop/element/continuum/plane_problem.h"

using namespace femoop;
using namespace femoop_test;

namespace {

constexpr double sheet_length = 3.1, sheet_height = 0.7, bar_modulus = 205.0e3, bar_area = 0.013, pull = 13.0;
constexpr double sheet_turn = 0.5; // of everything, so that all supports are inclined [rad]

/// The corners A B C D of a sheet with bars AB and DC, which all may move along x' only, A and D not at all.
Model two_bars()
{
    Model model;
    model.analysis = AnalysisKind::Truss2d;
    model.materials.push_back({.id = "steel", .E = bar_modulus});
    Section section;
    section.id = "bar";
    section.A = bar_area;
    model.sections.push_back(section);
    const std::array<Eigen::Vector2d, 4> corners{
        {{0.0, 0.0}, {sheet_length, 0.0}, {sheet_length, sheet_height}, {0.0, sheet_height}}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d at = Eigen::Rotation2Dd(sheet_turn) * corners[i];
        Support support;
        support.angle = sheet_turn * 180.0 / std::numbers::pi;
        support.fixed = i == 0 || i == 3 ? DofSet{Dof::ux, Dof::uy} : DofSet{Dof::uy};
        model.nodes.push_back({.id = std::string(1, char('A' + i)), .at = {at.x(), at.y(), 0.0}, .support = support});
    }
    for (const auto [start, end] : {std::array{0, 1}, std::array{3, 2}}) {
        Member bar;
        bar.id = std::to_string(start);
        bar.nodes = {NodeId(static_cast<std::size_t>(start)), NodeId(static_cast<std::size_t>(end))};
        bar.material = MaterialId(0);
        bar.section = SectionId(0);
        model.members.push_back(bar);
    }
    return model;
}

} // namespace

TEST_CASE("Bars along a sheet and the sheet itself share a traction as their stiffnesses do, on inclined supports")
{
    Discretisation structure = discretise(two_bars());
    std::vector<Eigen::Vector2d> positions;
    for (const Eigen::Vector3d& p : structure.positions) positions.emplace_back(p.head<2>());
    const LinearElastic material({.E = E, .nu = nu}, StressState::PlaneStress);
    const ContinuumFormulation formulation(shape_of(ShapeKind::Q4), gauss_quadrilateral(2), material, thickness);
    const std::array corners{NodeId(0), NodeId(1), NodeId(2), NodeId(3)};
    structure.bodies.push_back(make_continuum_element(formulation, corners, positions));
    const Elements elements(structure);
    const std::size_t at_sheet = elements.size() - 1;

    CaseLoads loads;
    loads.elements.push_back({.element = at_sheet,
                              .edge_loads = {{1, [](const EdgePoint& p) { return Eigen::Vector2d(pull * p.outward); }}},
                              .body_loads = {}});
    const Equations equations(structure, elements, SolverKind::Automatic);
    const Assembler assembler(structure, elements, equations);
    SparseMatrix K = equations.pattern().matrix();
    assembler.add_stiffness(K);
    const auto solver = make_solver(equations.pattern().solver());
    solver->analyse(equations.pattern());
    REQUIRE(solver->factorize(K).is_complete);
    const Eigen::VectorXd u = solver->solve(assembler.load_vector<double>(loads));

    // The sheet cannot narrow: it is E / (1 - nu^2) per area.
    const double stiffness = (E * thickness * sheet_height / (1.0 - nu * nu) + 2.0 * bar_modulus * bar_area) /
                             sheet_length;
    REQUIRE(u.size() == 2);
    for (const double value : u)
        CHECK(value == doctest::Approx(pull * thickness * sheet_height / stiffness).epsilon(1e-12));
}
