// The outlines that pictures show are those that the numbers belong to.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "femoop/section/outline.h"
#include "femoop/section/principal_axes.h"
#include "femoop/section/profile.h"
#include "femoop/section/section_properties.h"
#include "tests/femoop/section/outline.h"

using namespace femoop;

namespace {

AreaMoments moments_of(const SectionOutline& outline)
{
    const auto points = [](const std::vector<femoop::OutlinePoint>& from) {
        std::vector<::OutlinePoint> to;
        for (const femoop::OutlinePoint& p : from) to.push_back({p.z, p.y});
        return to;
    };
    return area_moments(points(outline.hole), area_moments(points(outline.outer)));
}

const SectionShape shapes[] = {
    {.kind = SectionShapeKind::Rectangle, .b = 0.2, .h = 0.5},
    {.kind = SectionShapeKind::Circle, .d = 0.3},
    {.kind = SectionShapeKind::Tube, .d = 0.3, .t = 0.02},
    {.kind = SectionShapeKind::Box, .b = 0.2, .h = 0.35, .t = 0.012},
    {.kind = SectionShapeKind::I, .h = 0.3, .bf = 0.17, .tf = 0.013, .tw = 0.008},
    {.kind = SectionShapeKind::T, .h = 0.25, .bf = 0.18, .tf = 0.03, .tw = 0.02},
    {.kind = SectionShapeKind::L, .b = 0.09, .h = 0.15, .t = 0.011},
    {.kind = SectionShapeKind::C, .h = 0.2, .bf = 0.075, .tf = 0.0115, .tw = 0.0085},
};

} // namespace

TEST_SUITE("section outline")
{
    TEST_CASE("The outline of every shape has the shape's area and second moments, about its centroid")
    {
        for (const SectionShape& shape : shapes) {
            CAPTURE(static_cast<int>(shape.kind));
            const bool is_round = shape.kind == SectionShapeKind::Circle || shape.kind == SectionShapeKind::Tube;
            const double tolerance = is_round ? 6e-3 : 1e-9; // 72 sides
            const SectionOutline figure = outline(shape);
            const AreaMoments m = moments_of(figure);
            const SectionProperties s = shape_properties(shape);
            CHECK(m.A == doctest::Approx(s.A).epsilon(tolerance));
            CHECK(m.Iyy == doctest::Approx(s.Iz).epsilon(tolerance));
            CHECK(m.Izz == doctest::Approx(s.Iy).epsilon(tolerance));
            CHECK(m.Iyz == doctest::Approx(s.Iyz).epsilon(1e-9));
            CHECK(std::abs(m.Sy) < 1e-12);
            CHECK(std::abs(m.Sz) < 1e-12);
            CHECK(-figure.bottom == doctest::Approx(*s.yc));
            CHECK(figure.height() == doctest::Approx(*s.h));
        }
    }

    TEST_CASE("A section that is turned on its side has the properties of its figure turned counter-clockwise")
    {
        for (const SectionShape& shape : shapes) {
            CAPTURE(static_cast<int>(shape.kind));
            const Section upright{.id = "s", .shape = shape}, lying{.id = "s", .shape = shape, .turned = true};
            const SectionOutline before = *outline(upright, {}), after = *outline(lying, {});
            for (std::size_t i = 0; i < before.outer.size(); ++i) {
                CHECK(after.outer[i].y == before.outer[i].z);
                CHECK(after.outer[i].z == -before.outer[i].y);
            }
            const bool is_round = shape.kind == SectionShapeKind::Circle || shape.kind == SectionShapeKind::Tube;
            const double tolerance = is_round ? 6e-3 : 1e-9; // 72 sides
            const AreaMoments m = moments_of(after);
            const SectionProperties s = section_properties(lying, {});
            CHECK(m.A == doctest::Approx(s.A).epsilon(tolerance));
            CHECK(m.Iyy == doctest::Approx(s.Iz).epsilon(tolerance));
            CHECK(m.Izz == doctest::Approx(s.Iy).epsilon(tolerance));
            CHECK(m.Iyz == doctest::Approx(s.Iyz).epsilon(1e-9));
            CHECK(after.height() == doctest::Approx(*s.h));
            CHECK(after.width() == doctest::Approx(*s.b));
            CHECK(-after.bottom == doctest::Approx(*s.yc));
            CHECK(-after.left == doctest::Approx(*s.zc));
            CHECK(*s.Wz == doctest::Approx(s.Iz / std::max(after.top, -after.bottom)));
            CHECK(s.J == shape_properties(shape).J);
            CHECK(*s.Asy == *shape_properties(shape).Asz);
        }
    }

    TEST_CASE("Turned four times a section stands as it stood, twice upside down")
    {
        const SectionProperties s = shape_properties(shapes[6]), half = turned(turned(s)), whole = turned(turned(half));
        CHECK(half.Iz == s.Iz);
        CHECK(half.Iyz == s.Iyz);
        CHECK(*half.yc == doctest::Approx(*s.h - *s.yc));
        CHECK(*half.zc == doctest::Approx(*s.b - *s.zc));
        CHECK(*whole.yc == doctest::Approx(*s.yc));
    }

    TEST_CASE("A rolled channel on its side opens upwards, and what is written beside it is about the axes as it lies")
    {
        const Units units{.length = LengthUnit::cm, .force = ForceUnit::kN};
        const Profile& upn = *find_profile("UPN 200");
        Section lying{.id = "s", .profile = "UPN 200", .turned = true};
        const SectionProperties s = section_properties(lying, units);
        CHECK(s.Iz == upn.Iy);
        CHECK(s.Iy == upn.Iz);
        CHECK(*s.yc == upn.zc);
        CHECK(*s.h == upn.bf);
        CHECK(outline(lying, units)->top > -outline(lying, units)->bottom); // the web is below
        lying.Iz = 7.0;
        CHECK(section_properties(lying, units).Iz == 7.0);
        CHECK(section_properties(lying, units).Iy == upn.Iz);
    }

    TEST_CASE("The outline of every rolled profile has the table's area within 0.8 %, its fillets and tapers included")
    {
        const Units units{.length = LengthUnit::mm, .force = ForceUnit::N};
        for (const Profile& profile : profiles()) {
            CAPTURE(profile.name);
            const auto figure = outline(Section{.id = "s", .profile = std::string(profile.name)}, units);
            const double k = metres(profile.unit) * 1e3;
            CHECK(moments_of(*figure).A == doctest::Approx(profile.A * k * k).epsilon(0.008));
            CHECK(figure->height() == doctest::Approx(profile.h * k));
            CHECK(figure->width() == doctest::Approx(profile.bf * k));
        }
    }

    TEST_CASE("A section of bare numbers has no outline, nor has a shape that cannot be")
    {
        CHECK_FALSE(outline(Section{.id = "s", .A = 0.01}, {}));
        CHECK_FALSE(outline(Section{.id = "s", .profile = "IPE 301"}, {}));
        CHECK_FALSE(
            outline(Section{.id = "s", .shape = SectionShape{.kind = SectionShapeKind::Circle, .d = -1.0}}, {}));
    }

    TEST_CASE("About the principal axes an angle has the largest and the least second moment, and no product")
    {
        const SectionProperties s = shape_properties(shapes[6]);
        const PrincipalAxes axes = principal_axes(s);
        const auto about = [&](double t) {
            return s.Iz * std::pow(std::cos(t), 2) + s.Iy * std::pow(std::sin(t), 2) -
                   2.0 * s.Iyz * std::sin(t) * std::cos(t);
        };
        CHECK(about(axes.angle) == doctest::Approx(axes.I1));
        CHECK(about(axes.angle + std::numbers::pi / 2.0) == doctest::Approx(axes.I2));
        for (double t = 0.0; t < 3.2; t += 0.1) CHECK(about(t) <= axes.I1 * (1.0 + 1e-12));
        CHECK(axes.I1 * axes.I2 == doctest::Approx(s.Iz * s.Iy - s.Iyz * s.Iyz));
        CHECK(axes.angle > 0.0); // the material lies along a falling line, so the stiff axis rises
    }

    TEST_CASE(
        "A symmetric section's principal axes are its own; a standing one is stiff about z', a lying one about y'")
    {
        CHECK(principal_axes(shape_properties(shapes[0])).angle == 0.0);
        const SectionShape lying{.kind = SectionShapeKind::Rectangle, .b = 0.5, .h = 0.2};
        CHECK(std::abs(principal_axes(shape_properties(lying)).angle) == doctest::Approx(std::numbers::pi / 2.0));
        CHECK(principal_axes(shape_properties(shapes[1])).angle == 0.0);
    }
}
