#include "femoop/tabular/separated.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using tabular::Cell;
using tabular::read_separated;
using tabular::separated;
using tabular::Table;

TEST_SUITE_BEGIN("tabular");

namespace {

const std::vector<std::string> odd_names{
    "=1+1", "+1",  "-M",         "@sum",         "'=1",        "''-x",         "'",          "''",         "'plain",
    "a,b",  "a;b", "say \"hi\"", "\"",           "two\nlines", "two\r\nlines", "\tindented", "\rreturned", "N'=1",
    " =1",  "",    "−1",         "=\"a\",\"b\"", "ação",
};

std::string written(const Cell& cell)
{
    Table table({"x"});
    table.add_row({cell});
    return separated(table).substr(std::string("x\n").size());
}

} // namespace

TEST_CASE("Every text comes back from separated values as it was, whatever stands between the cells")
{
    Table table({"name", "number"});
    for (const std::string& name : odd_names) table.add_row({name, 0.1});
    for (const tabular::Separators& separators : {tabular::Separators{}, {';', "\r\n"}, tabular::tabs}) {
        const tabular::TextBlock block = read_separated(separated(table, separators), separators.cell);
        REQUIRE(block.size() == odd_names.size() + 1);
        for (std::size_t i = 0; i < odd_names.size(); ++i) {
            CAPTURE(odd_names[i]);
            CHECK(block[i + 1] == std::vector<std::string>{odd_names[i], "0.1"});
        }
    }
}

TEST_CASE("No words begin with a sign that a spreadsheet calculates")
{
    for (const std::string& name : odd_names) {
        std::string cell = written(name);
        if (cell.starts_with('"')) cell.erase(0, 1);
        CAPTURE(name);
        CHECK(std::string("=+-@\t\r").find(cell[0]) == std::string::npos);
    }
    CHECK(written("=1+1") == "'=1+1\n");
    CHECK(written("'=1+1") == "''=1+1\n");
    CHECK(written("'plain") == "'plain\n");
    CHECK(written("=a,b") == "\"'=a,b\"\n");
}

TEST_CASE("A number is never taken for a formula, and has every digit unless it brings its own")
{
    CHECK(written(-0.1) == "-0.1\n");
    CHECK(written(1.0 / 3.0) == "0.3333333333333333\n");
    CHECK(written(-0.0) == "0\n");
    CHECK(written({-64.0, "−64.00", "-64.00"}) == "-64.00\n");
    CHECK(written({-64.0, "−64"}) == "-64\n");
    CHECK(written(std::size_t{7}) == "7\n");
}

TEST_CASE("A number as people write it is read with a hyphen, and a calculation stays words")
{
    using tabular::written_cell;
    CHECK(written(written_cell("−64,50")) == "\"-64,50\"\n");
    CHECK(written_cell("−64,50").number == -64.5);
    CHECK(written(written_cell("1.2e−5")) == "1.2e-5\n");
    CHECK(written(written_cell("−8/17")) == "'-8/17\n");
    CHECK(written(written_cell("−19.3 kN")) == "'-19.3 kN\n");
    CHECK_FALSE(written_cell("nan").is_number());
    CHECK(written(written_cell("")) == "\n");
}

TEST_CASE("A cell stands in quotation marks only where it must")
{
    CHECK(written("a b") == "a b\n");
    CHECK(written("a;b") == "a;b\n");
    CHECK(written("a,b") == "\"a,b\"\n");
    CHECK(written("a\rb") == "\"a\rb\"\n");
    CHECK(written("\"") == "\"\"\"\"\n");
}

TEST_CASE("What a spreadsheet copies is read: a lone quotation mark is a letter, an apostrophe too")
{
    CHECK(read_separated("a\t12\" pipe\n\"b\n", '\t') == tabular::TextBlock{{"a", "12\" pipe"}, {"\"b"}});
    CHECK(read_separated("=1\t'=1\t'a", '\t') == tabular::TextBlock{{"=1", "=1", "'a"}});
}

TEST_SUITE_END();
