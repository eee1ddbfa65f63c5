// Tapered members in a structure; closed forms of one beam are in tests/femoop/element/taper_test.cpp.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "femoop/methods/force_method/force_method.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/virtual_work/virtual_work.h"
#include "femoop/model/check/check.h"
#include "femoop/model/fault/fault.h"

using namespace femoop;

namespace {

constexpr double h1 = 0.9, h2 = 0.45, width = 0.3, weight = 24.0; // m, kN/m3

doctest::Approx near(double value) { return doctest::Approx(value).epsilon(1e-10); }

/// A fixed A, B, C on one line, 4 m and 5 m apart; both members thin out towards B.
Model haunches()
{
    Model model;
    model.add(Material{.id = "concrete", .E = 3e7, .alpha = 1e-5, .density = weight / 9.80665});
    SectionShape rectangle;
    rectangle.b = width;
    rectangle.h = h1;
    model.add(Section{.id = "haunch", .shape = rectangle});
    model.add(Node{.id = "A", .at = {0.0, 0.0}, .support = Support{.kind = SupportKind::Fixed}});
    model.add(Node{.id = "B", .at = {4.0, 0.0}});
    model.add(Node{.id = "C", .at = {9.0, 0.0}});
    const auto member = [&](const char* id, std::size_t from, std::size_t to, double first, double second) {
        model.add(Member{.id = id,
                         .nodes = {NodeId(from), NodeId(to)},
                         .material = MaterialId(0),
                         .section = SectionId(0),
                         .depths = {first, second}});
    };
    member("AB", 0, 1, h1, h2);
    member("BC", 1, 2, h2, h1);
    return model;
}

Model cantilever()
{
    Model model = haunches();
    model.members.pop_back();
    model.nodes.pop_back();
    return model;
}

/// A fixed, B on a roller, C fixed.
Model two_spans()
{
    Model model = haunches();
    model.nodes[1].support = Support{.kind = SupportKind::Custom, .fixed = {Dof::uy}};
    model.nodes[2].support = Support{.kind = SupportKind::Fixed};
    return model;
}

MovingEffect moment_at(const char* member, const Model& model, double x)
{
    return {.quantity = ExpectedQuantity::SectionForce,
            .member = model.find_member(member),
            .component = MemberComponent::Mz,
            .at = Quantity(x)};
}

} // namespace

TEST_SUITE("tapered members")
{
    TEST_CASE("Its own weight is that of its volume, and acts where the volume lies")
    {
        Model model = cantilever();
        model.add(LoadCase{.id = "G", .self_weight = 1.0});
        const Results results = analyse(model);
        const NodeVector reaction = results[CaseId(0)].reaction(NodeId(0));
        CHECK(reaction[1] == near(weight * width * 0.5 * (h1 + h2) * 4.0));
        CHECK(reaction[5] == near(weight * width * (h2 * 4.0 * 2.0 + 0.5 * (h1 - h2) * 4.0 * 4.0 / 3.0)));
    }

    TEST_CASE("Equal depths make a prismatic member")
    {
        Model tapered = cantilever(), prismatic = cantilever();
        tapered.members[0].depths = {h2, h2};
        prismatic.members[0].depths.clear();
        prismatic.sections[0].shape->h = h2;
        for (Model* model : {&tapered, &prismatic})
            model->add(LoadCase{.id = "P", .nodes = {{.node = NodeId(1), .components = {{Dof::uy, -10.0}}}}});
        CHECK(analyse(tapered)[CaseId(0)].displacement(NodeId(1))[1] ==
              analyse(prismatic)[CaseId(0)].displacement(NodeId(1))[1]);
    }

    TEST_CASE("The ordinates of an influence line are the effects of unit loads that stand there")
    {
        const Model model = two_spans();
        for (const MovingEffect& effect : {moment_at("AB", model, 0.0), moment_at("AB", model, 2.7),
                                           moment_at("BC", model, 1.3), moment_at("BC", model, 5.0)}) {
            influence::InfluenceAnalysis analysis(model);
            const auto line = analysis.line(influence::lay_out(model, {{MemberId(0), MemberId(1)}}),
                                            influence::unit_load(model.analysis, {}), effect);
            for (const double s : {0.9, 2.2, 3.8, 4.7, 6.1, 8.3}) {
                Model loaded = model;
                const bool is_first = s < 4.0;
                loaded.add(LoadCase{.id = "1",
                                    .members = {{.member = MemberId(is_first ? 0 : 1),
                                                 .load = PointLoad{.at = Quantity(is_first ? s : s - 4.0),
                                                                   .components = {{Dof::uy, -1.0}}}}}});
                const Results results = analyse(loaded);
                CAPTURE(s);
                CHECK(line.ordinates.value(s) ==
                      doctest::Approx(influence::effect_in(effect, results[CaseId(0)])).epsilon(1e-9));
            }
        }
    }

    TEST_CASE("The force method integrates products along a taper: its redundants are those of the analysis")
    {
        Model model = two_spans();
        LoadCase load_case{.id = "P", .self_weight = 1.0};
        load_case.nodes.push_back({.node = NodeId(1), .components = {{Dof::rz, 10.0}}});
        load_case.members.push_back({.member = MemberId(0), .load = TemperatureLoad{.top = 30.0, .bottom = -10.0}});
        model.add(load_case);
        const Results results = analyse(model);
        const auto method = force_method::solve(model, results, CaseId(0), {});
        CHECK(method.n_redundants() == 4);
        CHECK((method.X - method.analysed).norm() <= 1e-9 * method.analysed.norm());
    }

    TEST_CASE("The work at a tapered cantilever's tip is the integral of P x^2 / EI(x), in one row for each force")
    {
        constexpr double P = 60.0, L = 4.0, E = 3e7;
        Model model = cantilever();
        model.add(LoadCase{.id = "P", .nodes = {{.node = NodeId(1), .components = {{Dof::uy, -P}}}}});
        const MovingEffect tip{.quantity = ExpectedQuantity::Displacement, .node = NodeId(1), .dof = Dof::uy, .at = {}};
        const auto work = virtual_work::displacement_by_work(model, analyse(model), CaseId(0), tip);
        // h = h2 + g s at the distance s from the tip: int s^2 / h^3 ds = [ln h + 2 h2 / h - h2^2 / (2 h^2)] / g^3
        const double g = (h1 - h2) / L;
        const auto primitive = [&](double h) { return std::log(h) + 2.0 * h2 / h - h2 * h2 / (2.0 * h * h); };
        const double v = -12.0 * P / (E * width) * (primitive(h1) - primitive(h2)) / (g * g * g);
        const auto bending = [](const virtual_work::WorkIntegral& one) { return one.force == MemberComponent::Mz; };
        CHECK(std::ranges::count_if(work.work.integrals, bending) == 1);
        const auto row = std::ranges::find_if(work.work.integrals, bending);
        CHECK(row->to == L);
        CHECK(row->value == near(v));
        CHECK(work.sum == near(work.value));
    }

    TEST_CASE("Heat bends a taper by alpha dT / h(x), and virtual work says so")
    {
        Model model = cantilever();
        LoadCase heat{.id = "heat"};
        heat.members.push_back({.member = MemberId(0), .load = TemperatureLoad{.top = 20.0, .bottom = -10.0}});
        model.add(heat);
        const MovingEffect tip{.quantity = ExpectedQuantity::Displacement, .node = NodeId(1), .dof = Dof::rz, .at = {}};
        const auto work = virtual_work::displacement_by_work(model, analyse(model), CaseId(0), tip);
        const std::string text = virtual_work_text(work, model, english);
        CHECK(text.find(" -0.000333333 / (1 - 0.125 x) ") != std::string::npos); // 1e-5 30 / 0.9, 0.45 / (4 0.9)
        const std::string latex = virtual_work_latex(work, model, english);
        CHECK(latex.find("$\\varepsilon(x) = \\frac{-0.000333333}{1 - 0.125 x}$") != std::string::npos);
        CHECK(latex.find("\\varepsilon(x) f") != std::string::npos);
        CHECK(work.sum == near(-1e-5 * 30.0 / (h1 - h2) * 4.0 * std::log(h1 / h2)));
    }
}
