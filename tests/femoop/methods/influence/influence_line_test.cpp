#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/usual_path.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::influence;

namespace {

constexpr double L = 8.0, x = 3.0; // m

Model simple_beam()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", L, 0, SupportKind::Roller).member("A", "B");
    return made.model;
}

/// Two spans of 5 and 7.
Model two_spans()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 5, 0, SupportKind::Roller).node("C", 12, 0, SupportKind::Roller);
    made.member("A", "B").member("B", "C");
    return made.model;
}

std::vector<MemberId> all_members(const Model& model)
{
    std::vector<MemberId> members;
    for (std::size_t i = 0; i < model.members.size(); ++i) members.emplace_back(i);
    return members;
}

MovingEffect force(const Model& model, const std::string& member, MemberComponent component, double at)
{
    return {.quantity = ExpectedQuantity::SectionForce,
            .member = model.find_member(member),
            .component = component,
            .at = Quantity(at)};
}

MovingEffect reaction(const Model& model, const std::string& node, Dof dof)
{
    return {.quantity = ExpectedQuantity::Reaction, .node = model.find_node(node), .dof = dof};
}

InfluenceLine line_of(const Model& model, const MovingEffect& effect, const std::vector<Component>& load = {})
{
    InfluenceAnalysis analysis(model);
    return analysis.line(lay_out(model, all_members(model)), unit_load(model.analysis, load), effect);
}

} // namespace

TEST_CASE("The line of M in a simple beam is a triangle of x (L - x) / L over the section")
{
    const Model model = simple_beam();
    const InfluenceLine line = line_of(model, force(model, "AB", MemberComponent::Mz, x));
    CHECK(line.ordinates.max().value == doctest::Approx(x * (L - x) / L));
    CHECK(line.ordinates.max().positions == std::vector<double>{x});
    CHECK(line.ordinates.value(0.5 * x) == doctest::Approx(0.5 * x * (L - x) / L));
    REQUIRE(line.stretches.size() == 2);
    CHECK(line.ordinates.pieces[0].coefficients.size() == 2); // no rounding is left of t^2 and t^3
}

TEST_CASE("The line of V in a simple beam steps by 1 at the section")
{
    const Model model = simple_beam();
    const InfluenceLine line = line_of(model, force(model, "AB", MemberComponent::Vy, x));
    CHECK(line.ordinates.value(x, Side::Before) == doctest::Approx(-x / L));
    CHECK(line.ordinates.value(x, Side::After) == doctest::Approx(1.0 - x / L));
    CHECK(line.ordinates.jumps() == std::vector<double>{x});
}

TEST_CASE("A section at the end of a member is inside its support")
{
    const Model model = two_spans();
    const InfluenceLine before = line_of(model, force(model, "AB", MemberComponent::Vy, 5.0));
    CHECK(before.ordinates.value(5.0, Side::Before) == doctest::Approx(-1.0));
    CHECK(before.ordinates.value(5.0, Side::After) == doctest::Approx(0.0));
    const InfluenceLine after = line_of(model, force(model, "BC", MemberComponent::Vy, 0.0));
    CHECK(after.ordinates.value(5.0, Side::Before) == doctest::Approx(0.0));
    CHECK(after.ordinates.value(5.0, Side::After) == doctest::Approx(1.0));
}

TEST_CASE("The line of a reaction is 1 at its own support and 0 at the others")
{
    const Model model = two_spans();
    const InfluenceLine line = line_of(model, reaction(model, "B", Dof::uy));
    CHECK(line.ordinates.value(0.0) == doctest::Approx(0.0));
    CHECK(line.ordinates.value(5.0) == doctest::Approx(1.0));
    CHECK(line.ordinates.value(12.0) == doctest::Approx(0.0));
}

TEST_CASE("The area under a line is the effect of a uniform load of 1")
{
    Model model = two_spans();
    const MovingEffect M = force(model, "BC", MemberComponent::Mz, 2.5);
    const LineAreas areas = line_of(model, M).ordinates.areas();
    for (const MemberId member : all_members(model))
        model.load_cases[0].members.push_back({member, DistributedLoad{.values = {{.dof = Dof::uy, .start = -1.0}}}});
    const double wanted = analyse(model).at("P").curve(*M.member).value(MemberComponent::Mz, 2.5);
    CHECK(areas.positive + areas.negative == doctest::Approx(wanted));
}

TEST_CASE("What an inclined roller does to the structure is one force: its lines are proportional")
{
    Model model = two_spans();
    model.nodes[2].support = Support{.kind = SupportKind::Custom, .fixed = {Dof::uy}, .angle = 30.0};
    const InfluenceLine fx = line_of(model, reaction(model, "C", Dof::ux));
    const InfluenceLine fy = line_of(model, reaction(model, "C", Dof::uy));
    for (const double s : {2.0, 6.0, 11.0})
        CHECK(fx.ordinates.value(s) == doctest::Approx(-std::tan(M_PI / 6.0) * fy.ordinates.value(s)));
}

TEST_CASE("A bar carries a load between its nodes as a simple beam")
{
    Model model = two_spans();
    model.members[0].bar = true;
    const InfluenceLine M = line_of(model, force(model, "AB", MemberComponent::Mz, 2.0));
    CHECK(M.ordinates.value(2.0) == doctest::Approx(2.0 * 3.0 / 5.0));
    CHECK(M.ordinates.value(8.0) == 0.0);
}

TEST_CASE("On a foundation a stretch is its member's closed form")
{
    Model model = two_spans();
    model.members[1].foundation = 4000.0;
    const InfluenceLine line = line_of(model, force(model, "BC", MemberComponent::Mz, 2.5));
    REQUIRE(line.stretches.size() == 3);
    CHECK_FALSE(line.stretches[0].is_series);
    CHECK(line.stretches[1].is_series);
    CHECK(line.stretches[2].from == doctest::Approx(7.5));
    CHECK(line.stretches[2].to == doctest::Approx(12.0));
}

TEST_CASE("On a foundation a section that comes near an end has the line of the end")
{
    FrameMaker made;
    made.node("A", 0, 0).node("B", 4, 0).node("C", 8, 0).member("A", "B").member("B", "C");
    made.model.nodes[1].support.emplace().fixed = {Dof::ux};
    for (Member& member : made.model.members) member.foundation = 20000.0;
    for (const double near : {1e-3, 1e-6, 1e-9, 1e-11}) {
        CAPTURE(near);
        const auto at = [&](const std::string& member, MemberComponent component, double x) {
            return line_of(made.model, force(made.model, member, component, x)).ordinates;
        };
        CHECK(at("AB", MemberComponent::Mz, near).largest() <= 1.001 * near); // an end that is free
        CHECK(at("BC", MemberComponent::Mz, 4.0 - near).largest() <= 1.001 * near);
        const PiecewiseLine before = at("AB", MemberComponent::Vy, 4.0 - near),
                            after = at("BC", MemberComponent::Vy, near);
        for (const double s : {0.7, 2.9, 4.3, 7.1})
            CHECK(std::abs(before.value(s) - after.value(s)) <= 5.0 * near); // nothing happens between them
        CHECK(before.largest() <= 1.0);
    }
}

TEST_CASE("A couple that moves over a simple beam bends it by its lever")
{
    const Model model = simple_beam();
    const InfluenceLine line = line_of(model, force(model, "AB", MemberComponent::Mz, x), {{Dof::rz, 1.0}});
    CHECK(line.ordinates.value(0.5 * x) == doctest::Approx(-(1.0 - x / L)));
    CHECK(line.ordinates.value(L) == doctest::Approx(x / L));
}

TEST_CASE("A line that is zero by nature is not rounding")
{
    const Model model = simple_beam();
    const InfluenceLine line = line_of(model, force(model, "AB", MemberComponent::N, x));
    CHECK(line.ordinates.largest() == 0.0);
}

TEST_CASE(
    "The line of a displacement that a support holds is 0 along the whole path, also where the support is inclined")
{
    Model model = two_spans(), turned = two_spans();
    const auto moved = [](const Model& of, const std::string& node, Dof dof) {
        return MovingEffect{.quantity = ExpectedQuantity::Displacement, .node = of.find_node(node), .dof = dof};
    };
    const auto within = [](const Model& of, const std::string& member, MemberComponent component, double at) {
        MovingEffect effect = force(of, member, component, at);
        effect.quantity = ExpectedQuantity::Displacement;
        return effect;
    };
    model.nodes[2].support = Support{.kind = SupportKind::Fixed};
    for (const MovingEffect& effect : {moved(model, "A", Dof::uy), moved(model, "B", Dof::uy),
                                       moved(model, "C", Dof::rz), within(model, "AB", MemberComponent::v, 5.0)}) {
        CHECK(line_of(model, effect).ordinates.largest() == 0.0);
        CHECK(holding_support(model, effect).has_value());
        CHECK(InfluenceAnalysis(model).motion(effect).empty());
    }
    for (const MovingEffect& effect :
         {moved(model, "A", Dof::rz), within(model, "AB", MemberComponent::v, 4.0), reaction(model, "A", Dof::uy)})
        CHECK_FALSE(holding_support(model, effect).has_value());
    CHECK_FALSE(holding_support(model, moved(model, "B", Dof::ux)).has_value());
    turned.nodes[2].support = Support{.kind = SupportKind::Roller, .angle = 30.0}; // slides along the incline
    CHECK(line_of(turned, moved(turned, "C", Dof::uy)).ordinates.largest() > 0.0);
    turned.nodes[2].support = Support{.kind = SupportKind::Pin, .angle = 30.0};
    CHECK(line_of(turned, moved(turned, "C", Dof::uy)).ordinates.largest() == 0.0);
    turned.nodes[2].support = Support{.kind = SupportKind::Roller, .angle = 90.0}; // holds sideways
    CHECK(holding_support(turned, moved(turned, "C", Dof::ux)) == turned.find_node("C"));
    CHECK_FALSE(holding_support(turned, moved(turned, "C", Dof::uy)).has_value());
}

TEST_CASE("A support that is a spring, a joint that slips and a rigid arm let what they hold move")
{
    Model model = two_spans();
    model.nodes[1].support = Support{.springs = {{Dof::uy, 3e4}}};
    MovingEffect end = force(model, "AB", MemberComponent::v, 0.0);
    end.quantity = ExpectedQuantity::Displacement;
    const MovingEffect sprung{.quantity = ExpectedQuantity::Displacement, .node = NodeId(1), .dof = Dof::uy};
    CHECK_FALSE(holding_support(model, sprung).has_value());
    CHECK(holding_support(model, end) == model.find_node("A"));
    Model slipping = model, on_arm = model;
    slipping.members[0].start.springs = {{Dof::uy, 5e4}};
    on_arm.members[0].start.offset = {0.4, 0.0};
    CHECK_FALSE(holding_support(slipping, end).has_value());
    CHECK_FALSE(holding_support(on_arm, end).has_value());
    CHECK(line_of(slipping, end).ordinates.largest() > 0.0);
    CHECK(line_of(on_arm, end).ordinates.largest() > 0.0);
}

TEST_CASE("At a hinge the moment's line is 0, not what rounding leaves of a motion")
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 8, 0, SupportKind::Roller).node("E", 10, 0).node("F", 15, 0);
    made.node("C", 17, 0, SupportKind::Roller).node("D", 25, 0, SupportKind::Roller);
    made.member("A", "B").member("B", "E").member("E", "F").member("F", "C").member("C", "D");
    made.model.nodes[2].hinge = made.model.nodes[3].hinge = true;
    const InfluenceLine line = line_of(made.model, force(made.model, "EF", MemberComponent::Mz, 0.0));
    CHECK(line.ordinates.largest() == 0.0);
}

TEST_CASE("A structure that moves under the load has no lines")
{
    Model model = simple_beam();
    model.nodes[0].support = Support{.kind = SupportKind::Roller};
    CHECK_THROWS_AS(InfluenceAnalysis{model}, MechanismError);
}

TEST_CASE("A node that all its hinges leave free to turn takes no part: the line of its rotation is zero")
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Fixed).node("B", 4, 0).node("C", 9, 0, SupportKind::Fixed);
    made.member("A", "B").member("B", "C");
    made.model.nodes[1].hinge = true;
    const MovingEffect turn{.quantity = ExpectedQuantity::Displacement, .node = NodeId(1), .dof = Dof::rz};
    CHECK(line_of(made.model, turn).ordinates.largest() == 0.0);
    CHECK(InfluenceAnalysis(made.model).motion(turn).empty()); // and nothing moves by a couple on it
}

TEST_CASE("The line is how the path moves when the structure is released by 1")
{
    const Model model = two_spans();
    InfluenceAnalysis analysis(model);
    const PathLayout path = lay_out(model, all_members(model));
    for (const MovingEffect& effect : {force(model, "BC", MemberComponent::Mz, 2.5),
                                       force(model, "AB", MemberComponent::Vy, 3.0), reaction(model, "B", Dof::uy)}) {
        const std::vector<MemberMotion> motion = analysis.motion(effect);
        const InfluenceLine line = analysis.line(path, unit_load(model.analysis, {}), effect);
        REQUIRE(motion.size() == model.members.size());
        for (const PathMember& on : path.members)
            for (const MotionPiece& piece : motion[on.member.index]) {
                const double middle = 0.5 * (piece.from + piece.to);
                const double down = -piece.along[static_cast<std::size_t>(LocalAxis::y)](middle - piece.from);
                CHECK(down == doctest::Approx(line.ordinates.value(on.s_of(middle))));
            }
    }
}

TEST_CASE("Stations are so many places of each member, and both sides of a jump")
{
    const Model model = two_spans();
    const InfluenceLine line = line_of(model, force(model, "BC", MemberComponent::Vy, 2.3));
    const std::vector<LineStation> found = stations(line, 3);
    std::vector<double> places;
    for (const LineStation& station : found) places.push_back(station.s);
    CHECK(places == std::vector<double>{0.0, 2.5, 5.0, 7.3, 7.3, 8.5, 12.0});
    CHECK(found[4].value - found[3].value == doctest::Approx(1.0));
}

TEST_CASE("A dozen lines are found at once as one by one")
{
    const Model model = two_spans();
    const PathLayout path = lay_out(model, all_members(model));
    std::vector<MovingEffect> effects;
    for (int i = 0; i < 12; ++i) effects.push_back(force(model, "BC", MemberComponent::Mz, 0.5 * i));
    InfluenceAnalysis analysis(model);
    const auto together = analysis.lines(path, unit_load(model.analysis, {}), effects);
    for (std::size_t i = 0; i < effects.size(); ++i) {
        const InfluenceLine alone = analysis.line(path, unit_load(model.analysis, {}), effects[i]);
        CHECK(together[i].ordinates.value(7.7) == doctest::Approx(alone.ordinates.value(7.7)));
    }
}

TEST_CASE("The lines of a cantilever of a thousand members, or with one of a millimetre, are those of one member")
{
    std::vector<double> thousand, millimetre{0.0, 3.33, 3.331, 10.0};
    for (int i = 0; i <= 1000; ++i) thousand.push_back(0.01 * i);
    for (const std::vector<double>& places : {thousand, millimetre})
        for (const double slope : {0.0, 0.75}) {
            CAPTURE(places.size());
            CAPTURE(slope);
            FrameMaker made;
            for (std::size_t i = 0; i < places.size(); ++i) {
                made.node(std::to_string(i), places[i], slope * places[i]);
                if (i > 0) made.member(std::to_string(i - 1), std::to_string(i), "-");
            }
            made.model.nodes[0].support = Support{.kind = SupportKind::Fixed};
            const std::size_t m = places.size() > 4 ? 333 : 1;
            const std::string member = std::to_string(m) + "-" + std::to_string(m + 1);
            InfluenceAnalysis analysis(made.model);
            const PathLayout path = lay_out(made.model, all_members(made.model));
            const std::vector<MovingEffect> effects{force(made.model, member, MemberComponent::Mz, 0.0),
                                                    force(made.model, member, MemberComponent::Vy, 0.0)};
            const auto lines = analysis.lines(path, unit_load(made.model.analysis, {}), effects);
            const double s = std::hypot(1.0, slope);
            const PiecewiseLine &M = lines[0].ordinates, &V = lines[1].ordinates;
            CHECK(M.value(10.0 * s) == doctest::Approx(-6.67).epsilon(1e-9));
            CHECK(M.value(5.0 * s) == doctest::Approx(-1.67).epsilon(1e-9));
            CHECK(std::abs(M.value(2.0 * s)) < 1e-9);
            CHECK(V.value(10.0 * s) == doctest::Approx(1.0 / s).epsilon(1e-9));
            CHECK(V.value(4.0 * s) == doctest::Approx(1.0 / s).epsilon(1e-9));
            CHECK(std::abs(V.value(2.0 * s)) < 1e-9);
            CHECK(analysis.warnings().empty());
        }
}
