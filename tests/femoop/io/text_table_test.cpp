#include <doctest/doctest.h>

#include <stdexcept>

#include "femoop/io/results/text_table.h"

using femoop::TextTable;

TEST_SUITE_BEGIN("io");

TEST_CASE("Numbers of a column share their decimals, six significant digits of the largest, and stand on their points")
{
    TextTable table({"node", "uy [m]"});
    table.add_row({"A", 0.0});
    table.add_row({"B", -12.3456789});
    table.add_row({"C", 7.5});
    CHECK(table.text() == "node    uy [m]\n"
                          "A       0\n"
                          "B     -12.3457\n"
                          "C       7.5000\n");
}

TEST_CASE("Counts are written whole and stand to the right")
{
    TextTable table({"order", "entries"});
    table.add_row({"natural", std::size_t{1234567890123}});
    table.add_row({"other", std::size_t{0}});
    CHECK(table.text() == "order          entries\n"
                          "natural  1234567890123\n"
                          "other                0\n");
}

TEST_CASE("Six digits are six, whatever the power of ten, and a number that rounds up to one counts as it")
{
    const auto written = [](double value) {
        TextTable table({""});
        table.add_row({value});
        const std::string text = table.text();
        return text.substr(text.find_first_not_of(" \n"));
    };
    CHECK(written(37035.0) == "37035.0\n");
    CHECK(written(1234.5678) == "1234.57\n");
    CHECK(written(0.9999999999999996) == "1.00000\n");
    CHECK(written(123456.789) == "123457\n");
}

TEST_CASE("Numbers of two kinds in one column have six digits each")
{
    TextTable table({"", "largest"});
    table.add_row({"N [kN]", 0.45}, 1);
    table.add_row({"M [kN*mm]", -120000.0}, 2);
    table.add_row({"N [kN]", 0.0}, 1);
    CHECK(table.text() == "                  largest\n"
                          "N [kN]           0.450000\n"
                          "M [kN*mm]  -120000\n"
                          "N [kN]           0\n");
}

TEST_CASE("Round-off beside large numbers reads 0, without a sign")
{
    TextTable table({"N"});
    table.add_row({-1.0e-13});
    table.add_row({4711.25});
    CHECK(table.text() == "      N\n   0\n4711.25\n");
}

TEST_CASE("A column of very small numbers is written with powers of ten")
{
    TextTable table({"rz"});
    table.add_row({-4.27e-7});
    table.add_row({0.0});
    CHECK(table.text() == "          rz\n-4.27000e-07\n 0\n");
}

TEST_CASE("Accented letters count as one place, and no line ends in blanks")
{
    TextTable table({"nó", "apoio"});
    table.add_row({"é", "pino"});
    table.add_row({"longo", ""});
    CHECK(table.text(2) == "  nó     apoio\n  é      pino\n  longo\n");
}

TEST_CASE("A row with a cell too few is refused")
{
    TextTable table({"a", "b"});
    CHECK_THROWS_AS(table.add_row({"x"}), std::invalid_argument);
}

TEST_SUITE_END();
