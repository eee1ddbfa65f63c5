#include <doctest/doctest.h>

#include <optional>

#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/line_shape.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::influence;

namespace {

constexpr double a = 5.0, b = 7.0, c = 2.0; // m: two spans, and the section in the first one

/// Two members in a row, A to B and B to C, held at A and C; B held where it has a kind.
Model row(std::optional<SupportKind> at_B)
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", a, 0, at_B).node("C", a + b, 0, SupportKind::Roller);
    made.member("A", "B").member("B", "C");
    return made.model;
}

LineShape shape(const Model& model, MemberComponent component)
{
    InfluenceAnalysis analysis(model);
    const PathLayout path = lay_out(model, {MemberId(0), MemberId(1)});
    return shape_of(analysis.line(path, unit_load(model.analysis, {}),
                                  {.quantity = ExpectedQuantity::SectionForce,
                                   .member = MemberId(0),
                                   .component = component,
                                   .at = Quantity(c)}));
}

} // namespace

TEST_CASE("The line of a moment of a simple beam is straight on both sides of its kink at the section")
{
    const LineShape M = shape(row({}), MemberComponent::Mz);
    REQUIRE(M.kinks.size() == 1);
    CHECK(M.kinks.front() == doctest::Approx(c));
    CHECK(M.jumps.empty());
    REQUIRE(M.zeros.size() == 2);
    CHECK(M.zeros.back() == doctest::Approx(a + b));
    REQUIRE(M.stretches.size() == 1);
    CHECK(M.stretches.front().degree == 1);
    CHECK(M.stretches.front().n_pieces == 2); // the node within the span changes nothing
}

TEST_CASE("The line of a shear of a simple beam jumps by 1 at the section, from -c/L to 1 - c/L")
{
    const LineShape V = shape(row({}), MemberComponent::Vy);
    REQUIRE(V.jumps.size() == 1);
    CHECK(V.jumps.front().s == doctest::Approx(c));
    CHECK(V.jumps.front().before == doctest::Approx(-c / (a + b)));
    CHECK(V.jumps.front().after == doctest::Approx(1.0 - c / (a + b)));
    CHECK(V.kinks.empty());
    CHECK(V.zeros.size() == 2);
}

TEST_CASE("A line of two spans is cubic, zero over each support, and without a kink over the inner one")
{
    const LineShape M = shape(row(SupportKind::Roller), MemberComponent::Mz);
    REQUIRE(M.zeros.size() == 3);
    CHECK(M.zeros[1] == doctest::Approx(a));
    CHECK(M.kinks.size() == 1);
    REQUIRE(M.stretches.size() == 1);
    CHECK(M.stretches.front().degree == 3);
    CHECK(M.stretches.front().n_pieces == 3);
}

TEST_CASE("A stretch along which a line is zero is no row of zeros")
{
    FrameMaker made; // a beam with an overhang behind a hinge: nothing beyond it loads the first member
    made.node("A", 0, 0, SupportKind::Fixed).node("B", a, 0, SupportKind::Roller);
    made.node("C", a + b, 0, SupportKind::Roller).member("A", "B").member("B", "C");
    made.model.members[1].start.release.insert(Dof::rz);
    const LineShape M = shape(made.model, MemberComponent::Mz);
    REQUIRE(M.stretches.size() == 2);
    CHECK(M.stretches.back().is_zero);
    CHECK(M.stretches.back().from == doctest::Approx(a));
    REQUIRE(M.zeros.size() == 1);
    CHECK(M.zeros.front() == doctest::Approx(0.0));
}
