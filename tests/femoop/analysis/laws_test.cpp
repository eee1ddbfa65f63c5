// Laws that every linear structure obeys, whatever its members: checked on structures made at random.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/split.h"
#include "femoop/result/curve_reader.h"
#include "tests/femoop/analysis/random_structure.h"

using namespace femoop;

namespace {

constexpr unsigned n_seeds = 12;

template <class Law> void for_every_structure(Law&& law)
{
    for (const AnalysisKind kind : every_model)
        for (unsigned seed = 1; seed <= n_seeds; ++seed) {
            CAPTURE(name(kind));
            CAPTURE(seed);
            law(random_structure(kind, seed));
        }
}

/// Force and moment that a section puts on the part before it, along global axes.
struct SectionWrench {
    Eigen::Vector3d force, moment;
};

SectionWrench at_section(const SectionForces& s, const MemberGeometry& frame)
{
    // on the face whose normal is +x': N along x', Vy along -y', Vz along -z'; T, Mz as vectors along x', z', My along
    // -y'
    return {.force = frame.axes.transpose() * Eigen::Vector3d(s.N, -s.Vy, -s.Vz),
            .moment = frame.axes.transpose() * Eigen::Vector3d(s.T, -s.My, s.Mz)};
}

Eigen::Vector3d position(const Model& model, NodeId node)
{
    return {model[node].at[0], model[node].at[1], is_3d(model.analysis) ? model[node].at[2].value() : 0.0};
}

double size_of(const NodeVector& v)
{
    double size = 0.0;
    for (const double x : v) size = std::max(size, std::abs(x));
    return size;
}

/// The largest displacement difference between two results, over the largest displacement.
double difference(const CaseResult& a, const CaseResult& b, std::size_t n_nodes)
{
    double largest = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < n_nodes; ++i) {
        const NodeVector u = a.displacement(NodeId(i)), v = b.displacement(NodeId(i));
        for (std::size_t k = 0; k < n_dofs; ++k) {
            largest = std::max(largest, std::abs(u[k]));
            apart = std::max(apart, std::abs(u[k] - v[k]));
        }
    }
    return apart / largest;
}

/// Turns the components of a load about the z axis.
template <class Get, class Put> void turn(double angle, Get&& get, Put&& put)
{
    const double c = std::cos(angle), s = std::sin(angle);
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}}) {
        const double x = get(first), y = get(first + 1);
        put(first, c * x - s * y);
        put(first + 1, s * x + c * y);
    }
}

std::vector<Component> turned(const std::vector<Component>& components, double angle)
{
    NodeVector v{};
    for (const Component& c : components) v[index(c.dof)] += c.value;
    turn(
        angle, [&](std::size_t i) { return v[i]; }, [&](std::size_t i, double x) { v[i] = x; });
    std::vector<Component> all;
    for (const Dof dof : all_dofs)
        if (v[index(dof)] != 0.0) all.push_back({.dof = dof, .value = v[index(dof)]});
    return all;
}

void turn_distributed(DistributedLoad& load, double angle)
{
    NodeVector start{}, end{};
    for (const DistributedLoad::Value& value : load.values) {
        start[index(value.dof)] += value.start;
        end[index(value.dof)] += value.end ? *value.end : value.start;
    }
    turn(
        angle, [&](std::size_t i) { return start[i]; }, [&](std::size_t i, double x) { start[i] = x; });
    turn(
        angle, [&](std::size_t i) { return end[i]; }, [&](std::size_t i, double x) { end[i] = x; });
    load.values.clear();
    for (const Dof dof : all_dofs)
        if (start[index(dof)] != 0.0 || end[index(dof)] != 0.0)
            load.values.push_back({.dof = dof, .start = start[index(dof)], .end = end[index(dof)]});
}

void turn_member_load(MemberLoad& load, double angle)
{
    if (auto* distributed = std::get_if<DistributedLoad>(&load.load);
        distributed && distributed->axes == LoadAxes::Global)
        turn_distributed(*distributed, angle);
    if (auto* point = std::get_if<PointLoad>(&load.load)) point->components = turned(point->components, angle);
    if (auto* ends = std::get_if<EndLoads>(&load.load)) ends->start = turned(ends->start, angle);
}

std::vector<Quantity> turned(const std::vector<Quantity>& vector, double angle)
{
    std::vector<Quantity> result = vector;
    if (result.empty()) return result;
    result[0] = std::cos(angle) * vector[0] - std::sin(angle) * vector[1];
    result[1] = std::sin(angle) * vector[0] + std::cos(angle) * vector[1];
    return result;
}

/// The same structure with everything turned about the z axis. Its supports must be able to turn.
Model turned(Model model, double angle)
{
    for (Node& node : model.nodes) {
        const double x = node.at[0], y = node.at[1];
        node.at[0] = std::cos(angle) * x - std::sin(angle) * y;
        node.at[1] = std::sin(angle) * x + std::cos(angle) * y;
        if (node.support && !is_3d(model.analysis))
            node.support->angle = node.support->angle + angle * 180.0 / std::numbers::pi;
    }
    for (Member& member : model.members) {
        member.start.offset = turned(member.start.offset, angle);
        member.up = turned(member.up, angle);
    }
    for (LoadCase& load_case : model.load_cases) {
        for (NodeLoad& load : load_case.nodes) load.components = turned(load.components, angle);
        if (is_3d(model.analysis)) // in plane models they are in the support's axes, which turn with it
            for (Settlement& settlement : load_case.settlements)
                settlement.components = turned(settlement.components, angle);
        for (MemberLoad& load : load_case.members) turn_member_load(load, angle);
    }
    return model;
}

/// Integral of f over [0, L] by Gauss-Legendre with four points: exact for the products of diagrams here.
template <class F> double integral(double from, double to, F&& f)
{
    constexpr std::array<double, 2> x{0.3399810435848563, 0.8611363115940526},
        w{0.6521451548625461, 0.3478548451374538};
    const double half = 0.5 * (to - from), mid = 0.5 * (from + to);
    double sum = 0.0;
    for (std::size_t i = 0; i < 2; ++i) sum += w[i] * (f(mid - half * x[i]) + f(mid + half * x[i]));
    return half * sum;
}

} // namespace

TEST_SUITE("laws")
{
    TEST_CASE("A load straight over a support at the origin goes into it, and balances")
    {
        Model model;
        model.analysis = AnalysisKind::Frame2d;
        model.add(Material{.id = "m", .E = 2.1e8});
        model.add(Section{.id = "s", .A = 0.04, .Iz = 0.006});
        for (const double x : {0.0, 10.0, 22.5, 32.5}) {
            const SupportKind kind = x == 0.0 ? SupportKind::Pin : SupportKind::Roller;
            model.add(Node{.id = std::to_string(x), .at = {x, 0.0, 0.0}, .support = Support{.kind = kind}});
        }
        for (std::size_t i = 0; i < 3; ++i)
            model.add(Member{.id = std::to_string(i),
                             .nodes = {NodeId(i), NodeId(i + 1)},
                             .material = MaterialId(0),
                             .section = SectionId(0)});
        const PointLoad load{.at = Quantity(0.0), .components = {{Dof::uy, -1.0}}};
        model.add(LoadCase{.id = "P", .members = {{MemberId(0), load}}});
        CHECK(analyse(model).at("P").reaction(NodeId(0))[index(Dof::uy)] == doctest::Approx(1.0));
    }

    TEST_CASE("Every node is in equilibrium under its loads, its support and its members")
    {
        for_every_structure([](const Model& model) {
            const Results results = analyse(model);
            const CaseResult result = results.at("P");
            std::vector<Eigen::Vector3d> force(model.nodes.size(), Eigen::Vector3d::Zero());
            std::vector<Eigen::Vector3d> moment = force;
            double largest = 0.0;
            for (const NodeLoad& load : model.load_cases[0].nodes)
                for (const Component& c : load.components)
                    (index(c.dof) < 3 ? force : moment)[load.node.index][index(c.dof) % 3] += c.value;
            for (std::size_t i = 0; i < model.nodes.size(); ++i) {
                const NodeVector r = result.reaction(NodeId(i));
                for (int k = 0; k < 3; ++k) {
                    force[i][k] += r[static_cast<std::size_t>(k)];
                    moment[i][k] += r[static_cast<std::size_t>(k) + 3];
                }
                largest = std::max(largest, size_of(r));
            }
            for (std::size_t i = 0; i < model.members.size(); ++i) {
                const MemberGeometry frame = results.geometry(MemberId(i));
                const Curve curve = result.curve(MemberId(i));
                // Loads on the very ends act on the member: the node feels the section outside of them.
                SectionWrench start = at_section(curve.forces(0.0), frame);
                const SectionWrench end = at_section(curve.forces(curve.length(), Side::Before), frame);
                for (const MemberLoad& load : model.load_cases[0].members)
                    if (load.member == MemberId(i) && std::holds_alternative<EndLoads>(load.load))
                        for (const Component& c : std::get<EndLoads>(load.load).start)
                            (index(c.dof) < 3 ? start.force : start.moment)[index(c.dof) % 3] += c.value;
                const NodeId a = model.members[i].nodes[0], b = model.members[i].nodes[1];
                force[a.index] += start.force;
                moment[a.index] += start.moment + (frame.start - position(model, a)).cross(start.force);
                force[b.index] -= end.force;
                moment[b.index] -= end.moment + (frame.end - position(model, b)).cross(end.force);
                largest = std::max(largest, start.force.norm());
            }
            const DofSet known = dofs(model.analysis);
            for (std::size_t i = 0; i < model.nodes.size(); ++i) {
                CAPTURE(i);
                for (const Dof dof : all_dofs)
                    if (known.contains(dof))
                        CHECK(std::abs((index(dof) < 3 ? force : moment)[i][index(dof) % 3]) < 1e-8 * largest);
            }
        });
    }

    TEST_CASE("Loads and reactions balance as a whole")
    {
        for_every_structure([](const Model& model) {
            const CaseResult result = analyse(model).at("Q");
            const Equilibrium e = result.equilibrium();
            CHECK(e.residual < 1e-9);
            for (std::size_t i = 0; i < n_dofs; ++i)
                CHECK(std::abs(e.sum_loads[i] + e.sum_reactions[i]) < 1e-8 * size_of(e.sum_loads));
        });
    }

    TEST_CASE("Every diagram has the slope that its load and the diagram below give it")
    {
        for_every_structure([](const Model& model) {
            const CaseResult result = analyse(model).at("P");
            for (std::size_t i = 0; i < model.members.size(); ++i) {
                const Curve curve = result.curve(MemberId(i));
                for (const Curve::Piece& piece : curve.pieces()) {
                    const double t = 0.37 * piece.load.length();
                    const double h = 1e-4 * piece.load.length();
                    const auto at = [&](double s) { return curve.forces(piece.load.begin + s); };
                    const auto slope = [&](auto member) { return (at(t + h).*member - at(t - h).*member) / (2.0 * h); };
                    const auto load = [&](LocalAxis axis) {
                        return piece.load.value[index(axis)] + piece.load.slope[index(axis)] * t;
                    };
                    const double k = model.members[i].foundation ? model.members[i].foundation->value() : 0.0;
                    const double v = curve.displacement(piece.load.begin + t).v;
                    const double tolerance = 1e-5 *
                                             (1.0 + std::abs(slope(&SectionForces::Mz)) + std::abs(at(t).N) / h * 1e-9);
                    CHECK(std::abs(slope(&SectionForces::N) + load(LocalAxis::x)) < tolerance);
                    CHECK(std::abs(slope(&SectionForces::T) + load(LocalAxis::rx)) < tolerance);
                    CHECK(std::abs(slope(&SectionForces::Vy) - load(LocalAxis::y) + k * v) < tolerance);
                    CHECK(std::abs(slope(&SectionForces::Vz) - load(LocalAxis::z)) < tolerance);
                    CHECK(std::abs(slope(&SectionForces::Mz) - at(t).Vy + load(LocalAxis::rz)) < tolerance);
                    CHECK(std::abs(slope(&SectionForces::My) - at(t).Vz - load(LocalAxis::ry)) < tolerance);
                }
            }
        });
    }

    TEST_CASE("Betti: the work of P on the displacements of Q is that of Q on those of P")
    {
        for_every_structure([](Model model) {
            for (LoadCase& load_case : model.load_cases) { // node loads alone: their work is a plain sum
                load_case.members.clear();
                load_case.settlements.clear();
                load_case.self_weight = 0.0;
            }
            for (NodeLoad& load : model.load_cases[1].nodes)
                load.node = NodeId(load.node.index == 3 ? 7 : load.node.index);
            const Results results = analyse(model);
            const auto work = [&](std::size_t of, std::size_t on) {
                double sum = 0.0;
                for (const NodeLoad& load : model.load_cases[of].nodes)
                    for (const Component& c : load.components)
                        sum += c.value * results[CaseId(on)].displacement(load.node)[index(c.dof)];
                return sum;
            };
            CHECK(work(0, 1) == doctest::Approx(work(1, 0)).epsilon(1e-9));
        });
    }

    TEST_CASE("A combination is the weighted sum of its cases, section forces and reactions too")
    {
        for_every_structure([](Model model) {
            model.combinations.push_back(
                {.id = "C", .terms = {{.of = CaseId(0), .factor = 1.35}, {.of = CaseId(1), .factor = -0.7}}});
            model.combinations.push_back(
                {.id = "D", .terms = {{.of = CaseId(2), .factor = 2.0}, {.of = CaseId(0), .factor = 0.5}}});
            const Results results = analyse(model);
            const CaseResult p = results.at("P"), q = results.at("Q"), d = results.at("D");
            const double P = 2.0 * 1.35 + 0.5, Q = -1.4;
            for (std::size_t i = 0; i < model.members.size(); ++i) {
                const Curve a = p.curve(MemberId(i)), b = q.curve(MemberId(i)), c = d.curve(MemberId(i));
                for (const MemberComponent what :
                     {MemberComponent::N, MemberComponent::Mz, MemberComponent::v, MemberComponent::My}) {
                    const double x = 0.613 * a.length();
                    const double sum = P * a.value(what, x) + Q * b.value(what, x);
                    const double scale = std::abs(P * a.value(what, x)) + std::abs(Q * b.value(what, x));
                    CHECK(std::abs(c.value(what, x) - sum) <= 1e-7 * scale + 1e-9);
                }
            }
            CHECK(d.reaction(NodeId(0))[1] ==
                  doctest::Approx(P * p.reaction(NodeId(0))[1] + Q * q.reaction(NodeId(0))[1]).epsilon(1e-9));
        });
    }

    TEST_CASE("Nodes and members in another order give the same solution")
    {
        for_every_structure([](const Model& model) {
            Model other = model;
            const std::size_t n = model.nodes.size(), m = model.members.size();
            for (std::size_t i = 0; i < n; ++i) other.nodes[n - 1 - i] = model.nodes[i];
            for (std::size_t i = 0; i < m; ++i) other.members[m - 1 - i] = model.members[i];
            for (Member& member : other.members)
                for (NodeId& node : member.nodes) node = NodeId(n - 1 - node.index);
            for (LoadCase& load_case : other.load_cases) {
                for (NodeLoad& load : load_case.nodes) load.node = NodeId(n - 1 - load.node.index);
                for (Settlement& s : load_case.settlements) s.node = NodeId(n - 1 - s.node.index);
                for (MemberLoad& load : load_case.members) load.member = MemberId(m - 1 - load.member.index);
            }
            const Results a = analyse(model), b = analyse(other);
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t k = 0; k < n_dofs; ++k)
                    CHECK(a.at("P").displacement(NodeId(i))[k] ==
                          doctest::Approx(b.at("P").displacement(NodeId(n - 1 - i))[k]).epsilon(1e-8));
        });
    }

    TEST_CASE("Members that repeat one another, loaded alike or not, give what they give when none follows its like")
    {
        constexpr std::size_t n_bays = 6;
        const auto hall = [](bool are_alike_together) {
            Model model;
            model.add(Material{.id = "steel", .E = 2.1e8});
            model.add(Section{.id = "s", .A = 0.01, .Iz = 1.3e-4});
            model.add(LoadCase{.id = "G"});
            for (std::size_t i = 0; i <= n_bays; ++i)
                for (const double y : {0.0, 4.0})
                    model.add(Node{.id = std::to_string(model.nodes.size()), .at = {5.0 * static_cast<double>(i), y}});
            for (std::size_t i = 0; i <= n_bays; ++i) model.nodes[2 * i].support = Support{.kind = SupportKind::Fixed};
            const auto add = [&](std::string id, std::size_t a, std::size_t b) {
                return model.add(Member{.id = std::move(id),
                                        .nodes = {NodeId(a), NodeId(b)},
                                        .material = MaterialId(0),
                                        .section = SectionId(0)});
            };
            const auto add_column = [&](std::size_t i) { add("C" + std::to_string(i), 2 * i, 2 * i + 1); };
            for (std::size_t i = 0; i <= n_bays && are_alike_together; ++i) add_column(i);
            for (std::size_t i = 0; i < n_bays; ++i) {
                const MemberId beam = add("B" + std::to_string(i), 2 * i + 1, 2 * i + 3);
                if (!are_alike_together) add_column(i);
                constexpr std::array q{-7.0, -7.0, -11.0, 0.0, -7.0, -7.0};
                DistributedLoad load{.values = {{.dof = Dof::uy, .start = q[i]}}};
                if (i == 5) load.to = Quantity(2.0);
                if (q[i] != 0.0) model.load_cases[0].members.push_back({.member = beam, .load = load});
            }
            if (!are_alike_together) add_column(n_bays);
            return model;
        };
        const Model together = hall(true), mixed = hall(false);
        const Results a = analyse(together), b = analyse(mixed);
        CHECK(difference(a.at("G"), b.at("G"), together.nodes.size()) < 1e-12);
        CurveReader reader(a.at("G"));
        for (std::size_t i = 0; i < together.members.size(); ++i) {
            const auto same = std::ranges::find(mixed.members, together.members[i].id, &Member::id);
            const Curve expected = b.at("G").curve(MemberId(static_cast<std::size_t>(same - mixed.members.begin())));
            const Curve& curve = reader.read(MemberId(i));
            CAPTURE(together.members[i].id);
            for (const double x : {0.0, 1.9, 3.1})
                CHECK(curve.forces(x).Mz == doctest::Approx(expected.forces(x).Mz).epsilon(1e-9));
        }
    }

    TEST_CASE("A translated structure moves as before")
    {
        for_every_structure([](const Model& model) {
            Model other = model;
            for (Node& node : other.nodes) {
                node.at[0] = node.at[0] + 37.0;
                node.at[1] = node.at[1] - 19.0;
            }
            CHECK(difference(analyse(model).at("P"), analyse(other).at("P"), model.nodes.size()) < 1e-8);
        });
    }

    TEST_CASE("Every solver gives the same solution")
    {
        for_every_structure([](const Model& model) {
            const Results reference = analyse(model);
            for (const SolverKind solver : available_solvers())
                CHECK(difference(reference.at("P"), analyse(model, {.solver = solver}).at("P"), model.nodes.size()) <
                      1e-8);
        });
    }

    TEST_CASE("Solving again with other loads is solving anew")
    {
        for_every_structure([](const Model& model) {
            Model other = model;
            std::swap(other.load_cases[0].members, other.load_cases[1].members);
            LinearStatic analysis(model);
            analysis.solve(model);
            CHECK(difference(analysis.solve(other).at("P"), analyse(other).at("P"), model.nodes.size()) < 1e-12);
        });
    }

    TEST_CASE("A change of values keeps the order of elimination and gives what a new analysis gives")
    {
        for_every_structure([](const Model& model) {
            Model other = model;
            for (Material& material : other.materials) material.E = Quantity(0.37 * material.E.value());
            other.nodes.back().at[0] = other.nodes.back().at[0] + 0.13;
            LinearStatic analysis(model);
            analysis.solve(model);
            const double ordering = analysis.statistics().order; // seconds: no other analysis takes the very same
            analysis.update(other);
            const bool has_constraints = std::ranges::any_of(
                model.members, [](const Member& member) { return member.inextensible || member.rigid; });
            CHECK((analysis.statistics().order == ordering) == !has_constraints);
            CHECK(difference(analysis.solve(other).at("P"), analyse(other).at("P"), model.nodes.size()) < 1e-12);
        });
    }

    TEST_CASE("A change of supports begins anew, and after a refused one the next is taken")
    {
        for_every_structure([](const Model& model) {
            Model clamped = model, loose = model;
            clamped.nodes.back().support = Support{.kind = SupportKind::Fixed};
            for (Node& node : loose.nodes) node.support.reset();
            for (Member& member : loose.members) member.foundation.reset();
            for (LoadCase& load_case : loose.load_cases) load_case.settlements.clear();
            LinearStatic analysis(model);
            CHECK_THROWS_AS(analysis.update(loose), MechanismError);
            analysis.update(clamped);
            CHECK(difference(analysis.solve(clamped).at("P"), analyse(clamped).at("P"), model.nodes.size()) < 1e-12);
        });
    }

    TEST_CASE("A turned structure turns its solution")
    {
        constexpr double angle = 0.83;
        for_every_structure([](Model model) {
            if (model.analysis == AnalysisKind::Grillage) return;                     // its supports cannot turn
            for (LoadCase& load_case : model.load_cases) load_case.self_weight = 0.0; // gravity stays where it is
            const CaseResult before = analyse(model).at("P"), after = analyse(turned(model, angle)).at("P");
            double largest = 0.0;
            for (std::size_t i = 0; i < model.nodes.size(); ++i)
                largest = std::max(largest, size_of(before.displacement(NodeId(i))));
            for (std::size_t i = 0; i < model.nodes.size(); ++i) {
                NodeVector u = before.displacement(NodeId(i));
                turn(
                    angle, [&](std::size_t k) { return u[k]; }, [&](std::size_t k, double x) { u[k] = x; });
                const NodeVector v = after.displacement(NodeId(i));
                for (std::size_t k = 0; k < n_dofs; ++k) CHECK(std::abs(u[k] - v[k]) < 1e-8 * largest);
            }
        });
    }

    TEST_CASE("A member split in two by a node moves as before")
    {
        for_every_structure([](Model model) {
            if (is_truss(model.analysis)) return; // a node inside a truss member is a hinge
            std::size_t chosen = 0;
            while (model.members[chosen].bar) ++chosen;
            const MemberId id(chosen);
            for (LoadCase& load_case : model.load_cases) {
                std::erase_if(load_case.members, [&](const MemberLoad& load) { return load.member == id; });
                const Dof down = model.analysis == AnalysisKind::Grillage ? Dof::uz : Dof::uy;
                load_case.members.push_back(
                    {.member = id, .load = DistributedLoad{.values = {{.dof = down, .start = -7.0}}}});
            }
            const Results whole = analyse(model);
            Model cut = model;
            split_member(cut, id, 0.5 * whole.geometry(id).length);
            const Results halves = analyse(cut);
            CHECK(difference(whole.at("P"), halves.at("P"), model.nodes.size()) < 1e-7);
            const Curve curve = whole.at("P").curve(id), first = halves.at("P").curve(id);
            CHECK(first.forces(first.length(), Side::Before).Mz ==
                  doctest::Approx(curve.forces(0.5 * curve.length()).Mz).epsilon(1e-6));
        });
    }

    TEST_CASE("Unit load: a displacement is the sum of the products of the diagrams over the stiffnesses")
    {
        for_every_structure([](Model model) {
            make_prismatic(model);
            for (Member& member : model.members) { // what stores energy apart from the diagrams
                member.foundation.reset();
                member.start.springs.clear();
                member.end.springs.clear();
            }
            for (Node& node : model.nodes)
                if (node.support) node.support->springs.clear();
            if (model.analysis == AnalysisKind::Grillage) model.nodes[1].support->fixed.insert(Dof::uz);
            for (LoadCase& load_case : model.load_cases) {
                load_case.settlements.clear();
                load_case.self_weight = 0.0;
                std::erase_if(load_case.members, [](const MemberLoad& load) {
                    return std::holds_alternative<TemperatureLoad>(load.load) ||
                           std::holds_alternative<Misfit>(load.load);
                });
            }
            const Dof dof = model.analysis == AnalysisKind::Grillage ? Dof::uz : Dof::ux;
            model.load_cases[1].members.clear();
            model.load_cases[1].nodes = {{.node = NodeId(8), .components = {{.dof = dof, .value = 1.0}}}};
            const Results results = analyse(model);
            const Material& steel = model.materials[0];
            double sum = 0.0;
            for (std::size_t i = 0; i < model.members.size(); ++i) {
                const Member& member = model.members[i];
                const Section& s = model[*member.section];
                const Curve p = results.at("P").curve(MemberId(i)), unit = results.at("Q").curve(MemberId(i));
                const bool is_sheared = member.theory == BeamTheory::Timoshenko;
                const bool is_bar = member.bar ||
                                    is_truss(model.analysis); // bends as a simple beam, which is not its energy
                const std::vector<double> breaks = p.breaks();
                for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
                    sum += integral(breaks[k], breaks[k + 1], [&](double x) {
                        const SectionForces a = p.forces(x), b = unit.forces(x);
                        double density = a.N * b.N / (steel.E * *s.A);
                        if (is_bar) return density;
                        density += a.Mz * b.Mz / (steel.E * *s.Iz) + a.My * b.My / (steel.E * *s.Iy) +
                                   a.T * b.T / (steel.shear_modulus() * *s.J);
                        if (is_sheared)
                            density += (a.Vy * b.Vy / *s.Asy + a.Vz * b.Vz / *s.Asz) / steel.shear_modulus();
                        return density;
                    });
            }
            CHECK(results.at("P").displacement(NodeId(8))[index(dof)] == doctest::Approx(sum).epsilon(1e-7));
        });
    }
}
