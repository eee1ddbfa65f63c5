// How the picture gives way where there is little room.
#include "apps/drawing/geometry/level_of_detail.h"
#include "apps/drawing/sketch/caption_crowd.h"

#include <doctest/doctest.h>

using namespace drawing;

TEST_SUITE_BEGIN("frame");

namespace {

MemberShape member(double from, double to)
{
    MemberShape shape;
    shape.start = {from, 0.0, 0.0};
    shape.end = {to, 0.0, 0.0};
    return shape;
}

/// Members of 2, 3 and 7 m.
StructureShape three_members()
{
    StructureShape shape;
    shape.members = {member(0.0, 2.0), member(2.0, 9.0), member(9.0, 12.0)};
    return shape;
}

LevelOfDetail at_scale(double scale) { return {three_members(), Projection(ui::PlaneCamera({}, scale))}; }

} // namespace

TEST_CASE("How crowded a picture is goes by the member in the middle, as long as it is seen")
{
    CHECK(at_scale(20.0).median_length() == doctest::Approx(60.0));
    CHECK(at_scale(4.0).median_length() == doctest::Approx(12.0));
    CHECK(LevelOfDetail({}, Projection(ui::PlaneCamera())).median_length() == 0.0);
}

TEST_CASE("Where captions crowd the lesser ones are left out, and the others as soon as they crowd themselves")
{
    CaptionCrowd crowd({{0.0, 0.0}, {480.0, 480.0}});
    const ui::Point here{100.0, 100.0}, far{300.0, 100.0}, beside_the_sheet{-500.0, 900.0};
    for (int i = 0; i < 6; ++i) {
        CHECK(!crowd.is_full(here, Rank::Name));
        crowd.add(here, Rank::Value);
    }
    CHECK(crowd.is_full(here, Rank::Name));
    CHECK(crowd.is_full(here, Rank::Value));
    CHECK(!crowd.is_full(here, Rank::Extreme));
    CHECK(!crowd.is_full(far, Rank::Name));
    CHECK(!crowd.is_full(beside_the_sheet, Rank::Name));
    for (int i = 0; i < 6; ++i) crowd.add(here, Rank::Largest);
    CHECK(crowd.is_full(here, Rank::Load));
}

TEST_CASE("Symbols keep their size while there is room, shrink with the members, and never below a half")
{
    CHECK(at_scale(20.0).symbol_share() == 1.0);
    CHECK(!at_scale(20.0).is_reduced());
    CHECK(at_scale(9.0).symbol_share() == doctest::Approx(0.75)); // 27 of 36 px
    CHECK(at_scale(9.0).is_reduced());
    CHECK(at_scale(0.1).symbol_share() == 0.5);
    CHECK(LevelOfDetail({}, Projection(ui::PlaneCamera())).symbol_share() == 1.0);
}

TEST_SUITE_END();
