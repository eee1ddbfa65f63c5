#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "femoop/analysis/linear_static.h"
#include "femoop/geometry/plane_vectors.h"
#include "femoop/io/model_file.h"
#include "femoop/methods/truss/joint_method.h"
#include "femoop/methods/truss/reciprocal.h"
#include "femoop/methods/truss/section_method.h"
#include "femoop/methods/truss/zero_force.h"
#include "femoop/typical/typical.h"
#include "tests/femoop/methods/truss/random_truss.h"
#include "tests/source_folder.h"

using namespace femoop;
using namespace femoop::truss;

namespace {

constexpr unsigned n_seeds = 60;

Model example(const std::string& name) { return read_model_file(source_folder() + "/examples/" + name); }

MemberId bar_named(const Model& model, const std::string& id) { return *model.find_member(id); }

std::vector<MemberId> bars_named(const Model& model, const std::vector<std::string>& ids)
{
    std::vector<MemberId> bars;
    for (const std::string& id : ids) bars.push_back(bar_named(model, id));
    return bars;
}

/// What a reciprocal diagram has to be, beside the analysis.
void check_laws(const Truss& truss, const Reciprocal& diagram)
{
    const double exact = 1e-9 * truss.largest_force;
    CHECK(diagram.closing_error <= exact);
    for (std::size_t i = 0; i < truss.bars.size(); ++i) {
        const auto [left, right] = diagram.bar_spaces[i];
        const Eigen::Vector2d side = diagram[right].point - diagram[left].point;
        CAPTURE(i);
        CHECK(std::abs(cross_product(side, truss.bars[i].direction)) <= exact);
        CHECK(std::abs(side.norm() - std::abs(truss.bars[i].force)) <= exact);
        CHECK(side.dot(truss.bars[i].direction) ==
              doctest::Approx(truss.bars[i].force).epsilon(1e-9).scale(truss.largest_force));
    }
    for (std::size_t i = 0; i < diagram.forces.size(); ++i) {
        const auto [before, after] = diagram.force_spaces(i);
        const Eigen::Vector2d side = diagram[after].point - diagram[before].point;
        CHECK((side - truss.forces[diagram.forces[i]].force).norm() <= exact);
    }
    for (const Step& step : diagram.joints.steps) CHECK(step.closing_error <= exact);
}

std::size_t n_bars(const Reciprocal& diagram)
{
    return std::accumulate(diagram.steps.begin(), diagram.steps.end(), std::size_t{0},
                           [](std::size_t n, const DiagramStep& step) { return n + (step.bar ? 1 : 0); });
}

} // namespace

TEST_CASE("Each side of a reciprocal diagram is parallel to its bar and as long as its force")
{
    std::size_t n_joints = 0;
    for (unsigned seed = 0; seed < n_seeds; ++seed) {
        CAPTURE(seed);
        const Truss truss = truss_in(random_planar_truss(seed, 25));
        REQUIRE(!why_no_reciprocal(truss));
        const Reciprocal diagram = reciprocal(truss);
        check_laws(truss, diagram);
        CHECK(n_bars(diagram) == truss.bars.size());
        n_joints += truss.joints.size();
    }
    CHECK(n_joints > 8 * n_seeds);
}

TEST_CASE("Joint by joint every determinate truss comes to what the analysis says")
{
    for (unsigned seed = 0; seed < n_seeds; ++seed) {
        CAPTURE(seed);
        const Truss truss = truss_in(random_truss(seed, 12));
        const JointMethod method = joint_method(truss, usual_arrangement(truss));
        for (std::size_t i = 0; i < truss.bars.size(); ++i)
            CHECK(std::abs(method.forces[i] - truss.bars[i].force) <= 1e-7 * truss.largest_force);
        for (const Step& step : method.steps) CHECK(step.closing_error <= 1e-7 * truss.largest_force);
    }
}

TEST_CASE("A section finds what the analysis says, whatever bars it cuts")
{
    int n_found = 0;
    for (unsigned seed = 0; seed < n_seeds; ++seed) {
        const Truss truss = truss_in(random_planar_truss(seed, 8));
        for (std::size_t i = 0; i < truss.bars.size(); ++i)
            for (std::size_t j = i + 1; j < truss.bars.size(); ++j)
                for (std::size_t k = j + 1; k < truss.bars.size(); ++k) {
                    const std::vector<MemberId> bars{MemberId(i), MemberId(j), MemberId(k)};
                    if (why_no_cut(truss, bars)) continue;
                    for (const CutEquation& equation : ritter_cut(truss, bars).equations) {
                        CAPTURE(seed);
                        CHECK(std::abs(equation.force - truss[equation.bar].force) <= 1e-8 * truss.largest_force);
                        ++n_found;
                    }
                }
    }
    CHECK(n_found > 400);
}

TEST_CASE("The usual trusses have their diagram, and so have loads and weight on their bars")
{
    for (const TrussPattern pattern :
         {TrussPattern::Pratt, TrussPattern::Howe, TrussPattern::Warren, TrussPattern::K}) {
        Model model = PlaneTruss{.pattern = pattern}.model();
        const Truss truss = truss_in(model);
        CHECK(!truss.has_loaded_bars);
        check_laws(truss, reciprocal(truss));
    }
    Model model = PlaneTruss{.pattern = TrussPattern::Warren}.model();
    const auto slope = static_cast<std::size_t>(bar_named(model, model.members.back().id).index);
    model.load_cases[0].members.push_back(
        {.member = MemberId(slope),
         .load = DistributedLoad{
             .values = {{.dof = Dof::uy, .start = -7.0, .end = -3.0}, {.dof = Dof::ux, .start = 2.0}}}});
    const Truss loaded = truss_in(model);
    CHECK(loaded.has_loaded_bars);
    check_laws(loaded, reciprocal(loaded));
}

TEST_CASE("The king-post truss has the diagram that is drawn by hand")
{
    const Model model = example("truss.json");
    const Truss truss = truss_in(model);
    const Reciprocal diagram = reciprocal(truss);
    check_laws(truss, diagram);
    // From the left support over the top: 30 down between A and B, the right reaction, 10 down, the left reaction.
    REQUIRE(diagram.n_outside() == 4);
    CHECK(truss.forces[diagram.forces[0]].force == Eigen::Vector2d(0.0, -30.0));
    CHECK(truss.forces[diagram.forces[2]].force == Eigen::Vector2d(0.0, -10.0));
    CHECK(diagram.spaces.size() == 6);
    CHECK(diagram.name(bar_named(model, "AD")) == "A-1");
    CHECK(diagram.name(bar_named(model, "CD")) == "1-2");
    CHECK(diagram.name(bar_named(model, "AC")) == "D-1");
    CHECK(diagram.joints.forces[bar_named(model, "AD").index] == doctest::Approx(-10.0 * std::sqrt(13.0)));
}

TEST_CASE(
    "Bar by bar the diagram grows by one line at a stage, from a point that stands, and ends with joints that close")
{
    for (unsigned seed = 0; seed < n_seeds; ++seed) {
        CAPTURE(seed);
        const Truss truss = truss_in(random_planar_truss(seed, 25));
        const Reciprocal diagram = reciprocal(truss);
        std::vector<bool> is_known(diagram.spaces.size(), false), is_drawn(truss.bars.size(), false);
        for (const DiagramStep& step : diagram.steps) {
            if (step.bar) {
                REQUIRE(step.from);
                CHECK(is_known[step.from->index]);
                CHECK(!is_drawn[step.bar->index]);
                is_drawn[step.bar->index] = true;
            }
            CHECK((step.is_open ? step.spaces.empty() : step.spaces.size() <= 1 || !step.joint_step));
            for (const SpaceId space : step.spaces) is_known[space.index] = true;
        }
        CHECK(std::ranges::count(is_drawn, false) == 0);
        CHECK(!diagram.steps.back().bar);
        CHECK(diagram.steps.back().closes);
    }
}

TEST_CASE(
    "The polygon of a joint goes around: each side begins where the one before it ends, and what is found comes last")
{
    for (unsigned seed = 0; seed < n_seeds; ++seed) {
        CAPTURE(seed);
        const Truss truss = truss_in(random_planar_truss(seed, 15));
        const Reciprocal diagram = reciprocal(truss);
        for (const Step& step : diagram.joints.steps) {
            if (!step.joint) continue;
            const std::vector<PolygonSide> sides = diagram.polygon(truss, step);
            REQUIRE(sides.size() == step.forces.size());
            for (std::size_t i = 0; i < sides.size(); ++i) CHECK(sides[i].to == sides[(i + 1) % sides.size()].from);
            if (step.found.size() == 1) CHECK(sides.back().bar == step.found.front());
        }
    }
}

TEST_CASE("A compound truss, where every joint has three bars, is begun by a section")
{
    // Two triangles within one another, joined by three bars that do not meet: Desargues' configuration is none.
    TrussMaker made;
    made.node("A", {0, 0}, Pin).node("B", {9, 0}, Roller).node("C", {4, 7});
    made.node("D", {3, 2}).node("E", {5.5, 1.5}).node("F", {4.2, 4});
    made.bars({"AB", "BC", "CA", "DE", "EF", "FD", "AD", "BE", "CF"}).load("C", {3, -17}).load("B", {-2, -5});
    const Truss truss = truss_in(made.model);
    const Reciprocal diagram = reciprocal(truss);
    const Step& first = diagram.joints.steps.front();
    REQUIRE(first.kind == truss::StepKind::Cut);
    CHECK(first.cut->bars.size() == 3);
    check_laws(truss, diagram);
}

TEST_CASE("A Fink truss, where joint by joint comes to a stop, goes on by a section through its tie")
{
    TrussMaker made;
    for (const bool is_left : {true, false}) {
        const auto node = [&](char letter, double x, double y, SupportKind kind = SupportKind::Custom) {
            made.node(std::string(1, is_left ? letter : static_cast<char>(letter + 'a' - 'A')),
                      {is_left ? x : 16.0 - x, y}, kind);
        };
        node('A', 0.0, 0.0, is_left ? Pin : Roller);
        node('B', 2.0, 1.0);
        node('C', 4.0, 2.0);
        node('D', 6.0, 3.0);
        node('P', 2.5, 0.0);
        node('Q', 5.0, 0.0);
        node('R', 6.5, 2.0);
    }
    made.node("T", {8.0, 4.0}).bars({"AB", "BC", "CD", "DT", "AP", "PQ", "BP", "PC", "CQ", "CR", "RQ", "RT", "DR"});
    made.bars({"ab", "bc", "cd", "dT", "ap", "pq", "bp", "pc", "cq", "cr", "rq", "rT", "dr", "Qq"});
    for (const char* joint : {"B", "C", "D", "T", "d", "c", "b"}) made.load(joint, {0.0, -10.0});
    const Truss truss = truss_in(made.model);
    const Reciprocal diagram = reciprocal(truss);
    check_laws(truss, diagram);
    const MemberId tie = bar_named(made.model, "Q-q");
    const auto section = std::ranges::find_if(diagram.joints.steps, [&](const truss::Step& step) {
        return step.kind == truss::StepKind::Cut && step.found.front() == tie;
    });
    REQUIRE(section != diagram.joints.steps.end());
    const CutEquation& equation = section->cut->equations.front();
    REQUIRE(equation.ritter_point);
    CHECK((*equation.ritter_point - Eigen::Vector2d(8.0, 4.0)).norm() < 1e-9); // the ridge
    CHECK(section->cut->known.empty());
    CHECK(equation.force == doctest::Approx(truss[tie].force));
}

TEST_CASE("Zero-force bars carry nothing, and a rule finds those that textbooks find")
{
    for (unsigned seed = 0; seed < n_seeds; ++seed) {
        CAPTURE(seed);
        Model model = random_planar_truss(seed, 15);
        auto& loads = model.load_cases[0].nodes;
        loads.erase(loads.begin() + 2, loads.end());
        const Truss truss = truss_in(model);
        const std::vector<ZeroForceBar> zero = zero_force_bars(truss);
        std::set<MemberId> found;
        for (const ZeroForceBar& bar : zero) {
            CHECK(truss[bar.bar].force == 0.0);
            CHECK(found.insert(bar.bar).second);
        }
        CHECK(std::ranges::count(truss.bars, 0.0, &truss::Bar::force) == static_cast<std::ptrdiff_t>(found.size()));
    }
}

TEST_CASE("Each rule of zero-force bars is told by its name")
{
    // P and Q hang on two bars without load; post S-T meets a chord in line; at the roller the reaction is along a post.
    TrussMaker made;
    made.node("A", {0, 0}, Pin)
        .node("B", {4, 0})
        .node("C", {8, 0}, Roller)
        .node("D", {0, 3})
        .node("E", {4, 3})
        .node("F", {8, 3});
    made.bars({"AB", "BC", "AD", "BE", "CF", "DE", "EF", "AE", "EC"}).load("E", {0, -24});
    const Truss truss = truss_in(made.model);
    const std::vector<ZeroForceBar> zero = zero_force_bars(truss);
    const auto rule_of = [&](const std::string& id) {
        const auto found = std::ranges::find(zero, bar_named(made.model, id), &ZeroForceBar::bar);
        REQUIRE(found != zero.end());
        return found->rule;
    };
    CHECK(rule_of("B-E") == ZeroForceRule::ThirdBar);
    CHECK(rule_of("A-D") == ZeroForceRule::TwoBars);
    CHECK(rule_of("D-E") == ZeroForceRule::TwoBars);
    CHECK(zero.size() == 5);
}

TEST_CASE(
    "Zero-force bars are found again without those found before, joint after joint, each told what no longer counts")
{
    // A roof whose lower chord's middle alone is loaded: the posts beside it go first, then the struts that they held.
    TrussMaker made;
    made.node("A", {0, 0}, Pin).node("B", {12, 0}, Roller).node("C", {3, 0}).node("D", {6, 0}).node("E", {9, 0});
    made.node("F", {3, 2}).node("G", {6, 4}).node("H", {9, 2});
    made.bars({"AC", "CD", "DE", "EB", "AF", "FG", "GH", "HB", "CF", "DF", "DG", "DH", "EH"}).load("D", {0, -20});
    const Truss truss = truss_in(made.model);
    const auto steps = zero_force_steps(truss);
    const auto bar = [&](const char* id) { return bar_named(made.model, id); };
    REQUIRE(steps.size() == 4);
    CHECK(steps[0].front().bar == bar("C-F"));
    CHECK(steps[0].front().without.empty());
    CHECK(steps[2].front().bar == bar("D-F"));
    CHECK(steps[2].front().rule == ZeroForceRule::ThirdBar);
    CHECK(steps[2].front().without == std::vector{bar("C-F")});
}

TEST_CASE("Under a force along one of two bars the other carries nothing, and so the third beside a force in line")
{
    TrussMaker made;
    made.node("A", {0, 0}, Pin)
        .node("B", {0, 3}, Pin)
        .node("C", {4, 0})
        .node("D", {4, 3})
        .bars({"AC", "BC", "BD", "CD"});
    made.load("D", {6, 0});
    const Truss along = truss_in(made.model);
    const std::vector<ZeroForceBar> zero = zero_force_bars(along);
    REQUIRE(!zero.empty());
    CHECK(zero.front().bar == bar_named(made.model, "C-D"));
    CHECK(zero.front().rule == ZeroForceRule::ForceAlongBar);
    CHECK(zero.front().in_line == bar_named(made.model, "B-D"));

    TrussMaker line;
    line.node("A", {0, 0}, Pin).node("B", {4, 0}, Roller).node("C", {2, 3}).node("M", {2, 0});
    line.bars({"AM", "MB", "AC", "CB", "MC"}).load("M", {5, 0});
    const std::vector<ZeroForceBar> third = zero_force_bars(truss_in(line.model));
    REQUIRE(!third.empty());
    CHECK(third.front().rule == ZeroForceRule::ForceInLine);
}

TEST_CASE("The Ritter point of a chord is the joint where the other two bars meet, its arm the depth")
{
    const Model model = example("pratt_truss.json");
    const Truss truss = truss_in(model);
    const auto bars = bars_named(model, {"U2U3", "U2L3", "L2L3"});
    REQUIRE(!why_no_cut(truss, bars));
    const RitterCut cut = ritter_cut(truss, bars);
    REQUIRE(cut.equations.size() == 3);
    const CutEquation& chord = cut.equations[0];
    REQUIRE(chord.ritter_point);
    CHECK((*chord.ritter_point - Eigen::Vector2d(9.0, 0.0)).norm() < 1e-12);
    CHECK(std::abs(chord.factor) == doctest::Approx(4.0));
    CHECK(!cut.equations[1].ritter_point); // between parallel chords: forces across them
    for (const CutEquation& equation : cut.equations)
        CHECK(equation.force == doctest::Approx(truss[equation.bar].force));
}

TEST_CASE("A cut around the middle of a K finds both chords: all but one meet at the foot or the head of its post")
{
    const Model model = PlaneTruss{.pattern = TrussPattern::K}.model();
    const Truss truss = truss_in(model);
    const auto between = [&](const std::string& a, const std::string& b) {
        const NodeId first = *model.find_node(a), second = *model.find_node(b);
        const auto found = std::ranges::find_if(model.members, [&](const Member& member) {
            return member.nodes == std::array{first, second} || member.nodes == std::array{second, first};
        });
        REQUIRE(found != model.members.end());
        return MemberId(static_cast<std::size_t>(found - model.members.begin()));
    };
    const std::vector bars{between("U2", "U3"), between("U2", "M2"), between("M2", "L2"), between("L2", "L3")};
    REQUIRE(!why_no_cut(truss, bars));
    const RitterCut cut = ritter_cut(truss, bars);
    REQUIRE(cut.equations.size() == 2);
    CHECK(cut.equations[0].bar == bars[0]);
    CHECK(cut.equations[1].bar == bars[3]);
    for (const CutEquation& equation : cut.equations)
        CHECK(equation.force == doctest::Approx(truss[equation.bar].force));
}

TEST_CASE("Spaces are lettered without I and O, and clockwise from the leftmost reaction")
{
    Model model = PlaneTruss{.pattern = TrussPattern::Pratt, .panels = 40}.model();
    const Truss truss = truss_in(model);
    const Reciprocal diagram = reciprocal(truss);
    std::set<std::string> names;
    for (const Space& space : diagram.spaces) CHECK(names.insert(space.name).second);
    CHECK(!names.contains("I"));
    CHECK(!names.contains("O"));
    CHECK(names.contains("AA"));
    CHECK(truss.forces[diagram.forces.back()].joint == *model.find_node("L0"));
}
