#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "ui/text/number_format.h"

TEST_SUITE("ui text")
{
    TEST_CASE("A picture writes true minus signs, also in the exponent, and they can be typed again")
    {
        CHECK(ui::with_minus_signs(ui::number_text(-12.5)) == "−12.5");
        CHECK(ui::with_minus_signs(ui::number_text(-1.2e-5)) == "−1.2e−5");
        CHECK(ui::number_typed("−12,5") == -12.5);
        CHECK(ui::number_typed("3 − 5") == -2.0);
    }

    TEST_CASE("A number is rounded to its significant digits and loses its trailing zeros")
    {
        CHECK(ui::number_text(12.3456) == "12.35");
        CHECK(ui::number_text(40.0) == "40");
        CHECK(ui::number_text(-0.00320) == "-0.0032");
        CHECK(ui::number_text(999.96) == "1000");
        CHECK(ui::number_text(205000.0) == "205000");
        CHECK(ui::number_text(1234567.0, {.digits = 3}) == "1230000");
        CHECK(ui::number_text(0.1 + 0.2, {.digits = 15}) == "0.3");
    }

    TEST_CASE("Half of the last digit is rounded away from zero, whichever way a calculation missed it")
    {
        for (const double value : {63.28125, std::nextafter(63.28125, 0.0), std::nextafter(63.28125, 100.0)}) {
            CHECK(ui::number_text(value, {.digits = 6}) == "63.2813");
            CHECK(ui::number_text(-value, {.digits = 6}) == "-63.2813");
        }
        CHECK(ui::number_text(0.1, {.digits = 15}) == "0.1"); // what is edited keeps its digits
    }

    TEST_CASE("Very small and very large numbers are written with a power of ten")
    {
        CHECK(ui::number_text(1.2e-5) == "1.2e-5");
        CHECK(ui::number_text(-2.05e11) == "-2.05e11");
        CHECK(ui::number_text(9.99999e6) == "1e7");
        CHECK(ui::number_text(3.0e-100) == "3e-100");
    }

    TEST_CASE("Zero has no sign and what is not finite is a dash")
    {
        CHECK(ui::number_text(-0.0) == "0");
        CHECK(ui::number_text(std::nan("")) == "–");
        CHECK(ui::number_text(std::numeric_limits<double>::infinity()) == "–");
    }

    TEST_CASE("With a decimal comma the mark alone changes")
    {
        CHECK(ui::number_text(-1234.5, {.digits = 5, .mark = ui::DecimalMark::Comma}) == "-1234,5");
        CHECK(ui::number_text(1.25e-7, {.digits = 5, .mark = ui::DecimalMark::Comma}) == "1,25e-7");
    }

    TEST_CASE("A typed number may have a decimal point or a decimal comma, and nothing after it")
    {
        CHECK(ui::number_typed(" 12,5 ") == 12.5);
        CHECK(ui::number_typed("+.5e1") == 5.0);
        CHECK_FALSE(ui::number_typed("1.234,5"));
        CHECK_FALSE(ui::number_typed("12 kN"));
        CHECK_FALSE(ui::number_typed("+-1"));
        CHECK_FALSE(ui::number_typed("inf"));
        CHECK_FALSE(ui::number_typed("1e999"));
        CHECK_FALSE(ui::number_typed(""));
    }
}
