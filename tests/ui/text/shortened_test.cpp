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

TEST_CASE("A text is shortened until it fits, but not to less than was asked")
{
    const auto of_bytes = [](std::size_t n) { return [n](const std::string& text) { return text.size() <= n; }; };
    CHECK(ui::shortened_to_fit("not solved", 3, of_bytes(10)) == "not solved");
    CHECK(ui::shortened_to_fit("not solved", 3, of_bytes(9)) == "not so…");
    CHECK(ui::shortened_to_fit("not solved", 3, of_bytes(5)) == "no…");
    CHECK(ui::shortened_to_fit("not solved", 3, of_bytes(4)).empty());
    CHECK(ui::shortened_to_fit("", 3, of_bytes(0)).empty());
}

TEST_CASE("A text with too many lines ends with the number of the rest; one that fits is left alone")
{
    const ui::Catalogue english;
    CHECK(ui::first_lines("one\ntwo\nthree", 3, english) == "one\ntwo\nthree");
    CHECK(ui::first_lines("one\ntwo\nthree\nfour", 2, english) == "one\ntwo\n… and 2 more");
    CHECK(ui::first_lines("", 1, english).empty());
}

TEST_SUITE_END();
