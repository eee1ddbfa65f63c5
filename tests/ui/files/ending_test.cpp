#include <doctest/doctest.h>

#include <array>
#include <string>

#include "ui/files/ending.h"
#include "ui/text/catalogue.h"

TEST_SUITE("ui files")
{
    TEST_CASE("A name has an ending in letters of either case, and what is wanted is named where it has none")
    {
        const std::array<std::string, 3> endings{".png", ".report.pdf", ".svg"};
        CHECK(ui::has_ending("/a/Beam.PNG", ".png"));
        CHECK_FALSE(ui::why_not_ending("beam.Report.PDF", endings));
        const auto reason = ui::why_not_ending("/tmp/beam.doc", endings);
        REQUIRE(reason);
        CHECK(ui::Catalogue()(*reason) ==
              "beam.doc was not written: its name must end in one of .png, .report.pdf, .svg");
        CHECK(ui::why_not_ending("beam.pdf", endings)); // no report
    }
}
