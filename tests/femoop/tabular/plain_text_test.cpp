#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "femoop/tabular/plain_text.h"

using tabular::plain_text;
using tabular::Table;

TEST_SUITE_BEGIN("tabular");

TEST_CASE("Numbers of a column share their decimals, six significant digits of the largest, and stand on their points")
{
    Table table({"node", "uy [m]"});
    table.add_row({"A", 0.0});
    table.add_row({"B", -12.3456789});
    table.add_row({"C", 7.5});
    CHECK(plain_text(table) == "node    uy [m]\n"
                               "A       0\n"
                               "B     -12.3457\n"
                               "C       7.5000\n");
}

TEST_CASE("Equal forces that a calculation left a bit apart at half of the last digit read alike")
{
    Table table({"bar", "N"});
    table.add_row({"a", -63.28125});
    table.add_row({"b", std::nextafter(-63.28125, -100.0)});
    table.add_row({"c", std::nextafter(-63.28125, 0.0)});
    CHECK(plain_text(table) == "bar         N\n"
                               "a    -63.2813\n"
                               "b    -63.2813\n"
                               "c    -63.2813\n");
}

TEST_CASE("Counts are written whole and stand to the right")
{
    Table table({"order", "entries"});
    table.add_row({"natural", std::size_t{1234567890}});
    table.add_row({"other", std::size_t{0}});
    CHECK(plain_text(table) == "order       entries\n"
                               "natural  1234567890\n"
                               "other             0\n");
}

TEST_CASE("Six digits are six, whatever the power of ten, and a number that rounds up to one counts as it")
{
    const auto written = [](double value) {
        Table table({""});
        table.add_row({value});
        const std::string text = plain_text(table);
        return text.substr(text.find_first_not_of(" \n"));
    };
    CHECK(written(37035.0) == "37035.0\n");
    CHECK(written(1234.5678) == "1234.57\n");
    CHECK(written(0.9999999999999996) == "1.00000\n");
    CHECK(written(123456.789) == "123457\n");
}

TEST_CASE("Numbers of two kinds in one column have six digits each")
{
    Table table({"", "largest"});
    table.add_row({"N [kN]", 0.45}, 1);
    table.add_row({"M [kN*mm]", -120000.0}, 2);
    table.add_row({"N [kN]", 0.0}, 1);
    CHECK(plain_text(table) == "                  largest\n"
                               "N [kN]           0.450000\n"
                               "M [kN*mm]  -120000\n"
                               "N [kN]           0\n");
}

TEST_CASE("Round-off beside large numbers reads 0, without a sign")
{
    Table table({"N"});
    table.add_row({-1.0e-13});
    table.add_row({4711.25});
    CHECK(plain_text(table) == "      N\n   0\n4711.25\n");
}

TEST_CASE("A column of very small numbers is written with powers of ten")
{
    Table table({"rz"});
    table.add_row({-4.27e-7});
    table.add_row({0.0});
    CHECK(plain_text(table) == "          rz\n-4.27000e-07\n 0\n");
}

TEST_CASE("Accented letters count as one place, and no line ends in blanks")
{
    Table table({"nó", "apoio"});
    table.add_row({"é", "pino"});
    table.add_row({"longo", ""});
    CHECK(plain_text(table, {.indent = 2}) == "  nó     apoio\n  é      pino\n  longo\n");
}

TEST_CASE("A row with a cell too few is refused")
{
    Table table({"a", "b"});
    CHECK_THROWS_AS(table.add_row({"x"}), std::invalid_argument);
}

TEST_CASE("A number that is written already stands on its decimal mark among the others")
{
    Table table({"member end", {"M", "kN*m"}});
    table.add_row({"AB", {-64.0, "−64,00"}});
    table.add_row({"BA", {114.5, "114,5"}});
    table.add_row({"sum", ""});
    CHECK(plain_text(table, {.decimal_mark = ','}) == "member end  M [kN*m]\n"
                                                      "AB            −64,00\n"
                                                      "BA            114,5\n"
                                                      "sum\n");
}

TEST_SUITE_END();
