#include <doctest/doctest.h>

#include "ui/text/shortened.h"

TEST_SUITE_BEGIN("ui text");

TEST_CASE("A text with too many letters is cut between letters, and ends with dots; one that fits is left alone")
{
    CHECK(ui::shortened("viga", 4) == "viga");
    CHECK(ui::shortened("vigas", 4) == "vig…");
    CHECK(ui::shortened("pórtico", 3) == "pó…");
    CHECK(ui::shortened("", 1).empty());
}

TEST_SUITE_END();
