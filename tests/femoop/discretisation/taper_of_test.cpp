#include <doctest/doctest.h>

#include "femoop/discretisation/taper_of.h"
#include "femoop/section/section_properties.h"
#include "femoop/section/tapered_section.h"

using namespace femoop;

namespace {

SectionShape shape_of(SectionShapeKind kind)
{
    SectionShape shape;
    shape.kind = kind;
    shape.h = 0.37;
    if (kind == SectionShapeKind::Rectangle || kind == SectionShapeKind::Box) shape.b = 0.23;
    else shape.bf = 0.19, shape.tf = 0.031, shape.tw = 0.017;
    if (kind == SectionShapeKind::Box) shape.t = 0.013;
    return shape;
}

} // namespace

TEST_SUITE("taper")
{
    TEST_CASE("A, Iz and Asy along a taper are those of the section that is as deep as the member there")
    {
        constexpr double first = 0.31, second = 0.74, length = 4.3;
        for (const SectionShapeKind kind :
             {SectionShapeKind::Rectangle, SectionShapeKind::Box, SectionShapeKind::I, SectionShapeKind::C}) {
            const Section section{.id = "s", .shape = shape_of(kind)};
            REQUIRE(can_taper(section));
            const Taper taper = taper_of(section, first, second, length);
            const SectionProperties at_first = section_properties(at_depth(section, first), {});
            for (const double x : {0.0, 0.7, 2.9, 4.3}) {
                const SectionProperties there = section_properties(
                    at_depth(section, first + (second - first) * x / length), {});
                const auto [a1, a2, a3] = taper.inertia;
                CHECK(at_first.A * (1.0 + taper.area * x) == doctest::Approx(there.A).epsilon(1e-13));
                CHECK(at_first.Iz * (1.0 + x * (a1 + x * (a2 + x * a3))) == doctest::Approx(there.Iz).epsilon(1e-13));
                CHECK(*at_first.Asy * (1.0 + taper.shear_area * x) == doctest::Approx(*there.Asy).epsilon(1e-13));
            }
        }
    }

    TEST_CASE("What has no straight axis, no depth or numbers of its own cannot taper")
    {
        Section tee{.id = "s", .shape = shape_of(SectionShapeKind::I)};
        tee.shape->kind = SectionShapeKind::T;
        Section turned{.id = "s", .shape = shape_of(SectionShapeKind::I), .turned = true};
        Section overridden{.id = "s", .shape = shape_of(SectionShapeKind::I), .Iz = 1e-4};
        for (const Section& section : {tee, turned, overridden, Section{.id = "s", .profile = "IPE 300"},
                                       Section{.id = "s", .A = 0.01, .Iz = 1e-4}})
            CHECK_FALSE(can_taper(section));
    }
}
