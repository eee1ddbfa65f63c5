#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "femoop/analysis/linear_static.h"

using namespace femoop;

namespace {

/// A plane frame from coordinates and pairs of nodes; supports and releases are added by the tests.
Model frame(const std::vector<std::pair<double, double>>& nodes,
            const std::vector<std::pair<std::size_t, std::size_t>>& members)
{
    Model model;
    model.add(Material{.id = "steel", .E = 2.1e8});
    model.add(Section{.id = "beam", .A = 0.01, .Iz = 1.3e-4});
    for (const auto& [x, y] : nodes)
        model.add(Node{.id = std::string(1, static_cast<char>('A' + model.nodes.size())), .at = {x, y, 0.0}});
    for (const auto& [a, b] : members)
        model.add(Member{.id = model.nodes[a].id + model.nodes[b].id,
                         .nodes = {NodeId(a), NodeId(b)},
                         .material = MaterialId(0),
                         .section = SectionId(0)});
    model.add(LoadCase{.id = "G"});
    return model;
}

void hold(Model& model, std::size_t node, SupportKind kind) { model.nodes[node].support = Support{.kind = kind}; }

/// Three space members of length 3 h in a row along (1, 2, 2) / 3, from A to D, hinged at the fixed ends A and D.
Model skew_chain(double h)
{
    Model model = frame({{0, 0}, {h, 2 * h}, {2 * h, 4 * h}, {3 * h, 6 * h}}, {{0, 1}, {1, 2}, {2, 3}});
    model.analysis = AnalysisKind::Frame3d;
    model.sections[0].Iy = 0.7e-4;
    model.sections[0].J = 0.3e-4;
    for (Node& node : model.nodes) node.at[2] = node.at[1];
    for (const std::size_t end : {0U, 3U}) {
        hold(model, end, SupportKind::Fixed);
        model.nodes[end].hinge = true;
    }
    return model;
}

std::vector<Mechanism> motions(const Model& model)
{
    try {
        analyse(model);
    } catch (const MechanismError& error) {
        return error.mechanisms();
    }
    return {};
}

std::vector<std::string> mechanisms(const Model& model)
{
    std::vector<std::string> sentences;
    for (const Mechanism& mechanism : motions(model)) sentences.push_back(message(mechanism.fault));
    return sentences;
}

/// Why the structure is not held as a rigid body.
std::vector<std::string> causes(const Model& model)
{
    std::vector<std::string> sentences;
    try {
        analyse(model);
    } catch (const MechanismError& error) {
        for (const Fault& cause : error.causes()) sentences.push_back(message(cause));
    } catch (const ModelError& error) {
        for (const Fault& fault : error.faults()) sentences.push_back(message(fault));
    }
    return sentences;
}

} // namespace

TEST_SUITE("mechanisms")
{
    TEST_CASE("A row of pinned columns with hinged beams sways, and the words say so")
    {
        Model model = frame({{0, 0}, {6, 0}, {12, 0}, {0, 4}, {6, 4}, {12, 4}},
                            {{0, 3}, {1, 4}, {2, 5}, {3, 4}, {4, 5}});
        for (const std::size_t base : {0, 1, 2}) hold(model, base, SupportKind::Pin);
        for (const std::size_t top : {3, 4, 5}) model.nodes[top].hinge = true;
        CHECK(mechanisms(model) ==
              std::vector<std::string>{
                  "the structure can move without strain: nodes D, E and F sway to the right together; nothing "
                  "holds ux; add a brace or a support"});
    }

    TEST_CASE("A hinge too many in a beam is a mechanism whatever the lengths and the slope, loaded or not")
    {
        for (const AnalysisKind kind : {AnalysisKind::Frame2d, AnalysisKind::Grillage, AnalysisKind::Frame3d})
            for (int i = 0; i < 60; ++i) {
                const double a = 0.31 * (i % 7) + 1.0, b = 0.17 * (i % 11) + 0.4, slope = 0.13 * (i % 5);
                Model model = frame({{0, 0},
                                     {3, 3 * slope},
                                     {3 + a, (3 + a) * slope},
                                     {3 + a + b, (3 + a + b) * slope},
                                     {5 + a + b, (5 + a + b) * slope}},
                                    {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
                model.analysis = kind;
                model.sections[0].Iy = 0.7e-4;
                model.sections[0].J = 0.3e-4;
                for (const std::size_t end : {0U, 4U}) hold(model, end, SupportKind::Fixed);
                for (const std::size_t inner : {1U, 2U, 3U}) model.nodes[inner].hinge = true;
                const Dof down = kind == AnalysisKind::Grillage ? Dof::uz : Dof::uy;
                if (i % 2 == 0) model.load_cases[0].nodes.push_back({NodeId(2), {{down, -10.0}}});
                CAPTURE(name(kind));
                CAPTURE(i);
                CHECK_FALSE(mechanisms(model).empty());
            }
    }

    TEST_CASE("A brace holds that sway")
    {
        Model model = frame({{0, 0}, {6, 0}, {0, 4}, {6, 4}}, {{0, 2}, {1, 3}, {2, 3}, {0, 3}});
        for (const std::size_t base : {0, 1}) hold(model, base, SupportKind::Pin);
        for (const std::size_t top : {2, 3}) model.nodes[top].hinge = true;
        CHECK(mechanisms(model).empty());
    }

    TEST_CASE("A frame on one roller has two free motions, each told apart")
    {
        Model model = frame({{0, 0}, {4, 0}, {4, 3}}, {{0, 1}, {1, 2}});
        hold(model, 0, SupportKind::Roller);
        const std::vector<std::string> sentences = mechanisms(model);
        REQUIRE(sentences.size() == 2);
        CHECK(sentences[0].find("A, B and C sway to the right together") != std::string::npos);
        CHECK(sentences[1].find("turn together about (0, ") != std::string::npos);
        CHECK(sentences[1].find(") m; add") != std::string::npos);
    }

    TEST_CASE("Nodes of a grillage move up and down, never in its plane")
    {
        Model model = frame({{0, 0}, {4.2, 0.3}, {3.1, 2.7}}, {{0, 1}, {1, 2}});
        model.analysis = AnalysisKind::Grillage;
        model.sections[0].Iy = 0.7e-4;
        model.sections[0].J = 0.3e-4;
        const std::vector<std::string> sentences = mechanisms(model);
        REQUIRE(sentences.size() == 3);
        const auto n_with = [&](std::string_view words) {
            return std::ranges::count_if(sentences, [&](const std::string& s) { return s.find(words) != s.npos; });
        };
        CHECK(n_with("along (0, 0)") == 0);
        CHECK(n_with("along (0, 0, 1)") + n_with("along z") == 3);
    }

    TEST_CASE("A beam on one pin is no structure that holds, however short a member in it and however far off it lies")
    {
        for (const double shortest : {1e-4, 1e-6, 1e-8, 1e-10}) {
            std::vector<std::pair<double, double>> places;
            for (const double along : {0.0, 4.0, 4.0 + shortest, 8.0})
                places.emplace_back(1e4 + 0.8253 * along, 3e3 + 0.5646 * along);
            Model model = frame(places, {{0, 1}, {1, 2}, {2, 3}});
            hold(model, 0, SupportKind::Pin);
            model.load_cases[0].nodes.push_back({NodeId(3), {{Dof::uy, -1.0}}});
            CAPTURE(shortest);
            CHECK(causes(model) ==
                  std::vector<std::string>{"the supports hold 2 of the 3 ways in which the structure can move as a "
                                           "whole; add supports, or let them act in other directions"});
        }
    }

    TEST_CASE("A structure without support, or without enough of it, is told so before its motions")
    {
        Model model = frame({{0, 0}, {4, 0}, {4, 3}}, {{0, 1}, {1, 2}});
        CHECK(causes(model) == std::vector<std::string>{"no node is supported, so nothing keeps the structure from "
                                                        "moving as a whole; add supports"});
        CHECK(mechanisms(model).size() == 3);
        hold(model, 0, SupportKind::Roller);
        hold(model, 1, SupportKind::Roller);
        CHECK(causes(model) ==
              std::vector<std::string>{"the supports hold 2 of the 3 ways in which the structure can move as a whole; "
                                       "add supports, or let them act in other directions"});
        hold(model, 1, SupportKind::Pin);
        CHECK(causes(model).empty());
        model.nodes[0].support->angle = 90.0; // acts along AB, as the pin does already
        CHECK(causes(model).size() == 1);
        model.nodes[0].support = Support{.springs = {{.dof = Dof::rz, .stiffness = 5.0}}};
        CHECK(causes(model).empty());
    }

    TEST_CASE("A frame of 70 bays and storeys on rollers is refused, however many roundings its elimination took")
    {
        constexpr std::size_t n = 70;
        Model model = frame({}, {});
        for (std::size_t y = 0; y <= n; ++y)
            for (std::size_t x = 0; x <= n; ++x) {
                model.add(Node{.id = std::to_string(x) + "_" + std::to_string(y),
                               .at = {6.0 * static_cast<double>(x), 3.0 * static_cast<double>(y), 0.0}});
                if (y == 0) hold(model, x, SupportKind::Roller);
            }
        const auto join = [&](std::size_t a, std::size_t b) {
            model.add(Member{.id = model.nodes[a].id + "-" + model.nodes[b].id,
                             .nodes = {NodeId(a), NodeId(b)},
                             .material = MaterialId(0),
                             .section = SectionId(0)});
        };
        for (std::size_t here = n + 1; here < (n + 1) * (n + 1); ++here) {
            join(here - n - 1, here);
            if (here % (n + 1) > 0) join(here - 1, here);
        }
        for (const SolverKind solver : {SolverKind::Skyline, SolverKind::Multifrontal})
            CHECK_THROWS_AS(analyse(model, {.solver = solver}), MechanismError);
    }

    TEST_CASE("No two motions of a free body in space read the same")
    {
        for (const double z : {0.0, 1.0, -2.5}) {
            Model model = frame({{0, 0}, {3, 0}, {3, 3}}, {{0, 1}, {1, 2}});
            model.analysis = AnalysisKind::Frame3d;
            model.sections[0].Iy = 0.7e-4;
            model.sections[0].J = 0.3e-4;
            model.nodes[2].at[2] = z;
            std::vector<std::string> sentences = mechanisms(model);
            CHECK(sentences.size() == 6);
            std::sort(sentences.begin(), sentences.end());
            CAPTURE(z);
            CHECK(std::adjacent_find(sentences.begin(), sentences.end()) == sentences.end());
        }
    }

    TEST_CASE("A part of a structure that nothing holds is told by its nodes")
    {
        Model model = frame({{0, 0}, {4, 0}, {0, 3}, {5, 3}, {5, 7}}, {{0, 1}, {2, 3}, {3, 4}});
        hold(model, 0, SupportKind::Fixed);
        CHECK(causes(model) ==
              std::vector<std::string>{"no node of the part C, D and E is supported, so nothing keeps it from moving "
                                       "as a whole; add supports or join it to the rest"});
        hold(model, 4, SupportKind::Pin);
        CHECK(causes(model) ==
              std::vector<std::string>{"the supports hold 2 of the 3 ways in which the part C, D and E can move as a "
                                       "whole; add supports, or join it to the rest"});
    }

    TEST_CASE("A foundation holds as supports do, and a mechanism inside a held structure blames no support")
    {
        Model model = frame({{0, 0}, {4, 0}}, {{0, 1}});
        model.members[0].foundation = 900.0;
        CHECK(causes(model) ==
              std::vector<std::string>{"the supports hold 2 of the 3 ways in which the structure can move as a whole; "
                                       "add supports, or let them act in other directions"});
        Model beam = frame({{0, 0}, {4, 0}, {8, 0}, {11, 0}}, {{0, 1}, {1, 2}, {2, 3}});
        hold(beam, 0, SupportKind::Pin);
        hold(beam, 3, SupportKind::Pin);
        beam.nodes[1].hinge = beam.nodes[2].hinge = true;
        CHECK_FALSE(mechanisms(beam).empty());
        CHECK(causes(beam).empty());
    }

    TEST_CASE("A member of a tenth of a millimetre in a beam of eight metres makes no mechanism")
    {
        const double l = 1e-4;
        Model model = frame({{0, 0}, {4 - 0.5 * l, 0}, {4 + 0.5 * l, 0}, {8, 0}}, {{0, 1}, {1, 2}, {2, 3}});
        hold(model, 0, SupportKind::Pin);
        hold(model, 3, SupportKind::Roller);
        CHECK(mechanisms(model).empty());
    }

    TEST_CASE("Three thousand inextensible members in a row make no mechanism, nor do as many rigid ones")
    {
        constexpr std::size_t n = 3000;
        for (const bool is_rigid : {false, true}) {
            Model model = frame({}, {});
            for (std::size_t i = 0; i <= n; ++i) {
                model.add(Node{.id = std::to_string(i), .at = {0.004 * static_cast<double>(i), 0.0, 0.0}});
                if (i == 0) continue;
                model.add(Member{.id = std::to_string(i),
                                 .nodes = {NodeId(i - 1), NodeId(i)},
                                 .material = MaterialId(0),
                                 .section = SectionId(0),
                                 .inextensible = !is_rigid,
                                 .rigid = is_rigid});
            }
            hold(model, 0, SupportKind::Pin);
            hold(model, n, SupportKind::Roller);
            CAPTURE(is_rigid);
            CHECK(mechanisms(model).empty());
        }
    }

    TEST_CASE("A hinged node turns idly whether its members are elastic, inextensible or rigid, with arms or without")
    {
        for (const AnalysisKind kind : {AnalysisKind::Frame2d, AnalysisKind::Grillage, AnalysisKind::Frame3d})
            for (const bool is_rigid : {false, true})
                for (const double arm : {0.0, 0.2}) {
                    Model model = frame({{0, 0}, {4, 0}, {8, 0}}, {{0, 1}, {1, 2}});
                    model.analysis = kind;
                    model.sections[0].Iy = 0.7e-4;
                    model.sections[0].J = 0.3e-4;
                    hold(model, 0, SupportKind::Fixed);
                    hold(model, 2, SupportKind::Fixed);
                    model.nodes[1].hinge = true;
                    (is_rigid ? model.members[0].rigid : model.members[0].inextensible) = true;
                    if (arm > 0.0) model.members[0].start.offset = {arm, 0.0};
                    if (arm > 0.0 && kind == AnalysisKind::Frame3d) model.members[0].start.offset.emplace_back(0.0);
                    CAPTURE(name(kind));
                    CAPTURE(is_rigid);
                    CAPTURE(arm);
                    CHECK(mechanisms(model).empty());
                }
    }

    TEST_CASE("An inextensible member hinged at both ends may spin about its axis, and a torque that spins it is told")
    {
        Model model = frame({{0, 0}, {4, 0}, {0, 4}, {1, 1}}, {{0, 3}, {1, 3}, {2, 3}});
        model.analysis = AnalysisKind::Frame3d;
        model.sections[0].Iy = 0.7e-4;
        model.sections[0].J = 0.3e-4;
        model.nodes[3].at[2] = 3.0;
        for (Node& node : model.nodes) node.hinge = true;
        for (const std::size_t base : {0U, 1U, 2U}) hold(model, base, SupportKind::Fixed);
        for (Member& member : model.members) member.inextensible = true;
        CHECK(mechanisms(model).empty());
        model.load_cases[0].members.push_back(
            {.member = MemberId(1), .load = DistributedLoad{.values = {{.dof = Dof::rx, .start = 2.0}}}});
        CHECK(
            mechanisms(model) ==
            std::vector<std::string>{"the structure can move without strain: member BD is loose, its releases leave rx "
                                     "free; take a release away"});
    }

    TEST_CASE("Two separate swaying frames are two mechanisms")
    {
        Model model = frame({{0, 0}, {0, 3}, {4, 3}, {4, 0}, {9, 0}, {9, 3}, {13, 3}, {13, 0}},
                            {{0, 1}, {1, 2}, {3, 2}, {4, 5}, {5, 6}, {7, 6}});
        for (const std::size_t base : {0, 3, 4, 7}) hold(model, base, SupportKind::Pin);
        for (const std::size_t top : {1, 2, 5, 6}) model.nodes[top].hinge = true;
        const std::vector<std::string> sentences = mechanisms(model);
        REQUIRE(sentences.size() == 2);
        CHECK((sentences[0] + sentences[1]).find("nodes B and C sway") != std::string::npos);
        CHECK((sentences[0] + sentences[1]).find("nodes F and G sway") != std::string::npos);
    }

    TEST_CASE("A hinge where all members are released makes no mechanism of the node's own rotation")
    {
        Model model = frame({{0, 0}, {4, 0}, {8, 0}}, {{0, 1}, {1, 2}});
        hold(model, 0, SupportKind::Fixed);
        hold(model, 2, SupportKind::Fixed);
        model.nodes[1].hinge = true;
        model.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::uy, .value = -10.0}}});
        const Results results = analyse(model);
        const double EI = 2.1e8 * 1.3e-4;
        CHECK(results.at("G").displacement(NodeId(1))[1] == doctest::Approx(-5.0 * 64.0 / (3.0 * EI)));
        CHECK(results.indeterminacy().total() == 2);
    }

    TEST_CASE("A member that its releases let fly away whole has every motion of a body told")
    {
        Model model = frame({{0, 0}, {4, 0}, {4, 3}}, {{0, 1}, {1, 2}});
        hold(model, 0, SupportKind::Fixed);
        model.members[1].start.release = {Dof::ux, Dof::uy, Dof::rz};
        std::vector<std::string> sentences = mechanisms(model);
        std::sort(sentences.begin(), sentences.end());
        const std::string can_move = "the structure can move without strain: ";
        CHECK(sentences ==
              std::vector<std::string>{can_move + "member BC swings about node C, its other end is released; take a "
                                                  "release away or hold the rotation of node C",
                                       can_move + "node C moves along x; nothing holds ux; add a brace or a support",
                                       can_move + "node C moves along y; nothing holds uy; add a brace or a support"});

        Model space = skew_chain(2.5);
        for (Node& node : space.nodes) node.hinge = false;
        space.nodes[3].support.reset();
        space.members[2].start.release = {Dof::ux, Dof::uy, Dof::uz, Dof::rx, Dof::ry, Dof::rz};
        CHECK(mechanisms(space).size() == 6);
    }

    TEST_CASE("A node turns freely if a member that it carries or a rigid arm can swing with it")
    {
        Model model = frame({{0, 0}, {4, 0}, {4, 3}}, {{0, 1}, {1, 2}});
        hold(model, 0, SupportKind::Fixed);
        hold(model, 2, SupportKind::Pin);
        model.members[1].start.release = {Dof::uy, Dof::rz}; // BC can swing about C, free of strain
        CHECK(
            mechanisms(model) ==
            std::vector<std::string>{"the structure can move without strain: member BC swings about node C, its other "
                                     "end is released; take a release away or hold the rotation of node C"});

        Model arm = frame({{0, 0}, {4, 0}}, {{0, 1}});
        hold(arm, 0, SupportKind::Pin);
        hold(arm, 1, SupportKind::Pin);
        arm.members[0].end.release = arm.members[0].start.release = {Dof::rz};
        CHECK(mechanisms(arm).empty());
        arm.members[0].end.offset = {-0.5, 0.0};
        CHECK(mechanisms(arm).size() == 1);
    }

    TEST_CASE("A moment on a rotation that nothing holds is a mechanism")
    {
        Model model = frame({{0, 0}, {4, 0}, {8, 0}}, {{0, 1}, {1, 2}});
        hold(model, 0, SupportKind::Fixed);
        hold(model, 2, SupportKind::Fixed);
        model.nodes[1].hinge = true;
        model.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::rz, .value = 7.0}}});
        CHECK(mechanisms(model) ==
              std::vector<std::string>{
                  "the structure can move without strain: node B rotates freely, nothing holds rz; add a support "
                  "or a rigid joint, or take the moment away"});
    }

    TEST_CASE("A member released along its axis at both ends is loose")
    {
        Model model = frame({{0, 0}, {4, 0}}, {{0, 1}});
        hold(model, 0, SupportKind::Fixed);
        hold(model, 1, SupportKind::Fixed);
        model.members[0].start.release = model.members[0].end.release = {Dof::ux};
        CHECK(mechanisms(model) ==
              std::vector<std::string>{"the structure can move without strain: member AB is loose, its releases "
                                       "leave ux free; take a release away"});
    }

    TEST_CASE("A loose member hides no other motion, nor that a support is missing")
    {
        const std::string can_move = "the structure can move without strain: ";
        const std::string loose = can_move + "member AB is loose, its releases leave ";

        Model parts = frame({{0, 0}, {4, 0}, {10, 0}, {10, 3}}, {{0, 1}, {2, 3}});
        for (const std::size_t end : {0U, 1U}) hold(parts, end, SupportKind::Fixed);
        hold(parts, 2, SupportKind::Pin);
        parts.members[0].start.release = parts.members[0].end.release = {Dof::ux};
        const std::vector<std::string> sentences = mechanisms(parts);
        REQUIRE(sentences.size() == 2);
        CHECK(sentences[0] == loose + "ux free; take a release away");
        CHECK(sentences[1].find("node D moves along x") != std::string::npos);
        CHECK(causes(parts) ==
              std::vector<std::string>{"the supports hold 2 of the 3 ways in which the part C and D can move as a "
                                       "whole; add supports, or join it to the rest"});

        Model slide = frame({{0, 0}, {4, 0}, {8, 0}}, {{0, 1}, {1, 2}});
        hold(slide, 0, SupportKind::Fixed);
        hold(slide, 2, SupportKind::Roller);
        slide.members[0].start.release = slide.members[0].end.release = {Dof::ux};
        CHECK(mechanisms(slide) ==
              std::vector<std::string>{loose + "ux free; take a release away",
                                       can_move + "nodes B and C sway to the right together; nothing holds ux; add a "
                                                  "brace or a support"});

        slide.members[0].start.release = slide.members[0].end.release = {Dof::uy, Dof::rz};
        const std::vector<std::string> three = mechanisms(slide);
        REQUIRE(three.size() == 3);
        CHECK(three[0].find(loose) == 0);
        CHECK(three[1].find(loose) == 0);
        CHECK(three[2] == can_move + "node B moves along y; nothing holds uy; add a brace or a support");
    }

    TEST_CASE("Of three thousand loose members a dozen are told, the others counted")
    {
        constexpr std::size_t n = 3000;
        Model model = frame({{0, 0}, {4, 0}}, {});
        for (const std::size_t end : {0U, 1U}) hold(model, end, SupportKind::Fixed);
        for (std::size_t i = 0; i < n; ++i) {
            Member member{.id = std::to_string(i),
                          .nodes = {NodeId(0), NodeId(1)},
                          .material = MaterialId(0),
                          .section = SectionId(0)};
            member.start.release = member.end.release = {Dof::ux};
            model.add(member);
        }
        try {
            analyse(model);
            FAIL("the members are loose");
        } catch (const MechanismError& error) {
            CHECK(error.mechanisms().size() == 12);
            CHECK(error.n_more() == n - 12);
        }
    }

    TEST_CASE("A member between nodes that slide is loose besides, and its picture moves it alone")
    {
        Model model = frame({{0, 0}, {4, 0}, {8, 0}}, {{0, 1}, {1, 2}});
        hold(model, 0, SupportKind::Fixed);
        hold(model, 2, SupportKind::Roller);
        model.members[0].start.release = model.members[0].end.release = {Dof::ux};
        const std::vector<Mechanism> found = motions(model);
        REQUIRE(found.size() == 2);
        CHECK(found[0].member_ends[0][1].x() == doctest::Approx(1.0));
        CHECK(found[0].member_ends[1][0].norm() == 0.0);
        CHECK(found[1].motion[1][0] == doctest::Approx(1.0));
        CHECK(found[1].member_ends[1][0].x() == doctest::Approx(1.0));
        CHECK(found[1].member_ends[0][1].norm() < 1e-9);
    }

    TEST_CASE("A loose member that turns moves its ends no further than any other motion, whatever its length")
    {
        Model model = frame({{0, 0}, {40, 0}}, {{0, 1}});
        for (const std::size_t end : {0U, 1U}) hold(model, end, SupportKind::Fixed);
        model.members[0].start.release = model.members[0].end.release = {Dof::uy, Dof::rz};
        const std::vector<Mechanism> found = motions(model);
        REQUIRE(found.size() == 2);
        for (const Mechanism& loose : found) {
            const auto& [start, end] = loose.member_ends[0];
            CHECK(std::max(start.norm(), end.norm()) == doctest::Approx(1.0));
        }
    }

    TEST_CASE("Rotations that loads drive are told with the other mechanisms, a twist once for all load cases")
    {
        Model model = frame({{0, 0}, {4, 0}, {4, 3}, {9, 0}, {12, 0}}, {{0, 1}, {1, 2}, {3, 4}});
        model.analysis = AnalysisKind::Frame3d;
        model.sections[0].Iy = 0.7e-4;
        model.sections[0].J = 0.3e-4;
        hold(model, 0, SupportKind::Fixed);
        hold(model, 2, SupportKind::Fixed);
        hold(model, 3, SupportKind::Fixed);
        model.members[0].start.release = model.members[0].end.release = {Dof::rx};
        model.add(LoadCase{.id = "Q"});
        for (LoadCase& load_case : model.load_cases)
            load_case.members.push_back(
                {.member = MemberId(0), .load = DistributedLoad{.values = {{.dof = Dof::rx, .start = 2.0}}}});
        const std::vector<std::string> twist = mechanisms(model);
        REQUIRE(twist.size() == 1);
        CHECK(twist[0].find("member AB is loose, its releases leave rx free") != std::string::npos);
        model.members[2].start.release = model.members[2].end.release = {Dof::uz};
        hold(model, 4, SupportKind::Fixed);
        CHECK(mechanisms(model).size() == 2);
        model.nodes[4].support = Support{.fixed = {Dof::ux, Dof::uz, Dof::rx, Dof::ry, Dof::rz}};
        const std::vector<std::string> all = mechanisms(model);
        REQUIRE(all.size() == 3);
        CHECK(all[0].find("member DE is loose") != std::string::npos);
        CHECK(all[1].find("node E moves along y") != std::string::npos);
        CHECK(all[2] == twist[0]);
    }

    TEST_CASE("A bar square to the only way in which its node may move does not hold it, whatever rounding leaves")
    {
        Model upright = frame({{0.3, 0}, {0.1 + 0.2, 5}}, {{0, 1}}); // 5.6e-17 out of plumb
        Model slope = frame({{0, 3}, {0, 0}}, {{0, 1}});
        slope.nodes[1].support = Support{.fixed = {Dof::ux}, .angle = 90.0};
        Model slant = frame({{0, 0}, {3, 1.7}}, {{0, 1}});
        slant.nodes[1].support = Support{.fixed = {Dof::ux}, .angle = std::atan2(1.7, 3.0) * 180.0 / std::numbers::pi};
        upright.nodes[1].support = Support{.fixed = {Dof::uy}};
        for (Model model : {upright, slope, slant}) {
            model.analysis = AnalysisKind::Truss2d;
            hold(model, 0, SupportKind::Pin);
            CHECK(mechanisms(model).size() == 1);
        }
    }

    TEST_CASE("A bar square to a roller's slope does not hold it, whatever the slope")
    {
        for (int slope = 3; slope < 180; slope += 7) {
            CAPTURE(slope);
            const double angle = slope * std::numbers::pi / 180.0;
            Model model = frame({{1.3, 2.6}, {1.3 + 3.0 * std::cos(angle), 2.6 + 3.0 * std::sin(angle)}}, {{1, 0}});
            model.analysis = AnalysisKind::Truss2d;
            hold(model, 0, SupportKind::Pin);
            model.nodes[1].support = Support{.fixed = {Dof::ux}, .angle = static_cast<double>(slope)};
            CHECK(mechanisms(model).size() == 1);
        }
    }

    TEST_CASE("A very soft spring is nearly a mechanism, not one, and the warning gives the condition")
    {
        Model model = frame({{0, 0}, {4, 0}}, {{0, 1}});
        model.nodes[0].support = Support{.fixed = {Dof::ux, Dof::uy}, .springs = {{.dof = Dof::rz, .stiffness = 1e-8}}};
        model.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::uy, .value = -1e-9}}});
        const Results results = analyse(model);
        REQUIRE(results.warnings().size() == 1);
        CHECK(results.warnings()[0].kind == FaultKind::NearlySingular);
        CHECK(severity(results.warnings()[0].kind) == Severity::Warning);
        CHECK(results.at("G").displacement(NodeId(1))[1] == doctest::Approx(-1e-9 * 16.0 / 1e-8).epsilon(1e-2));
    }

    TEST_CASE("A member that turns on a spring too soft for six digits is warned of, on a firmer one not")
    {
        // The tip sinks P (L^2 / c + L^3 / 3 E I); K holds c among numbers E I / L times larger.
        const auto on_spring = [](double c) {
            Model model = frame({{0, 0}, {4, 0}}, {{0, 1}});
            hold(model, 0, SupportKind::Fixed);
            model.members[0].start.springs = {{.dof = Dof::rz, .stiffness = c}};
            model.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::uy, .value = -7.0}}});
            return analyse(model);
        };
        const Results soft = on_spring(3e-6);
        REQUIRE(soft.warnings().size() >= 1);
        CHECK(message(soft.warnings()[0]).find("softest at B") != std::string::npos);
        const Results swung = on_spring(1e-3); // accurate, but it moves 28 km
        REQUIRE(swung.warnings().size() == 1);
        CHECK(swung.warnings()[0].kind == FaultKind::HugeDisplacement);
        const Results firm = on_spring(3.0);
        CHECK(firm.warnings().empty());
        CHECK(firm.at("G").displacement(NodeId(1))[1] ==
              doctest::Approx(-7.0 * (16.0 / 3.0 + 64.0 / (3.0 * 2.1e8 * 1.3e-4))).epsilon(1e-10));
    }

    TEST_CASE("A section force beyond the range of numbers is refused by the analysis, with its case")
    {
        Model truss = frame({{0, 0}, {4e90, 0}}, {{0, 1}});
        truss.analysis = AnalysisKind::Truss2d;
        hold(truss, 0, SupportKind::Pin);
        hold(truss, 1, SupportKind::Pin);
        truss.load_cases[0].members.push_back(
            {.member = MemberId(0), .load = DistributedLoad{.values = {{.dof = Dof::uy, .start = -1e80}}}});
        CHECK_THROWS_WITH_AS(
            analyse(truss),
            "case G: its forces or displacements are beyond the range of numbers; check the loads, the "
            "lengths and their units",
            ModelError);

        Model beam = frame({{0, 0}, {4, 0}}, {{0, 1}});
        hold(beam, 0, SupportKind::Fixed);
        beam.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::uy, .value = -3e100}}});
        CHECK_NOTHROW(analyse(beam));
        beam.combinations.push_back({.id = "U", .terms = {{.of = CaseId(0), .factor = 1e208}}});
        CHECK_THROWS_WITH_AS(
            analyse(beam),
            "case U: its forces or displacements are beyond the range of numbers; check the loads, the "
            "lengths and their units",
            ModelError);
    }

    TEST_CASE("A truss so flat that its node would move further than anybody can mean is solved, with a warning")
    {
        const auto flat = [](double rise) {
            Model model = frame({{0, 0}, {3, rise}, {6, 0}}, {{0, 1}, {1, 2}});
            model.analysis = AnalysisKind::Truss2d;
            for (const std::size_t end : {0U, 2U}) hold(model, end, SupportKind::Pin);
            model.load_cases[0].nodes.push_back({NodeId(1), {{Dof::uy, -10.0}}});
            return analyse(model);
        };
        CHECK(flat(0.5).warnings().empty());
        for (const double rise : {1e-6, 1e-9}) {
            const Results results = flat(rise);
            REQUIRE(results.warnings().size() == 1);
            CHECK(results.warnings()[0].kind == FaultKind::HugeDisplacement);
            const double L = std::hypot(3.0, rise);
            CHECK(results.at("G").displacement(NodeId(1))[1] ==
                  doctest::Approx(-10.0 * L * L * L / (2.0 * 2.1e8 * 0.01 * rise * rise)));
        }
    }

    TEST_CASE("A mode moves without strain: members keep their length")
    {
        Model model = frame({{0, 0}, {6, 0}, {1, 4}, {6, 5}}, {{0, 2}, {1, 3}, {2, 3}}); // a skew four-bar linkage
        for (const std::size_t base : {0, 1}) hold(model, base, SupportKind::Pin);
        for (const std::size_t top : {2, 3}) model.nodes[top].hinge = true;
        try {
            analyse(model);
            FAIL("the linkage moves");
        } catch (const MechanismError& error) {
            REQUIRE(error.mechanisms().size() == 1);
            const Mechanism& mechanism = error.mechanisms()[0];
            for (std::size_t i = 0; i < model.members.size(); ++i) {
                const Node& a = model[model.members[i].nodes[0]];
                const Node& b = model[model.members[i].nodes[1]];
                const Eigen::Vector3d along(b.at[0] - a.at[0], b.at[1] - a.at[1], 0.0);
                const auto& ends = mechanism.member_ends[i];
                CHECK(std::abs(along.dot(ends[1] - ends[0])) < 1e-9);
            }
            double largest = 0.0;
            for (const NodeVector& v : mechanism.motion) largest = std::max({largest, std::abs(v[0]), std::abs(v[1])});
            CHECK(largest == doctest::Approx(1.0));
        }
    }

    TEST_CASE("A chain of a thousand bars says the first of its motions and counts on")
    {
        Model model;
        model.analysis = AnalysisKind::Truss2d;
        model.add(Material{.id = "steel", .E = 2.1e8});
        model.add(Section{.id = "rod", .A = 0.003});
        for (int i = 0; i <= 1000; ++i) model.add(Node{.id = std::to_string(i), .at = {1.3 * i, 0.0, 0.0}});
        for (std::size_t i = 0; i < 1000; ++i)
            model.add(Member{.id = std::to_string(i),
                             .nodes = {NodeId(i), NodeId(i + 1)},
                             .material = MaterialId(0),
                             .section = SectionId(0)});
        hold(model, 0, SupportKind::Pin);
        hold(model, 1000, SupportKind::Pin);
        try {
            analyse(model);
            FAIL("the chain hangs loose");
        } catch (const MechanismError& error) {
            CHECK(error.mechanisms().size() == 12);
            CHECK(error.n_more() > 50);
        }
    }

    TEST_CASE("A torque on a space member released against torsion at both ends is a mechanism")
    {
        Model model = frame({{0, 0}, {4, 0}}, {{0, 1}});
        model.analysis = AnalysisKind::Frame3d;
        model.sections[0].Iy = 0.7e-4;
        model.sections[0].J = 0.3e-4;
        hold(model, 0, SupportKind::Fixed);
        hold(model, 1, SupportKind::Fixed);
        model.members[0].start.release = model.members[0].end.release = {Dof::rx};
        CHECK(mechanisms(model).empty());
        model.load_cases[0].members.push_back(
            {.member = MemberId(0),
             .load = PointLoad{.at = Percent{50.0}, .components = {{.dof = Dof::rx, .value = 5.0}}}});
        CHECK(mechanisms(model).size() == 1);
    }

    TEST_CASE("A space beam on two pins spins about its own axis")
    {
        Model model = frame({{0, 0}, {4, 0}}, {{0, 1}});
        model.analysis = AnalysisKind::Frame3d;
        model.sections[0].Iy = 0.7e-4;
        model.sections[0].J = 0.3e-4;
        hold(model, 0, SupportKind::Pin);
        hold(model, 1, SupportKind::Pin);
        CHECK(mechanisms(model) ==
              std::vector<std::string>{"the structure can move without strain: A and B rotate freely; add a "
                                       "support or a rigid joint against the rotation"});
    }

    TEST_CASE("A space member that a hinge lets spin is held against that spin")
    {
        Model model = frame({{0, 0}, {4, 1}, {4, 6}}, {{0, 1}, {1, 2}});
        model.analysis = AnalysisKind::Frame3d;
        model.sections[0].Iy = 0.7e-4;
        model.sections[0].J = 0.3e-4;
        hold(model, 0, SupportKind::Fixed);
        hold(model, 2, SupportKind::Fixed);
        model.nodes[0].hinge = true;
        model.members[1].start.release = {Dof::rx, Dof::ry, Dof::rz}; // B turns with AB, which spins at A
        model.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::uz, .value = -10.0}}});
        CHECK(mechanisms(model).empty());
        model.load_cases[0].nodes[0].components = {{.dof = Dof::rx, .value = 3.0}};
        CHECK(mechanisms(model).size() == 1);
    }

    TEST_CASE("A chain of space members that hinges let spin together is held, and bends as one beam")
    {
        const double h = 2.5, P = 10.0;
        Model model = skew_chain(h);
        model.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::ux, .value = P}}});
        model.load_cases[0].nodes.push_back({.node = NodeId(2), .components = {{.dof = Dof::uy, .value = 0.5 * P}}});
        REQUIRE(mechanisms(model).empty());
        const CaseResult result = analyse(model)[CaseId(0)];
        const SectionForces first = result.curve(MemberId(0)).forces(0.0);
        const SectionForces last = result.curve(MemberId(2)).forces(3.0 * h);
        const Eigen::Vector3d start(first.N, first.Vy, first.Vz), end(last.N, last.Vy, last.Vz);
        CHECK(start.norm() > 0.0);
        CHECK(std::hypot(first.My, first.Mz) == doctest::Approx(0.0));
        CHECK(std::hypot(last.My, last.Mz) == doctest::Approx(0.0));
        CHECK(result.equilibrium().residual < 1e-9);
        CHECK(result.equilibrium().sum_reactions[0] == doctest::Approx(-P));
        CHECK(result.equilibrium().sum_reactions[1] == doctest::Approx(-0.5 * P));
    }

    TEST_CASE("What rounding leaves of a load about a chain's axis does not spin it, however its section is turned")
    {
        Model model = frame({{0, 0}, {0, 3}, {0, 6}}, {{0, 1}, {1, 2}}); // rises square to x
        model.analysis = AnalysisKind::Frame3d;
        model.sections[0].Iy = 0.7e-4;
        model.sections[0].J = 0.3e-4;
        for (Node& node : model.nodes) node.at[2] = node.at[1] / 1.5;
        for (Member& member : model.members) member.up = {0.31, 0.17, 0.9};
        for (const std::size_t end : {0U, 2U}) hold(model, end, SupportKind::Pin);
        model.nodes[2].hinge = true;
        DistributedLoad weight{.values = {{.dof = Dof::uz, .start = -11.28}}};
        model.load_cases[0].members.push_back({.member = MemberId(0), .load = weight});
        CHECK(mechanisms(model).empty());
    }

    TEST_CASE("Moments on an idle joint that sum up to nothing do not turn it")
    {
        Model model = frame({{0, 0}, {4, 0}, {9, 0}}, {{0, 1}, {1, 2}});
        hold(model, 0, SupportKind::Fixed);
        hold(model, 2, SupportKind::Fixed);
        model.nodes[1].hinge = true;
        for (const double moment : {0.1, 0.2, -0.3}) // leave 5.6e-17
            model.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::rz, .value = moment}}});
        CHECK(mechanisms(model).empty());
    }

    TEST_CASE("A torque that spins a chain is a mechanism of all its nodes, two that twist it are none")
    {
        Model model = skew_chain(2.5);
        const auto turn = [&](std::size_t node, double torque) { // about (1, 2, 2) / 3
            model.load_cases[0].nodes.push_back({.node = NodeId(node),
                                                 .components = {{.dof = Dof::rx, .value = torque / 3.0},
                                                                {.dof = Dof::ry, .value = 2.0 * torque / 3.0},
                                                                {.dof = Dof::rz, .value = 2.0 * torque / 3.0}}});
        };
        turn(1, 7.0);
        CHECK(mechanisms(model) ==
              std::vector<std::string>{"the structure can move without strain: B and C rotate freely; add a "
                                       "support or a rigid joint against the rotation"});
        turn(2, -7.0);
        REQUIRE(mechanisms(model).empty());
        CHECK(analyse(model)[CaseId(0)].curve(MemberId(1)).forces(1.0).T == doctest::Approx(-7.0));
        CHECK(analyse(model).indeterminacy().total() == 1); // between two fixed ends N alone is free to choose
    }

    TEST_CASE("A chain in a grillage that hinges let spin is held too")
    {
        Model model = frame({{0, 0}, {2, 0}, {5, 0}, {9, 0}}, {{0, 1}, {2, 1}, {2, 3}});
        model.analysis = AnalysisKind::Grillage;
        model.sections[0].J = 0.3e-4;
        for (const std::size_t end : {0U, 3U}) {
            hold(model, end, SupportKind::Fixed);
            model.nodes[end].hinge = true;
        }
        model.load_cases[0].nodes.push_back({.node = NodeId(2), .components = {{.dof = Dof::uz, .value = -9.0}}});
        REQUIRE(mechanisms(model).empty());
        CHECK(analyse(model)[CaseId(0)].curve(MemberId(2)).forces(0.0).Mz == doctest::Approx(9.0 * 5 * 4 / 9.0));
        model.load_cases[0].nodes[0].components = {{.dof = Dof::rx, .value = 3.0}};
        CHECK(mechanisms(model).size() == 1);
    }

    TEST_CASE("A member welded to a chain crosswise stops its spin: a torque is carried")
    {
        Model model = skew_chain(2.5);
        model.add(Node{.id = "E", .at = {9.0, 1.0, 4.0}});
        hold(model, 4, SupportKind::Fixed);
        model.add(
            Member{.id = "BE", .nodes = {NodeId(1), NodeId(4)}, .material = MaterialId(0), .section = SectionId(0)});
        model.load_cases[0].nodes.push_back({.node = NodeId(2), .components = {{.dof = Dof::rx, .value = 3.0}}});
        CHECK(mechanisms(model).empty());
    }

    TEST_CASE("Every free panel of a board of pinned squares is a mechanism of its own")
    {
        constexpr std::size_t n = 7; // nodes a side
        Model model;
        model.analysis = AnalysisKind::Truss2d;
        model.add(Material{.id = "steel", .E = 2.1e8});
        model.add(Section{.id = "rod", .A = 0.003});
        for (std::size_t y = 0; y < n; ++y)
            for (std::size_t x = 0; x < n; ++x)
                model.add(Node{.id = std::to_string(x) + "," + std::to_string(y),
                               .at = {2.0 * static_cast<double>(x), 1.7 * static_cast<double>(y), 0.0}});
        const auto join = [&](std::size_t a, std::size_t b) {
            model.add(Member{.id = std::to_string(model.members.size()),
                             .nodes = {NodeId(a), NodeId(b)},
                             .material = MaterialId(0),
                             .section = SectionId(0)});
        };
        for (std::size_t y = 0; y < n; ++y)
            for (std::size_t x = 0; x < n; ++x) {
                if (x + 1 < n) join(y * n + x, y * n + x + 1);
                if (y + 1 < n) join(y * n + x, (y + 1) * n + x);
            }
        hold(model, 0, SupportKind::Pin);
        hold(model, n - 1, SupportKind::Roller);
        model.add(LoadCase{.id = "G"});
        // Of more than twelve only the first are described, the others counted.
        // 2 n^2 displacements, 2 n (n - 1) rods, 3 reactions: 2 n - 3 free motions, one fewer row shear than rows and
        // columns
        CHECK(mechanisms(model).size() == 2 * n * n - 2 * n * (n - 1) - 3);
    }
}
