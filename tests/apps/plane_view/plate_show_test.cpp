// What the words of --show mean for plane models.
#include <doctest/doctest.h>

#include "apps/plane/view/plate_show.h"

using namespace plane;
using femoop::plane::PlaneComponent;

TEST_CASE("Every word shows something, and no other word is understood")
{
    for (const std::string& word : all_plate_words()) {
        CAPTURE(word);
        CHECK(plate_shown(word).has_value());
    }
    for (const char* const word : {"", "moments", "bands", "bands:", "bands:fx", "contour:N", "bands:sr"})
        CHECK(!plate_shown(word));
}

TEST_CASE("Bands and lines stand beside each other; of two of one style the last one asked for is shown")
{
    const PlateShown all = *plate_shown("bands:sx") | *plate_shown("contour:s1") | *plate_shown("Bands:Mises");
    REQUIRE(all.fields.size() == 2);
    CHECK(all.fields[0] == FieldShow{PlaneComponent::Mises, FieldStyle::Bands});
    CHECK(all.fields[1] == FieldShow{PlaneComponent::s1, FieldStyle::Contours});
}

TEST_CASE("Geometry needs no mesh, a mesh no results, and stresses need both")
{
    CHECK(!plate_shown_by_default().needs_mesh());
    CHECK(plate_shown("mesh")->needs_mesh());
    CHECK(!plate_shown("mesh")->needs_results());
    for (const char* const word : {"deformed", "principal", "trajectories", "error", "bands:ux"}) {
        CHECK(plate_shown(word)->needs_results());
        CHECK(plate_shown(word)->needs_mesh());
    }
}
