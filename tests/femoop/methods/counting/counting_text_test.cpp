#include <doctest/doctest.h>

#include "femoop/io/counting/counting_text.h"
#include "tests/frame_maker.h"

using namespace femoop;
using counting::count;
using counting::counting_text;
using enum SupportKind;

namespace {

/// A closed frame on two feet, with a hinge at the end of its upper member.
FrameMaker closed_frame()
{
    FrameMaker made;
    made.node("A", 0, 0, Fixed).node("B", 5, 0, Roller).node("C", 5, 4).node("D", 0, 4);
    made.member("A", "B").member("B", "C").member("C", "D").member("D", "A");
    made.model.members[2].start.release = {Dof::rz};
    return made;
}

std::string text_of(const Model& model) { return counting_text(count(model), model, english); }

} // namespace

TEST_CASE("The sum names what it counts, whole and in parts, and then where each stands")
{
    CHECK(text_of(closed_frame().model) ==
          "Degree of indeterminacy: 1 ring × 3 − 1 release + 4 reactions − 1 part × 3 = 3\n"
          "External: 4 reactions − 1 part × 3 = 1\n"
          "Internal: 1 ring × 3 − 1 release = 2\n"
          "  ring 1 of AB, BC, CD, DA: +3\n"
          "  releases at C (CD 1): −1\n"
          "  support A: +3\n"
          "  support B: +1\n");
}

TEST_CASE("A truss is counted by its members and nodes")
{
    FrameMaker made = closed_frame();
    made.model.members[2].start.release = {};
    made.model.analysis = AnalysisKind::Truss2d;
    made.model.nodes[0].support = Support{.kind = Pin};
    made.member("A", "C");
    CHECK(text_of(made.model) == "Degree of indeterminacy: 5 members + 3 reactions − 4 nodes × 2 = 0\n"
                                 "External: 3 reactions − 1 part × 3 = 0\n"
                                 "Internal: 5 members − (4 nodes × 2 − 1 part × 3) = 0\n"
                                 "  support A: +2\n"
                                 "  support B: +1\n");
}

TEST_CASE("What moves although the count allows it not to is said, and what counts nothing is named")
{
    FrameMaker made;
    made.node("A", 0, 0, Roller).node("B", 3, 0, Roller).node("C", 7, 0, Roller).node("X", 9, 9);
    made.member("A", "B").member("B", "C");
    const std::string text = text_of(made.model);
    CHECK(text.find("It can move without strain in 1 way: 0 = 1 state of self-stress − 1 motion") != std::string::npos);
    CHECK(text.find("Nodes without members do not count: X") != std::string::npos);
}

TEST_CASE("What hinges take from what the supports give is said beside the negative internal degree")
{
    FrameMaker made; // an arch of three hinges
    made.node("A", 0, 0, Pin).node("B", 3, 2).node("C", 7, 0, Pin).member("A", "B").member("B", "C");
    made.model.nodes[1].hinge = true;
    const std::string text = text_of(made.model);
    CHECK(text.find("\nInternal: 0 rings × 3 − 1 release = −1, taken from what the supports give\n") !=
          std::string::npos);
}

TEST_CASE("On a continuous foundation there is no sum of reactions, and what is internal is counted all the same")
{
    FrameMaker made = closed_frame();
    made.model.members[0].foundation = Quantity(5000.0);
    CHECK(text_of(made.model) ==
          "Degree of indeterminacy: infinite, since a continuous foundation reacts at every place of its members\n"
          "External: 4 reactions and infinitely many of the foundation\n"
          "Internal: 1 ring × 3 − 1 release = 2\n"
          "  ring 1 of AB, BC, CD, DA: +3\n"
          "  releases at C (CD 1): −1\n"
          "  support A: +3\n"
          "  support B: +1\n");
}
