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

TEST_CASE("A text with too many lines ends with the number of the rest; one that fits is left alone")
{
    const ui::Catalogue english;
    CHECK(ui::first_lines("one\ntwo\nthree", 3, english) == "one\ntwo\nthree");
    CHECK(ui::first_lines("one\ntwo\nthree\nfour", 2, english) == "one\ntwo\n… and 2 more");
    CHECK(ui::first_lines("", 1, english).empty());
}

TEST_SUITE_END();
