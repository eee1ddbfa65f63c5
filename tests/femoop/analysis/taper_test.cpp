// Tapered members in a structure; closed forms of one beam are in tests/femoop/element/taper_test.cpp.
#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/force_method/force_method.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/model/check/check.h"

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

    TEST_CASE("The force method, which integrates products with one EI, refuses it by name")
    {
        Model model = two_spans();
        model.add(LoadCase{.id = "P", .nodes = {{.node = NodeId(1), .components = {{Dof::rz, 10.0}}}}});
        const Results results = analyse(model);
        try {
            force_method::solve(model, results, CaseId(0), {});
            FAIL("not refused");
        } catch (const ModelError& error) {
            CHECK(error.faults().front().kind == FaultKind::WorkOfTaperedMember);
            CHECK(message(error.faults().front()).find("member AB is tapered") != std::string::npos);
        }
    }
}
