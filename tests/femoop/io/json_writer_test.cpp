#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "femoop/io/json/json_writer.h"

using femoop::JsonWriter;

TEST_SUITE_BEGIN("io");

TEST_CASE("A number is written with the fewest digits that read back as the same double")
{
    for (const double number : {0.1, 1.0 / 3.0, 6.02214076e23, -2.5e-300, 5.0e-324, 12345678.9}) {
        CAPTURE(number);
        JsonWriter json;
        json.value(number);
        CHECK(std::strtod(json.take().c_str(), nullptr) == number);
    }
    JsonWriter json;
    json.begin_array().value(0.1).value(25.0).end();
    CHECK(json.take() == "[0.1, 25]\n");
}

TEST_CASE("Minus zero is written 0")
{
    JsonWriter json;
    json.value(-0.0);
    CHECK(json.take() == "0\n");
}

TEST_CASE("What is not finite is refused with the key that it stands under")
{
    JsonWriter json;
    json.begin_object().key("residual");
    CHECK_THROWS_WITH_AS(json.value(std::numeric_limits<double>::quiet_NaN()), "\"residual\" is not a finite number",
                         std::domain_error);
}

TEST_CASE("A block has a member a line, a line has all of them")
{
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::Block).member("cremona", 1);
    json.key("units").begin_object().member("length", "m").member("force", "kN").end();
    json.key("cases").begin_object(JsonWriter::Layout::Block).end().end();
    CHECK(json.take() ==
          "{\n  \"cremona\": 1,\n  \"units\": {\"length\": \"m\", \"force\": \"kN\"},\n  \"cases\": {}\n}\n");
}

TEST_CASE("Quotation marks, backslashes and control characters in names are escaped")
{
    JsonWriter json;
    json.value("a\"b\\c\nd\x01");
    CHECK(json.take() == "\"a\\\"b\\\\c\\nd\\u0001\"\n");
}

TEST_CASE("A text with an open object is not handed out")
{
    JsonWriter json;
    json.begin_object();
    CHECK_THROWS_AS(json.take(), std::logic_error);
}

TEST_SUITE_END();
