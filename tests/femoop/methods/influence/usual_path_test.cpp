#include "femoop/methods/influence/usual_path.h"

#include <doctest/doctest.h>

#include "femoop/methods/influence/load_path.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::influence;

namespace {

/// A deck A - B - C - D, CB drawn backwards, on a column from E up to B.
Model bridge_on_column()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 3, 0).node("C", 7, 0, SupportKind::Roller).node("D", 12, 0);
    made.node("E", 3, -20, SupportKind::Fixed).member("C", "D").member("C", "B").member("A", "B").member("E", "B");
    return made.model;
}

std::vector<std::string> names(const Model& model, const std::vector<MemberId>& path)
{
    std::vector<std::string> found;
    for (const MemberId member : path) found.push_back(model[member].id);
    return found;
}

using Names = std::vector<std::string>;

MovingEffect moment(const Model& model, std::string_view member)
{
    return {.quantity = ExpectedQuantity::SectionForce,
            .member = model.find_member(member),
            .component = MemberComponent::Mz,
            .at = Percent{50}};
}

MovingEffect reaction(const Model& model, std::string_view node)
{
    return {.quantity = ExpectedQuantity::Reaction, .node = model.find_node(node), .dof = Dof::uy};
}

} // namespace

TEST_CASE("A deck is the members that go on straight, from left to right whatever their own direction")
{
    const Model model = bridge_on_column();
    for (const char* member : {"AB", "CB", "CD"})
        CHECK(names(model, straight_path(model, *model.find_member(member))) == Names{"AB", "CB", "CD"});
    CHECK(names(model, straight_path(model, *model.find_member("EB"))) == Names{"EB"});
    CHECK_NOTHROW(lay_out(model, straight_path(model, *model.find_member("CB"))));
}

TEST_CASE("A load passes the deck, whatever is asked for of deck or column")
{
    const Model model = bridge_on_column();
    const NodeVector down = unit_load(model.analysis, {});
    for (const MovingEffect& effect :
         {moment(model, "CB"), moment(model, "EB"), reaction(model, "C"), reaction(model, "E")})
        CHECK(names(model, usual_path(model, effect, down)) == Names{"AB", "CB", "CD"});
    const NodeVector sideways = unit_load(model.analysis, {{.dof = Dof::ux, .value = 1.0}});
    CHECK(names(model, usual_path(model, moment(model, "CB"), sideways)) == Names{"EB"});
}

TEST_CASE("A path of the file comes before any that is found")
{
    Model model = bridge_on_column();
    model.moving_loads.paths = {{"end span", {*model.find_member("CD")}}, {"start span", {*model.find_member("AB")}}};
    const NodeVector down = unit_load(model.analysis, {});
    CHECK(names(model, usual_path(model, moment(model, "AB"), down)) == Names{"AB"});
    CHECK(names(model, usual_path(model, moment(model, "EB"), down)) == Names{"CD"});
}

TEST_CASE("In a truss the load passes the longest chord, not the bar that is asked for")
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 4, 0).node("C", 8, 0, SupportKind::Roller).node("D", 4, 3);
    made.member("A", "D").member("A", "B").member("B", "C").member("D", "C").member("B", "D");
    made.model.analysis = AnalysisKind::Truss2d;
    MovingEffect force = moment(made.model, "BD");
    force.component = MemberComponent::N;
    CHECK(names(made.model, usual_path(made.model, force, unit_load(AnalysisKind::Truss2d, {}))) == Names{"AB", "BC"});
}

TEST_CASE("A support has the reactions that it can bear, in either global direction where it is turned")
{
    Model model = bridge_on_column();
    CHECK(reactions_at(model, *model.find_node("E")).size() == 3);
    CHECK(reactions_at(model, *model.find_node("C")).size() == 1);
    CHECK(reactions_at(model, *model.find_node("B")).empty());
    model.nodes[model.find_node("C")->index].support->angle = Quantity(0.5);
    CHECK(reactions_at(model, *model.find_node("C")).size() == 2);
}

TEST_CASE(
    "A row of members is found in whatever order they are chosen, from the left; a fork, a ring and a gap are none")
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 3, 2).node("C", 7, 3).node("D", 12, 0, SupportKind::Pin);
    made.node("E", 3, 6).member("C", "B").member("C", "D").member("A", "B").member("B", "E").member("A", "D");
    const auto row = [&](const Names& chosen) {
        std::vector<MemberId> members;
        for (const std::string& name : chosen) members.push_back(*made.model.find_member(name));
        const auto found = row_of(made.model, members);
        return found ? names(made.model, *found) : Names{};
    };
    CHECK(row({"CD", "AB", "CB"}) == Names{"AB", "CB", "CD"});
    CHECK(row({"CD"}) == Names{"CD"});
    CHECK(row({"BE", "CB"}) == Names{"BE", "CB"});
    CHECK(row({"AB", "CB", "BE"}).empty());
    CHECK(row({"AB", "CB", "CD", "AD"}).empty());
    CHECK(row({"AB", "CD"}).empty());
    CHECK(row({}).empty());
}
