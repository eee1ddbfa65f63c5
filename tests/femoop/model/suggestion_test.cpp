#include <doctest/doctest.h>

#include "femoop/model/check/suggestion.h"

using femoop::nearest;

TEST_SUITE_BEGIN("model");

TEST_CASE("Of names that are one slip away the one as long as what was typed is meant")
{
    CHECK(nearest("W12X27", {"W12X279", "W12X26"}) == "W12X26");
    CHECK(nearest("suport", {"title", "support"}) == "support");
    CHECK(nearest("nodse", {"nodes", "notes"}) == "nodes"); // a swap is one slip
    CHECK(!nearest("q", {"fx", "fy"}));
}

TEST_SUITE_END();
