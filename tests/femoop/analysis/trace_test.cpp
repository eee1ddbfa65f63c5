#include <doctest/doctest.h>

#include "femoop/analysis/trace.h"
#include "femoop/io/results/results_table.h"
#include "tests/frame_maker.h"

using namespace femoop;

namespace {

constexpr double E = 2.1e8, A = 0.013, I = 1.3e-4, L = 5.0, q = 7.0;

Model cantilever_with_prop()
{
    FrameMaker made({.id = "s", .A = A, .Iz = I}, {.id = "steel", .E = E});
    made.node("A", 0, 0, SupportKind::Fixed).node("B", 3, 4, SupportKind::Roller).member("A", "B");
    made.load("AB", DistributedLoad{.values = {{.dof = Dof::uy, .start = -q}}, .axes = LoadAxes::Local});
    return made.model;
}

} // namespace

TEST_SUITE("trace")
{
    TEST_CASE("The trace shows EA / L, 12 EI / L^3, the turn and the places of a member")
    {
        const MemberTrace trace = femoop::trace(cantilever_with_prop(), MemberId(0));
        CHECK(trace.length == doctest::Approx(L));
        CHECK(trace.dofs == std::vector<std::string>{"A.ux", "A.uy", "A.rz", "B.ux", "B.uy", "B.rz"});
        CHECK(trace.equations == std::vector<int>{0, 0, 0, 1, 0, 2});
        CHECK(trace.local_stiffness(0, 0) == doctest::Approx(E * A / L));
        CHECK(trace.local_stiffness(1, 1) == doctest::Approx(12.0 * E * I / (L * L * L)));
        CHECK(trace.local_stiffness(2, 5) == doctest::Approx(2.0 * E * I / L));
        CHECK(trace.transformation(0, 0) == doctest::Approx(0.6));
        CHECK(trace.transformation(0, 1) == doctest::Approx(0.8));
        CHECK(trace.transformation(4, 3) == doctest::Approx(-0.8));
        const Eigen::MatrixXd product = trace.transformation.transpose() * trace.local_stiffness * trace.transformation;
        CHECK((product - trace.global_stiffness).norm() < 1e-9 * product.norm());
    }

    TEST_CASE("Its fixed-end forces are q L / 2 and q L^2 / 12, then turned")
    {
        const MemberTrace trace = femoop::trace(cantilever_with_prop(), MemberId(0));
        REQUIRE(trace.fixed_end.size() == 1);
        CHECK(trace.fixed_end[0].load_case == "P");
        CHECK(trace.fixed_end[0].local[1] == doctest::Approx(q * L / 2.0));
        CHECK(trace.fixed_end[0].local[2] == doctest::Approx(q * L * L / 12.0));
        CHECK(trace.fixed_end[0].global[0] == doctest::Approx(-0.8 * q * L / 2.0));
        CHECK(trace.fixed_end[0].global[1] == doctest::Approx(0.6 * q * L / 2.0));
    }

    TEST_CASE("A released end shows the condensed stiffness 3 EI / L")
    {
        Model model = cantilever_with_prop();
        model.members[0].end.release = {Dof::rz};
        const MemberTrace trace = femoop::trace(model, MemberId(0));
        CHECK(trace.local_stiffness(2, 2) == doctest::Approx(3.0 * E * I / L));
        CHECK(trace.fixed_end[0].local[2] == doctest::Approx(q * L * L / 8.0));
    }

    TEST_CASE("A truss member and a bar show the loads across their axis too: turned back, they are those of the nodes")
    {
        Model frame = cantilever_with_prop();
        frame.members[0].bar = true;
        Model truss = cantilever_with_prop();
        truss.analysis = AnalysisKind::Truss2d;
        truss.nodes[1].support = Support{.fixed = {Dof::uy}, .angle = 20.0};
        for (const Model& model : {frame, truss}) {
            const MemberTrace trace = femoop::trace(model, MemberId(0));
            const Eigen::VectorXd& own = trace.fixed_end[0].local;
            REQUIRE(own.size() == static_cast<Eigen::Index>(trace.dofs.size()));
            CHECK(own[0] == 0.0);
            CHECK(own[1] == doctest::Approx(q * L / 2.0));
            CHECK((trace.transformation.transpose() * own - trace.fixed_end[0].global).norm() < 1e-12 * q * L);
            const Eigen::MatrixXd k = trace.transformation.transpose() * trace.local_stiffness * trace.transformation;
            CHECK((k - trace.global_stiffness).norm() < 1e-12 * k.norm());
        }
    }

    TEST_CASE("The trace of every member of a truss reads as tables, in space too")
    {
        Model model = cantilever_with_prop();
        for (const AnalysisKind kind : {AnalysisKind::Truss2d, AnalysisKind::Truss3d}) {
            model.analysis = kind;
            model.nodes[1].support->kind = SupportKind::Pin;
            const std::string text = trace_text(femoop::trace(model, MemberId(0)), model.units, english);
            CHECK(text.find("B.uy'") != std::string::npos);
        }
    }

    TEST_CASE("The rows in a grillage member's own axes are named as its releases are")
    {
        Model model = cantilever_with_prop();
        model.analysis = AnalysisKind::Grillage;
        model.sections[0].J = 2e-4;
        model.nodes[1].support->kind = SupportKind::Pin;
        model.load_cases.clear();
        const MemberTrace trace = femoop::trace(model, MemberId(0));
        CHECK(trace.own_dofs == std::vector<std::string>{"A.uy'", "A.rx'", "A.rz'", "B.uy'", "B.rx'", "B.rz'"});
        CHECK(trace.dofs == std::vector<std::string>{"A.uz", "A.rx", "A.ry", "B.uz", "B.rx", "B.ry"});
    }

    TEST_CASE("The trace of a member that a constraint ties says so")
    {
        Model model = cantilever_with_prop();
        CHECK(femoop::trace(model, MemberId(0)).constraint == Constraint::None);
        model.members[0].inextensible = true;
        CHECK(femoop::trace(model, MemberId(0)).constraint == Constraint::Inextensible);
        const std::string text = trace_text(femoop::trace(model, MemberId(0)), model.units, english);
        CHECK(text.find("inextensible: a constraint") != std::string::npos);
    }
}
