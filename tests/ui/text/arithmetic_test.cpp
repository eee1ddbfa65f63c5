#include <doctest/doctest.h>

#include <string>

#include "ui/text/arithmetic.h"
#include "ui/text/number_format.h"

namespace {

double value(const char* text)
{
    CAPTURE(std::string(text));
    const auto number = ui::number_typed(text);
    REQUIRE(number);
    return *number;
}

} // namespace

TEST_SUITE("ui text")
{
    TEST_CASE("A calculation is typed where a number is wanted")
    {
        CHECK(value("2*3.5") == 7.0);
        CHECK(value("1/3") == 1.0 / 3.0);
        CHECK(value("12,5 + 1") == 13.5);
        CHECK(value("2+3*4") == 14.0);
        CHECK(value("(2+3)*4") == 20.0);
        CHECK(value("10-4-3") == 3.0);
        CHECK(value("24/4/2") == 3.0);
        CHECK(value("-2^2") == -4.0);
        CHECK(value("2^3^2") == 512.0);
        CHECK(value("2*-3") == -6.0);
        CHECK(value("5*6^2/8") == 22.5);
    }

    TEST_CASE("A calculation ends where the unit begins")
    {
        const auto number = ui::leading_number("2*3.5 kN/m");
        REQUIRE(number);
        CHECK(number->value == 7.0);
        CHECK(number->is_computed);
        CHECK(std::string("2*3.5 kN/m").substr(number->length) == " kN/m");
        CHECK(ui::leading_number("25 kN/m")->length == 2);
        CHECK(ui::leading_number("1.2e-5 1/K")->value == 1.2e-5);
        CHECK(ui::leading_number("3/m")->length == 1);
        CHECK_FALSE(ui::leading_number("3/m")->is_computed);
    }

    TEST_CASE("What cannot be calculated is no number")
    {
        for (const char* text :
             {"1/0", "2*", "*2", "(2", "2)", "()", "2 3", "1,5+2.5", "--1", "9^999", "(-1)^0.5", "2**3", "e5"}) {
            CAPTURE(std::string(text));
            CHECK_FALSE(ui::number_typed(text));
        }
    }

    TEST_CASE("Parentheses without end are refused, not followed")
    {
        CHECK_FALSE(ui::number_typed(std::string(900, '(') + "1"));
        CHECK_FALSE(ui::number_typed(std::string(1'000'000, '(')));
        std::string powers = "1";
        for (int i = 0; i < 300; ++i) powers += "^1";
        CHECK_FALSE(ui::number_typed(powers));
    }
}
