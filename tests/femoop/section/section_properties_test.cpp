#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "femoop/section/profile.h"
#include "femoop/section/section_properties.h"

using namespace femoop;
using doctest::Approx;

namespace {

constexpr Units metre{.length = LengthUnit::m, .force = ForceUnit::kN};

Section profile_section(const char* profile)
{
    Section section;
    section.profile = profile;
    return section;
}

Section tee_section()
{
    Section section;
    section.shape = SectionShape{
        .kind = SectionShapeKind::T, .b = {}, .h = 0.37, .d = {}, .t = {}, .bf = 0.19, .tf = 0.031, .tw = 0.017};
    return section;
}

} // namespace

TEST_CASE("Properties that are given are taken as they are")
{
    Section section;
    section.A = 0.012;
    section.Iy = 1e-4;
    section.Iz = 2e-4;
    section.J = 2e-5;
    section.Asy = 0.005;
    section.Asz = 0.004;
    section.h = 0.3;
    section.yc = 0.12;
    const SectionProperties s = section_properties(section, metre);
    CHECK(s.A == 0.012);
    CHECK(s.Iy == 1e-4);
    CHECK(s.Iz == 2e-4);
    CHECK(s.J == 2e-5);
    CHECK(s.Asy == 0.005);
    CHECK(s.Asz == 0.004);
    CHECK(s.h == 0.3);
    CHECK(s.yc == 0.12);
    CHECK(s.Wz.value() == Approx(2e-4 / 0.18));
    CHECK_FALSE(s.Wy.has_value());
}

TEST_CASE("The centroid stands at mid-depth unless something else is known")
{
    Section section;
    section.h = 0.3;
    CHECK(section_properties(section, metre).yc == 0.15);
    section.h.reset();
    CHECK_FALSE(section_properties(section, metre).yc.has_value());
    CHECK_FALSE(section_properties(section, metre).Asy.has_value());
}

TEST_CASE("A property beside a shape overrides it and leaves the others")
{
    const SectionProperties plain = section_properties(tee_section(), metre);
    Section section = tee_section();
    section.A = 0.02;
    section.Iy = 3e-5;
    section.Asz = 0.001;
    const SectionProperties s = section_properties(section, metre);
    CHECK(s.A == 0.02);
    CHECK(s.Iy == 3e-5);
    CHECK(s.Asz == 0.001);
    CHECK(s.Asy == plain.Asy);
    CHECK(s.Iz == plain.Iz);
    CHECK(s.J == plain.J);
    CHECK(s.Wz == plain.Wz);
    CHECK_FALSE(s.Wy.has_value()); // it belonged to the shape's Iy
}

TEST_CASE("An overridden Iz takes its modulus with it: Wz = Iz / max(yc, h - yc)")
{
    Section section = tee_section();
    section.Iz = 2.2e-4;
    const SectionProperties s = section_properties(section, metre);
    REQUIRE(*s.yc > 0.37 / 2.0);
    CHECK(s.Wz.value() == Approx(2.2e-4 / *s.yc));
}

TEST_CASE("An overridden depth keeps the centroid's proportion; an overridden yc is final")
{
    const double ratio = *section_properties(tee_section(), metre).yc / 0.37;
    Section section = tee_section();
    section.h = 0.41;
    CHECK(section_properties(section, metre).yc.value() == Approx(0.41 * ratio));
    section.yc = 0.11;
    CHECK(section_properties(section, metre).yc == 0.11);
}

TEST_CASE("IPE 300 in metres: the strong axis of EN 10365 is Iz here")
{
    const SectionProperties s = section_properties(profile_section("IPE 300"), metre);
    CHECK(s.A == Approx(53.8e-4));
    CHECK(s.Iz == Approx(8356e-8));
    CHECK(s.Iy == Approx(603.8e-8));
    CHECK(s.J == Approx(20.12e-8));
    CHECK(s.Wz.value() == Approx(557.1e-6));
    CHECK(s.Wy.value() == Approx(80.50e-6));
    CHECK(s.h.value() == Approx(0.300));
    CHECK(s.yc.value() == Approx(0.150));
    CHECK(s.Asy.value() == Approx(0.300 * 0.0071));
    CHECK(s.Asz.value() == Approx(5.0 / 3.0 * 0.150 * 0.0107));
}

TEST_CASE("A profile comes in the model's unit of length, unchanged where the table has the same")
{
    const SectionProperties s = section_properties(profile_section("w12x26"), {.length = LengthUnit::in});
    CHECK(s.A == 7.65);
    CHECK(s.Iz == 204.0);
    CHECK(s.J == 0.300);
    const SectionProperties feet = section_properties(profile_section("W12X26"), {.length = LengthUnit::ft});
    CHECK(feet.Iz == Approx(204.0 / std::pow(12.0, 4)));
    CHECK(feet.Wz.value() == Approx(33.4 / std::pow(12.0, 3)));
    CHECK(feet.Asy.value() == Approx(12.2 * 0.230 / 144.0));
    CHECK(feet.yc.value() == Approx(6.1 / 12.0));
    CHECK(section_properties(profile_section("HEB200"), {.length = LengthUnit::mm}).Iz == Approx(5696e4));
}

TEST_CASE("A property beside a profile overrides it")
{
    Section section = profile_section("HEA200");
    section.J = 1e-7;
    section.Iz = 4e-5;
    const SectionProperties s = section_properties(section, metre);
    CHECK(s.J == 1e-7);
    CHECK(s.Iz == 4e-5);
    CHECK(s.Wz.value() == Approx(4e-5 / 0.095));
    CHECK(s.A == Approx(53.8e-4));
}

TEST_CASE("A profile that no table has is refused with its name")
{
    CHECK_THROWS_WITH_AS(section_properties(profile_section("IPE 310"), metre), "no profile \"IPE 310\"",
                         std::invalid_argument);
}
