#include "femoop/model/check/check.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "femoop/model/model.h"

using namespace femoop;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Model cantilever()
{
    Model model;
    const MaterialId steel = model.add(Material{.id = "steel", .E = 205e6});
    const SectionId beam = model.add(Section{.id = "beam", .A = 0.012, .Iz = 2e-4});
    const NodeId A = model.add(Node{.id = "A", .at = {0.0, 0.0}, .support = Support{.kind = SupportKind::Fixed}});
    const NodeId B = model.add(Node{.id = "B", .at = {6.0, 0.0}});
    model.add(Member{.id = "AB", .nodes = {A, B}, .material = steel, .section = beam});
    return model;
}

std::string faults_of(const Model& model)
{
    std::string text;
    for (const Fault& fault : check(model)) text += message(fault) + '\n';
    return text;
}

/// `n` members side by side, and one that crosses them all.
Model comb(int n)
{
    Model model = cantilever();
    const auto bar = [&](const std::string& id, double x0, double y0, double x1, double y1) {
        const NodeId a = model.add(Node{.id = id + "a", .at = {x0, y0}});
        const NodeId b = model.add(Node{.id = id + "b", .at = {x1, y1}});
        model.add(Member{.id = id, .nodes = {a, b}, .material = MaterialId(0), .section = SectionId(0)});
    };
    for (int i = 0; i < n; ++i) bar("T" + std::to_string(i), i, 1.0, i, 3.0);
    bar("long", -1.0, 2.0, n, 2.0);
    return model;
}

} // namespace

TEST_CASE("A sound model has no faults")
{
    CHECK(faults_of(cantilever()).empty());
    CHECK_NOTHROW(require_sound(cantilever()));
}

TEST_CASE("A reference to nothing is refused wherever it stands")
{
    Model model = cantilever();
    model.members[0].nodes[1] = NodeId(7);
    model.members[0].section = SectionId(3);
    model.load_cases.push_back({.id = "G",
                                .nodes = {{.node = NodeId(9)}},
                                .settlements = {{.node = NodeId(8)}},
                                .members = {{.member = MemberId(6)}}});
    model.combinations.push_back({.id = "U", .terms = {{.of = CaseId(5)}}});
    model.expected.push_back(
        {.load_case = CaseId(0), .member = MemberId(4), .component = MemberComponent::u, .at = 0.0});
    CHECK(faults_of(model) ==
          "members[0] \"AB\": refers to entry 7 of nodes, which has 2; refer to one that is there\n"
          "members[0] \"AB\": refers to entry 3 of sections, which has 1; refer to one that is there\n"
          "load_cases[0].nodes[0]: refers to entry 9 of nodes, which has 2; refer to one that is there\n"
          "load_cases[0].settlements[0]: refers to entry 8 of nodes, which has 2; refer to one that is there\n"
          "load_cases[0].members[0]: refers to entry 6 of members, which has 1; refer to one that is there\n"
          "combinations[0] \"U\": refers to entry 5 of cases, which has 2; refer to one that is there\n"
          "expected[0]: refers to entry 4 of members, which has 1; refer to one that is there\n"
          "sections[0] \"beam\": no member uses this section; use it or delete it\n"
          "nodes[1] \"B\": no member is joined to this node; join one or delete the node\n");
}

TEST_CASE("A number that is not finite is refused wherever it stands")
{
    Model model = cantilever();
    model.materials[0].E = std::nan("");
    model.sections[0].A = infinite;
    model.nodes[1].at[1] = -infinite;
    model.load_cases.push_back(
        {.id = "G", .self_weight = infinite, .nodes = {{.node = NodeId(1), .components = {{Dof::uy, std::nan("")}}}}});
    model.combinations.push_back({.id = "U", .terms = {{.of = CaseId(0), .factor = infinite}}});
    CHECK(faults_of(model) == "materials[0] \"steel\": E is nan; give a finite number\n"
                              "sections[0] \"beam\": A is inf; give a finite number\n"
                              "nodes[1] \"B\": y is -inf; give a finite number\n"
                              "load_cases[0] \"G\": self_weight is inf; give a finite number\n"
                              "load_cases[0].nodes[0]: fy is nan; give a finite number\n"
                              "combinations[0] \"U\": G is inf; give a finite number\n");
}

TEST_CASE("Coordinates as large as numbers go are refused, and no grid is laid over them")
{
    constexpr double largest = std::numeric_limits<double>::max();
    for (const double x : {1e101, 1.7e308, largest, -largest})
        for (const double y : {0.0, largest}) {
            Model model = cantilever();
            model.nodes[1].at = {x, y};
            const std::string faults = faults_of(model);
            CAPTURE(x);
            CHECK(faults.find("too far for stiffnesses") != std::string::npos);
            CHECK_THROWS_AS(require_sound(model), ModelError);
        }
}

TEST_CASE("A component that is given twice is refused")
{
    Model model = cantilever();
    model.members[0].end.springs = {{.dof = Dof::rz, .stiffness = 5.0}, {.dof = Dof::rz, .stiffness = 6.0}};
    model.load_cases.push_back(
        {.id = "G", .nodes = {{.node = NodeId(1), .components = {{Dof::uy, 3.0}, {Dof::uy, 4.0}}}}});
    CHECK(faults_of(model) == "members[0] \"AB\": rz is given twice; keep one\n"
                              "load_cases[0].nodes[0]: uy is given twice; keep one\n");
}

TEST_CASE("An offset or a vector with the wrong number of parts is refused")
{
    Model model = cantilever();
    model.members[0].start.offset = {0.5};
    CHECK(faults_of(model) ==
          "members[0] \"AB\": its start offset has 1 lengths, which frame2d does not; give one per coordinate\n");
    Model space = cantilever();
    space.analysis = AnalysisKind::Frame3d;
    space.sections[0].Iy = 1e-4;
    space.sections[0].J = 1e-4;
    space.members[0].up = {0.0, 1.0};
    CHECK(faults_of(space) == "members[0] \"AB\": \"up\" has 2 numbers, wanted 3; give x, y and z\n");
}

TEST_CASE("Fifty crossings are named, the others counted")
{
    const std::vector<Fault> faults = check(comb(53));
    int n_crossings = 0;
    for (const Fault& fault : faults) n_crossings += fault.kind == FaultKind::MembersCross ? 1 : 0;
    CHECK(n_crossings == 50);
    CHECK(message(faults.back()) == "and 3 more members that cross, overlap or pass a node");
}

TEST_CASE("Members that only share a node, or end where others end, do not cross")
{
    Model model = cantilever();
    const NodeId C = model.add(Node{.id = "C", .at = {3.0, 4.0}});
    const NodeId D = model.add(Node{.id = "D", .at = {9.0, 4.0}});
    for (const auto& [id, a, b] :
         {std::tuple("AC", NodeId(0), C), std::tuple("BC", NodeId(1), C), std::tuple("BD", NodeId(1), D)})
        model.add(Member{.id = id, .nodes = {a, b}, .material = MaterialId(0), .section = SectionId(0)});
    CHECK(faults_of(model).empty());
}

TEST_CASE("In space, members that pass each other at a distance do not cross")
{
    const auto crossing_at = [](double z) {
        Model model = cantilever();
        model.analysis = AnalysisKind::Truss3d;
        const NodeId C = model.add(Node{.id = "C", .at = {2.0, -1.0, z}});
        const NodeId D = model.add(Node{.id = "D", .at = {2.0, 1.0, z}});
        model.add(Member{.id = "CD", .nodes = {C, D}, .material = MaterialId(0), .section = SectionId(0)});
        return faults_of(model);
    };
    CHECK(crossing_at(0.01).empty());
    CHECK(crossing_at(0.0) == "members[1] \"CD\": crosses member \"AB\" at (2, 0, 0) m without a node; "
                              "if they are joined there, add a node and split both\n");
}

TEST_CASE("The place of a crossing is told with twelve digits at most")
{
    Model model = cantilever();
    const NodeId C = model.add(Node{.id = "C", .at = {1.0, -1.0}});
    const NodeId D = model.add(Node{.id = "D", .at = {2.0, 2.0}});
    model.add(Member{.id = "CD", .nodes = {C, D}, .material = MaterialId(0), .section = SectionId(0)});
    CHECK_MESSAGE(faults_of(model).find(" at (1.33333333333, 0) m ") != std::string::npos, faults_of(model));
}

TEST_CASE("Crossings are found wherever they lie and however the model is turned")
{
    for (int step = 0; step < 36; ++step) {
        CAPTURE(step);
        const double angle = 0.1745 * step, c = std::cos(angle), s = std::sin(angle);
        Model model = comb(20);
        for (Node& node : model.nodes) {
            const double x = node.at[0], y = node.at[1];
            node.at[0] = 100.0 + c * x - s * y;
            node.at[1] = -70.0 + s * x + c * y;
        }
        std::size_t n_crossings = 0;
        for (const Fault& fault : check(model)) n_crossings += fault.kind == FaultKind::MembersCross ? 1U : 0U;
        CHECK(n_crossings == 20);
    }
}

TEST_CASE("Nodes are at one place when they are nearer than 1e-9 of the model's size")
{
    const auto faults_at = [](double x) {
        Model model = cantilever();
        const NodeId C = model.add(Node{.id = "C", .at = {x, 0.0}});
        const NodeId D = model.add(Node{.id = "D", .at = {6.0, 3.0}});
        model.add(Member{.id = "CD", .nodes = {C, D}, .material = MaterialId(0), .section = SectionId(0)});
        return faults_of(model);
    };
    CHECK(faults_at(6.0 + 5e-9) == "nodes[2] \"C\": lies where node \"B\" lies, at (6.000000005, 0) m; "
                                   "the two are not joined: use one of them or move one\n");
    CHECK(faults_at(6.001).empty());
}

TEST_CASE("A fault of a typed quantity shows the text that was typed")
{
    Model model = cantilever();
    model.materials[0].E = Quantity(-205e6, "-205 GPa");
    CHECK(faults_of(model) == "materials[0] \"steel\": E is -205 GPa; give a value greater than 0\n");
}

TEST_CASE("require_sound throws every error and no warning")
{
    Model model = cantilever();
    model.materials[0].E = 0.0;
    model.sections[0].A = -1.0;
    model.add(Node{.id = "lonely", .at = {9.0, 0.0}});
    CHECK_THROWS_WITH_AS(require_sound(model),
                         "materials[0] \"steel\": E is 0 kN/m^2; give a value greater than 0\n"
                         "sections[0] \"beam\": A is -1 m^2; give a value greater than 0",
                         ModelError);
}
