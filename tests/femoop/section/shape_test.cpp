#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>

#include "femoop/section/section_properties.h"
#include "femoop/section/shape.h"

using namespace femoop;

namespace {

/// A sound shape of each kind.
SectionShape sound(SectionShapeKind kind)
{
    SectionShape shape;
    shape.kind = kind;
    for (const ShapeDimension& dimension : dimensions(kind))
        shape.*dimension.value = dimension.key.starts_with('t') ? 0.01 : 0.2;
    return shape;
}

std::string reason(const SectionShape& shape)
{
    const auto fault = why_not(shape);
    return fault ? message(*fault) : "";
}

} // namespace

TEST_CASE("A shape of each kind with thin walls has nothing against it")
{
    for (const SectionShapeKind kind : section_shape_kinds()) {
        CAPTURE(name(kind));
        CHECK(reason(sound(kind)) == "");
        CHECK(shape_properties(sound(kind)).A > 0.0);
    }
}

TEST_CASE("Each dimension of each kind is needed, and must be a positive length")
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const SectionShapeKind kind : section_shape_kinds())
        for (const ShapeDimension& dimension : dimensions(kind)) {
            CAPTURE(name(kind));
            CAPTURE(dimension.key);
            SectionShape shape = sound(kind);
            (shape.*dimension.value).reset();
            REQUIRE(why_not(shape).has_value());
            CHECK(why_not(shape)->flaw == ShapeFlaw::Missing);
            CHECK(why_not(shape)->key == dimension.key);
            for (const double bad : {0.0, -0.01, nan, HUGE_VAL}) {
                shape.*dimension.value = bad;
                REQUIRE(why_not(shape).has_value());
                CHECK(why_not(shape)->flaw == ShapeFlaw::NotPositive);
                CHECK(why_not(shape)->key == dimension.key);
            }
        }
}

TEST_CASE("A dimension that the kind does not have is refused, not ignored")
{
    for (const SectionShapeKind kind : section_shape_kinds())
        for (const ShapeDimension& dimension : shape_dimensions()) {
            SectionShape shape = sound(kind);
            if (shape.*dimension.value) continue;
            CAPTURE(name(kind));
            CAPTURE(dimension.key);
            shape.*dimension.value = 0.1;
            REQUIRE(why_not(shape).has_value());
            CHECK(why_not(shape)->flaw == ShapeFlaw::Unneeded);
            CHECK(why_not(shape)->key == dimension.key);
        }
}

TEST_CASE("Walls that would overlap are refused with the limit")
{
    struct Case {
        SectionShapeKind kind;
        std::optional<Quantity> SectionShape::*thickness;
        double limit;
        const char* reason;
    };
    const Case cases[]{{SectionShapeKind::Tube, &SectionShape::t, 0.1, "t is 0.1, which is not less than d/2 = 0.1"},
                       {SectionShapeKind::Box, &SectionShape::t, 0.1, "t is 0.1, which is not less than b/2 = 0.1"},
                       {SectionShapeKind::I, &SectionShape::tf, 0.1, "tf is 0.1, which is not less than h/2 = 0.1"},
                       {SectionShapeKind::I, &SectionShape::tw, 0.2, "tw is 0.2, which is not less than bf = 0.2"},
                       {SectionShapeKind::T, &SectionShape::tf, 0.2, "tf is 0.2, which is not less than h = 0.2"},
                       {SectionShapeKind::T, &SectionShape::tw, 0.2, "tw is 0.2, which is not less than bf = 0.2"},
                       {SectionShapeKind::L, &SectionShape::t, 0.2, "t is 0.2, which is not less than b = 0.2"},
                       {SectionShapeKind::C, &SectionShape::tf, 0.1, "tf is 0.1, which is not less than h/2 = 0.1"},
                       {SectionShapeKind::C, &SectionShape::tw, 0.2, "tw is 0.2, which is not less than bf = 0.2"}};
    for (const Case& c : cases) {
        CAPTURE(c.reason);
        SectionShape shape = sound(c.kind);
        shape.*c.thickness = c.limit;
        CHECK(reason(shape) == c.reason);
        shape.*c.thickness = 0.999 * c.limit;
        CHECK(reason(shape) == "");
    }
}

TEST_CASE("The properties of an impossible shape are refused with the same reason")
{
    SectionShape shape = sound(SectionShapeKind::Tube);
    shape.t = 0.3;
    CHECK_THROWS_WITH_AS(shape_properties(shape), "t is 0.3, which is not less than d/2 = 0.1", std::invalid_argument);
}
