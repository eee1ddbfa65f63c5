// One solution beside others: envelopes, and a former solution behind the present one.
#include "femoop/result/envelope.h"
#include "tests/apps/frame_window/played.h"

#include <doctest/doctest.h>

using namespace frame;

TEST_SUITE("frame window")
{
    TEST_CASE("The envelope of all cases is a band, with the extremes of each member")
    {
        check_window("window_envelope", opened("examples/portal.json"), R"(
            key E
            hover pixel 20 780
        )");
    }

    TEST_CASE("A solution that is kept stands behind the one that follows the hand")
    {
        check_window("window_compared", opened("examples/portal.json"), R"(
            key G
            drag node C to (8, 6)
            hover pixel 20 780
            expect undo Move: Node C
        )");
    }
}
