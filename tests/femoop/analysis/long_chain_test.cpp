// Chains of thousands of members, which doubles alone get wrong: the same closed forms hold as for one member.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/solver/solver_kind.h"

using namespace femoop;

namespace {

constexpr double E = 2.1e8, A = 0.013, I = 1.1e-4, J = 2.3e-4, nu = 0.3, alpha = 1.2e-5, h = 0.37;
constexpr double EI = E * I, GJ = J * E / (2.0 * (1.0 + nu));

Model empty(AnalysisKind kind)
{
    Model model;
    model.analysis = kind;
    model.add(Material{.id = "steel", .E = E, .nu = nu, .alpha = alpha});
    model.add(Section{.id = "s", .A = A, .Iz = I, .Iy = I, .J = J, .h = h});
    model.add(LoadCase{.id = "P"});
    return model;
}

/// Adds n equal members from the last node to a point, and returns the last of its nodes.
NodeId add_leg(Model& model, const Eigen::Vector3d& to, std::size_t n, const Member& like = {})
{
    const NodeId first(model.nodes.size() - 1);
    const Eigen::Vector3d from(model[first].at[0], model[first].at[1], model[first].at[2]);
    for (std::size_t i = 1; i <= n; ++i) {
        const Eigen::Vector3d at = from + (to - from) * (static_cast<double>(i) / static_cast<double>(n));
        const NodeId next = model.add(
            Node{.id = "N" + std::to_string(model.nodes.size()), .at = {at[0], at[1], at[2]}});
        Member member = like;
        member.id = "M" + std::to_string(model.members.size());
        member.nodes = {NodeId(next.index - 1), next};
        member.material = MaterialId(0);
        member.section = SectionId(0);
        model.add(member);
    }
    return NodeId(model.nodes.size() - 1);
}

Support held(std::initializer_list<Dof> dofs) { return {.fixed = DofSet(dofs)}; }

/// A row of n equal members along x from a fixed end, and nothing else.
Model row(AnalysisKind kind, std::size_t n, double L, const Member& like = {})
{
    Model model = empty(kind);
    model.add(Node{.id = "N0", .at = {0.0, 0.0, 0.0}, .support = Support{.kind = SupportKind::Fixed}});
    add_leg(model, {L, 0.0, 0.0}, n, like);
    return model;
}

void pull(Model& model, NodeId node, Dof dof, double value)
{
    model.load_cases[0].nodes.push_back({.node = node, .components = {{.dof = dof, .value = value}}});
}

NodeId last(const Model& model) { return NodeId(model.nodes.size() - 1); }

constexpr double tolerance = 1e-8;

auto close_to(double value) { return doctest::Approx(value).epsilon(tolerance); }

} // namespace

TEST_SUITE("long chains")
{
    TEST_CASE("A cantilever of n members sags P L^3 / 3 E I at its tip and is held by P and P L, for n up to 30 000")
    {
        constexpr double P = -1.7;
        for (const std::size_t n : {100, 1000, 3000, 10000, 30000})
            for (const double L : {10.0, 100.0}) {
                CAPTURE(n);
                CAPTURE(L);
                Model model = row(AnalysisKind::Frame2d, n, L);
                pull(model, last(model), Dof::uy, P);
                const Results results = analyse(model);
                const CaseResult result = results.at("P");
                CHECK(result.displacement(last(model))[1] == close_to(P * L * L * L / (3.0 * EI)));
                CHECK(result.displacement(last(model))[5] == close_to(P * L * L / (2.0 * EI)));
                CHECK(result.reaction(NodeId(0))[1] == close_to(-P));
                CHECK(result.reaction(NodeId(0))[5] == close_to(-P * L));
                const auto half = n / 2;
                const Curve middle = result.curve(MemberId(half));
                const double x = static_cast<double>(half) * L / static_cast<double>(n);
                CHECK(middle.forces(0.0).Mz == close_to(P * (L - x)));
                CHECK(middle.forces(0.0).Vy == close_to(-P));
                CHECK(result.equilibrium().residual < 1e-10);
                CHECK(results.warnings().empty());
            }
    }

    TEST_CASE("Every solver gives the same tip of 3 000 members: P L^3 / 3 E I")
    {
        constexpr double P = 2.3, L = 17.0;
        Model model = row(AnalysisKind::Frame2d, 3000, L);
        pull(model, last(model), Dof::uy, P);
        for (const SolverKind kind : available_solvers()) {
            CAPTURE(name(kind));
            const Results results = analyse(model, {.solver = kind});
            CHECK(results.at("P").displacement(last(model))[1] == close_to(P * L * L * L / (3.0 * EI)));
        }
    }

    TEST_CASE("An L of two legs of 5 000 members: the corner turns P b a / E I, the tip sags P b^2 (3 a + b) / 3 E I")
    {
        constexpr double P = -3.1, a = 7.0, b = 5.0;
        constexpr std::size_t n = 5000;
        Model model = empty(AnalysisKind::Frame2d);
        model.add(Node{.id = "N0", .at = {0.0, 0.0, 0.0}, .support = Support{.kind = SupportKind::Fixed}});
        const NodeId corner = add_leg(model, {0.0, a, 0.0}, n);
        const NodeId tip = add_leg(model, {b, a, 0.0}, n);
        pull(model, tip, Dof::uy, P);
        const CaseResult result = analyse(model).at("P");
        CHECK(result.displacement(corner)[5] == close_to(P * b * a / EI));
        CHECK(result.displacement(tip)[1] - result.displacement(corner)[1] ==
              close_to(P * b * b * (3.0 * a + b) / (3.0 * EI)));
        CHECK(result.reaction(NodeId(0))[5] == close_to(-P * b));
    }

    TEST_CASE("A skew chain in space: the tip sags P L^3 / 3 E I across, and a torque T turns it T L / G J")
    {
        constexpr double P = 1.9, T = 4.3;
        constexpr std::size_t n = 4000;
        const Eigen::Vector3d along = Eigen::Vector3d(3.0, 5.0, 7.0).normalized();
        const Eigen::Vector3d across = Eigen::Vector3d(5.0, -3.0, 0.0).normalized();
        constexpr double L = 23.0;
        Model model = empty(AnalysisKind::Frame3d);
        model.add(Node{.id = "N0", .at = {0.0, 0.0, 0.0}, .support = Support{.kind = SupportKind::Fixed}});
        add_leg(model, L * along, n);
        for (int i = 0; i < 3; ++i) {
            pull(model, last(model), all_dofs[static_cast<std::size_t>(i)], P * across[i]);
            pull(model, last(model), all_dofs[static_cast<std::size_t>(3 + i)], T * along[i]);
        }
        const NodeVector u = analyse(model).at("P").displacement(last(model));
        CHECK(across.dot(Eigen::Vector3d(u[0], u[1], u[2])) == close_to(P * L * L * L / (3.0 * EI)));
        CHECK(along.dot(Eigen::Vector3d(u[3], u[4], u[5])) == close_to(T * L / GJ));
    }

    TEST_CASE("A beam of a grillage sags P L^3 / 3 E I over 6 000 members")
    {
        constexpr double P = -2.9, L = 13.0;
        Model model = row(AnalysisKind::Grillage, 6000, L);
        pull(model, last(model), Dof::uz, P);
        CHECK(analyse(model).at("P").displacement(last(model))[2] == close_to(P * L * L * L / (3.0 * EI)));
    }

    TEST_CASE("A propped cantilever of 10 000 members: a settlement d of its roller is resisted by 3 E I d / L^3")
    {
        constexpr double d = 0.023, L = 11.0;
        Model model = row(AnalysisKind::Frame2d, 10000, L);
        model.nodes.back().support = held({Dof::uy});
        model.load_cases[0].settlements.push_back({.node = last(model), .components = {{.dof = Dof::uy, .value = -d}}});
        const CaseResult result = analyse(model).at("P");
        CHECK(result.reaction(last(model))[1] == close_to(-3.0 * EI * d / (L * L * L)));
        CHECK(result.reaction(NodeId(0))[5] == close_to(3.0 * EI * d / (L * L)));
    }

    TEST_CASE("A base that turns by t takes a free chain of 10 000 members along, without force: its tip moves t L")
    {
        constexpr double t = 0.0017, L = 100.0;
        Model model = row(AnalysisKind::Frame2d, 10000, L);
        model.load_cases[0].settlements.push_back({.node = NodeId(0), .components = {{.dof = Dof::rz, .value = t}}});
        const Results results = analyse(model);
        CHECK(results.at("P").displacement(last(model))[1] == close_to(t * L));
        CHECK(std::abs(results.at("P").reaction(NodeId(0))[5]) < 1e-12 * EI * t / L);
        CHECK(results.warnings().empty());
    }

    TEST_CASE("A temperature difference dT bends a chain of 10 000 members by alpha dT L^2 / 2 h, without force")
    {
        constexpr double dT = 17.0, L = 31.0;
        Model model = row(AnalysisKind::Frame2d, 10000, L);
        for (std::size_t i = 0; i < model.members.size(); ++i)
            model.load_cases[0].members.push_back(
                {.member = MemberId(i), .load = TemperatureLoad{.top = 0.0, .bottom = dT}});
        const CaseResult result = analyse(model).at("P");
        CHECK(result.displacement(last(model))[1] == close_to(alpha * dT * L * L / (2.0 * h)));
        CHECK(std::abs(result.curve(MemberId(0)).forces(0.0).Mz) < 1e-9 * EI * alpha * dT / h);
    }

    TEST_CASE("A simple beam of 10 000 members under q has q L^2 / 8 and 5 q L^4 / 384 E I at its middle")
    {
        constexpr double q = -4.1, L = 19.0;
        constexpr std::size_t n = 10000;
        Model model = row(AnalysisKind::Frame2d, n, L);
        model.nodes.front().support = held({Dof::ux, Dof::uy});
        model.nodes.back().support = held({Dof::uy});
        for (std::size_t i = 0; i < n; ++i)
            model.load_cases[0].members.push_back(
                {.member = MemberId(i), .load = DistributedLoad{.values = {{.dof = Dof::uy, .start = q}}}});
        const CaseResult result = analyse(model).at("P");
        CHECK(result.displacement(NodeId(n / 2))[1] == close_to(5.0 * q * std::pow(L, 4) / (384.0 * EI)));
        CHECK(result.curve(MemberId(n / 2)).forces(0.0).Mz == close_to(-q * L * L / 8.0));
        CHECK(result.reaction(NodeId(0))[1] == close_to(-q * L / 2.0));
    }

    TEST_CASE("A chain of 10 000 members on springs at its base sags P (L^2 / c + 1 / k + L^3 / 3 E I)")
    {
        constexpr double P = -0.7, L = 12.0, c = 310.0, k = 47.0;
        Model model = row(AnalysisKind::Frame2d, 10000, L);
        model.nodes.front().support = Support{
            .fixed = {Dof::ux}, .springs = {{.dof = Dof::uy, .stiffness = k}, {.dof = Dof::rz, .stiffness = c}}};
        pull(model, last(model), Dof::uy, P);
        const CaseResult result = analyse(model).at("P");
        CHECK(result.displacement(last(model))[1] == close_to(P * (L * L / c + 1.0 / k + L * L * L / (3.0 * EI))));
        CHECK(result.reaction(NodeId(0))[5] == close_to(-P * L));
    }

    TEST_CASE("A chain of n members with a spring c at the end of each sags P (L^3 / 3 E I + sum (L - x)^2 / c)")
    {
        constexpr double P = -0.9, L = 100.0, c = 5.0e4;
        for (const std::size_t n : {1000, 10000}) {
            CAPTURE(n);
            Member sprung;
            sprung.end.springs = {{.dof = Dof::rz, .stiffness = c}};
            Model model = row(AnalysisKind::Frame2d, n, L, sprung);
            pull(model, last(model), Dof::uy, P);
            double turns = 0.0; // of the springs, each at L - x = i L / n
            for (std::size_t i = 1; i < n; ++i)
                turns += std::pow(static_cast<double>(i) * L / static_cast<double>(n), 2.0) / c;
            const Results results = analyse(model);
            const CaseResult result = results.at("P");
            CHECK(result.displacement(last(model))[1] == close_to(P * (L * L * L / (3.0 * EI) + turns)));
            CHECK(result.reaction(NodeId(0))[1] == close_to(-P));
            CHECK(result.reaction(NodeId(0))[5] == close_to(-P * L));
            CHECK(results.warnings().empty());
        }
    }

    TEST_CASE("Inextensible members in a row are no more of a mechanism than elastic ones: nothing is warned of")
    {
        for (const std::size_t n : {100, 300, 3000}) {
            CAPTURE(n);
            const double L = static_cast<double>(n);
            Model model = row(AnalysisKind::Frame2d, n, L, {.inextensible = true});
            const double P = 1e-3 * EI / (L * L);
            pull(model, last(model), Dof::uy, P);
            const Results results = analyse(model);
            CHECK(results.warnings().empty());
            CHECK(results.at("P").displacement(last(model))[1] == close_to(P * L * L * L / (3.0 * EI)));
        }
    }

    TEST_CASE("Inextensible members bend alike, and 400 rigid ones carry P (L - x) without moving")
    {
        constexpr double P = 1.3, L = 9.0;
        Model bending = row(AnalysisKind::Frame2d, 1000, L, Member{.inextensible = true});
        pull(bending, last(bending), Dof::uy, P);
        CHECK(analyse(bending).at("P").displacement(last(bending))[1] == close_to(P * L * L * L / (3.0 * EI)));

        constexpr std::size_t n = 400;
        Model rigid = row(AnalysisKind::Frame2d, n, L, Member{.rigid = true});
        pull(rigid, last(rigid), Dof::uy, P);
        const CaseResult result = analyse(rigid).at("P");
        CHECK(result.displacement(last(rigid))[1] == 0.0);
        CHECK(result.curve(MemberId(n / 4)).forces(0.0).Mz == close_to(0.75 * P * L));
        CHECK(result.reaction(NodeId(0))[5] == close_to(-P * L));
    }

    TEST_CASE(
        "A chain of 10 000 members on a foundation sinks P l / 2 k under a load far from its ends, l^4 = k / 4 E I")
    {
        constexpr double P = -6.1, k = 5000.0, L = 60.0;
        constexpr std::size_t n = 10000;
        const double l = std::pow(k / (4.0 * EI), 0.25);
        Model model = row(AnalysisKind::Frame2d, n, L, Member{.foundation = Quantity(k)});
        pull(model, NodeId(n / 2), Dof::uy, P);
        const Results results = analyse(model);
        CHECK(results.at("P").displacement(NodeId(n / 2))[1] == close_to(P * l / (2.0 * k)));
        CHECK(results.at("P").curve(MemberId(n / 2)).forces(0.0).Mz == close_to(-P / (4.0 * l)));
        CHECK(results.at("P").equilibrium().sum_reactions[1] == close_to(-P));
        CHECK(results.warnings().empty());
    }

    TEST_CASE("Two cantilevers of 2 000 members meet in a hinge under P: it sags P L^3 / 6 E I")
    {
        constexpr double P = -5.3, L = 8.0;
        constexpr std::size_t n = 2000;
        Model model = row(AnalysisKind::Frame2d, n, L);
        const NodeId middle = last(model);
        model.nodes[middle.index].hinge = true;
        const NodeId end = add_leg(model, {2.0 * L, 0.0, 0.0}, n);
        model.nodes[end.index].support = Support{.kind = SupportKind::Fixed};
        pull(model, middle, Dof::uy, P);
        const CaseResult result = analyse(model).at("P");
        CHECK(result.displacement(middle)[1] == close_to(0.5 * P * L * L * L / (3.0 * EI)));
        CHECK(result.reaction(NodeId(0))[5] == close_to(-0.5 * P * L));
        CHECK(result.reaction(end)[1] == close_to(-0.5 * P));
    }

    TEST_CASE("A first member of 7e-16 m beside one of 10 m: the fixed end holds P and P L all the same")
    {
        constexpr double P = -100.0, L = 10.0;
        for (const double tiny : {1e-3, 1e-8, 6.7e-16}) {
            CAPTURE(tiny);
            Model model = row(AnalysisKind::Frame2d, 1, tiny);
            add_leg(model, {L, 0.0, 0.0}, 1);
            pull(model, last(model), Dof::uy, P);
            const CaseResult result = analyse(model).at("P");
            CHECK(result.reaction(NodeId(0))[1] == close_to(-P));
            CHECK(result.reaction(NodeId(0))[5] == close_to(-P * L));
            CHECK(result.displacement(last(model))[1] == close_to(P * L * L * L / (3.0 * EI)));
        }
    }

    TEST_CASE("A support that settles beside a very short member is resisted by 12 E I d / L^3, or it is refused")
    {
        const double L = 8.0, d = 0.01;
        for (const double first : {1e-3, 1e-5, 1e-7, 1e-8, 1e-9, 1e-11}) {
            CAPTURE(first);
            Model model = row(AnalysisKind::Frame2d, 1, first);
            add_leg(model, {L, 0.0, 0.0}, 1);
            model.nodes[2].support = Support{.kind = SupportKind::Fixed};
            model.load_cases[0].settlements.push_back(
                {.node = NodeId(0), .components = {{.dof = Dof::uy, .value = -d}}});
            try {
                const Results results = analyse(model);
                const CaseResult result = results[CaseId(0)];
                const double exact = 12.0 * EI * d / (L * L * L), close = results.warnings().empty() ? 1e-6 : 1e-2;
                CHECK(result.reaction(NodeId(0))[1] == doctest::Approx(-exact).epsilon(close));
                CHECK(result.reaction(NodeId(0))[5] == doctest::Approx(-0.5 * exact * L).epsilon(close));
                CHECK(result.reaction(NodeId(2))[1] == doctest::Approx(exact).epsilon(close));
            } catch (const ModelError& error) {
                CHECK(first < 1e-7);
                CHECK(error.faults().front().kind == FaultKind::IllConditionedCase);
            }
        }
    }

    TEST_CASE("A member too short for numbers to follow the others is refused as such, not as a mechanism")
    {
        for (const double tiny : {1e-25, 1e-32, 1e-40, 1e-60})
            for (const double before : {-4.0, -9.0}) {
                CAPTURE(tiny);
                Model model = empty(AnalysisKind::Frame2d);
                model.add(Node{.id = "N0", .at = {before, 0.0, 0.0}, .support = Support{.kind = SupportKind::Fixed}});
                for (const double x : {0.0, tiny, 5.0}) add_leg(model, {x, 0.0, 0.0}, 1);
                pull(model, NodeId(3), Dof::uy, -100.0);
                try {
                    analyse(model);
                    CHECK(false);
                } catch (const ModelError& error) {
                    CHECK(error.faults().front().kind == FaultKind::IllConditionedCase);
                }
            }
    }

    TEST_CASE("A settlement that drowns the loads in a beam of enormous stiffness is refused, or its sums balance")
    {
        for (const double stiffer : {1.0, 1e10, 1e20, 1e30, 1e60}) {
            CAPTURE(stiffer);
            Model model = row(AnalysisKind::Frame2d, 1, 4.0);
            model.sections[0].Iz = I * stiffer;
            add_leg(model, {9.0, 0.0, 0.0}, 1);
            model.nodes[0].support = Support{.kind = SupportKind::Pin};
            model.nodes[2].support = Support{.fixed = DofSet({Dof::uy}), .springs = {{Dof::rz, 100.0}}};
            model.load_cases[0].settlements.push_back(
                {.node = NodeId(0), .components = {{.dof = Dof::uy, .value = 0.001}}});
            for (const double load : {-3.0, 0.0}) {
                model.load_cases[0].nodes.clear();
                if (load != 0.0) pull(model, NodeId(1), Dof::uy, load);
                try {
                    const Equilibrium sums = analyse(model)[CaseId(0)].equilibrium();
                    CHECK(std::abs(sums.sum_reactions[1] + load) < 1e-6);
                    CHECK(stiffer < 1e29);
                } catch (const ModelError& error) {
                    CHECK(stiffer > 1e11);
                    CHECK(error.faults().front().kind == FaultKind::IllConditionedCase);
                }
            }
        }
    }

    TEST_CASE("Heat bends a simple beam of 3 000 members of unlike lengths by alpha dT L^2 / 8 h")
    {
        const double L = 100.0, dT = 20.0;
        Model model = empty(AnalysisKind::Frame2d);
        model.add(Node{.id = "N0", .at = {0.0, 0.0, 0.0}, .support = Support{.kind = SupportKind::Pin}});
        std::vector<double> places{0.5 * L, L};
        for (int i = 1; i < 3000; ++i) places.push_back(L * std::fmod(0.6180339887498949 * i * i, 1.0));
        std::ranges::sort(places);
        NodeId middle(0);
        for (const double x : places) {
            const NodeId node = add_leg(model, {x, 0.0, 0.0}, 1);
            if (x == 0.5 * L) middle = node;
        }
        model.nodes.back().support = Support{.kind = SupportKind::Roller};
        for (std::size_t i = 0; i < model.members.size(); ++i)
            model.load_cases[0].members.push_back({MemberId(i), TemperatureLoad{.top = 0.0, .bottom = dT}});
        CHECK(analyse(model)[CaseId(0)].displacement(middle)[1] ==
              doctest::Approx(-alpha * dT * L * L / (8.0 * h)).epsilon(1e-8));
    }

    TEST_CASE(
        "A row of rigid members of very unlike lengths on springs is held by them, or refused: never by no number")
    {
        const double L = 100.0, q = -2.0;
        Model model = empty(AnalysisKind::Frame2d);
        Support sprung = held({Dof::ux});
        sprung.springs = {{Dof::uy, 100.0}};
        model.add(Node{.id = "N0", .at = {0.0, 0.0, 0.0}, .support = sprung});
        std::mt19937 dice(5);
        std::vector<double> places{L};
        for (int i = 1; i < 3000; ++i) places.push_back(L * std::ldexp(static_cast<double>(dice()), -32));
        std::ranges::sort(places);
        for (const double x : places) add_leg(model, {x, 0.0, 0.0}, 1, {.rigid = true});
        model.nodes.back().support = Support{.springs = {{Dof::uy, 10.0}}};
        for (std::size_t i = 0; i < model.members.size(); ++i)
            model.load_cases[0].members.push_back(
                {MemberId(i), DistributedLoad{.values = {{.dof = Dof::uy, .start = q}}}});
        try {
            const CaseResult result = analyse(model)[CaseId(0)];
            CHECK(result.reaction(NodeId(0))[1] == doctest::Approx(-0.5 * q * L).epsilon(1e-6));
        } catch (const ModelError& error) {
            CHECK(error.faults().front().kind == FaultKind::IllConditionedCase);
        }
    }

    TEST_CASE("Heat in a row of 10 000 members held at both ends leaves no residual beside their force")
    {
        Model model = row(AnalysisKind::Frame2d, 10000, 100.0);
        model.nodes.back().support = Support{.kind = SupportKind::Fixed};
        for (std::size_t i = 0; i < model.members.size(); ++i)
            model.load_cases[0].members.push_back({MemberId(i), TemperatureLoad{.top = 10.0, .bottom = 30.0}});
        const CaseResult result = analyse(model)[CaseId(0)];
        CHECK(result.reaction(NodeId(0))[0] == doctest::Approx(E * A * alpha * 20.0).epsilon(1e-8));
        CHECK(result.equilibrium().residual < 1e-9);
    }

    TEST_CASE("A member of 0.1 mm at the middle of a beam of 8 m bends it by P L^3 / 48 E I, and nothing is warned of")
    {
        constexpr double P = -10.0, L = 8.0, tiny = 1e-4;
        Model model = row(AnalysisKind::Frame2d, 1, 0.5 * (L - tiny));
        model.nodes[0].support = Support{.kind = SupportKind::Pin};
        const NodeId middle = last(model);
        add_leg(model, {0.5 * (L + tiny), 0.0, 0.0}, 1);
        const NodeId end = add_leg(model, {L, 0.0, 0.0}, 1);
        model.nodes[end.index].support = Support{.kind = SupportKind::Roller};
        pull(model, middle, Dof::uy, P);
        const Results results = analyse(model);
        CHECK(results.at("P").displacement(middle)[1] == close_to(P * L * L * L / (48.0 * EI)));
        CHECK(results.at("P").reaction(NodeId(0))[1] == close_to(-P * (L + tiny) / (2.0 * L)));
        CHECK(results.warnings().empty());
    }

    TEST_CASE("A combination of cases of a long chain adds them: 1.3 P + 0.7 H")
    {
        constexpr double P = -1.1, H = 2.7, L = 14.0;
        Model model = row(AnalysisKind::Frame2d, 3000, L);
        pull(model, last(model), Dof::uy, P);
        model.add(LoadCase{.id = "H", .nodes = {{.node = last(model), .components = {{.dof = Dof::rz, .value = H}}}}});
        model.combinations.push_back(
            {.id = "C", .terms = {{.of = CaseId(0), .factor = 1.3}, {.of = CaseId(1), .factor = 0.7}}});
        const CaseResult result = analyse(model).at("C");
        CHECK(result.reaction(NodeId(0))[5] == close_to(-(1.3 * P * L + 0.7 * H)));
        CHECK(result.curve(MemberId(0)).forces(0.0).Mz == close_to(1.3 * P * L + 0.7 * H));
        CHECK(result.displacement(last(model))[1] ==
              close_to(1.3 * P * L * L * L / (3.0 * EI) + 0.7 * H * L * L / (2.0 * EI)));
    }
}
