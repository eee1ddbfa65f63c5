#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "ui/app/app_options.h"

namespace {

struct Ended {
    int status = 0;
    std::string words;
};

/// How the command line of an app ends before it begins; 0 where it does not.
Ended ended(std::vector<const char*> arguments)
{
    arguments.insert(arguments.begin(), "mohr");
    ui::AppOptions options;
    try {
        ui::parse_one_file({.name = "mohr", .version = "1", .purpose = "Shows.", .options = {"file", "describe"}},
                           options, static_cast<int>(arguments.size()), arguments.data());
    } catch (const ui::OptionsEnd& end) {
        return {end.status, end.what()};
    }
    return {};
}

} // namespace

TEST_SUITE("ui app")
{
    TEST_CASE("A scale that is no number, or none from 0.5 to 4, is refused with what is wanted")
    {
        CHECK(ended({"--scale", "2"}).status == 0);
        for (const std::string scale : {"nan", "inf", "-1", "0", "0.49", "4.01", "two", "1e400"}) {
            CAPTURE(scale);
            const Ended end = ended({"--scale", scale.c_str()});
            CHECK(end.status == 2);
            CHECK(end.words == "mohr: --scale: found \"" + scale + "\", wanted a number from 0.5 to 4");
        }
    }

    TEST_CASE("A picture without a name, or of another kind than PNG, opens no window")
    {
        CHECK(ended({"--screenshot", "a.png"}).status == 0);
        CHECK(ended({"--screenshot", ""}).status == 2);
        CHECK(ended({"--screenshot", "a.svg"}).words ==
              "mohr: --screenshot: found \"a.svg\", wanted a name that ends with .png");
    }

    TEST_CASE("A size beyond what a window can have is refused")
    {
        for (const std::string size : {"nanx800", "1280xinf", "199x800", "1280", "x", "16385x800"}) {
            CAPTURE(size);
            CHECK(ended({"--size", size.c_str()}).status == 2);
        }
    }

    TEST_CASE("Who asks for the projector begins without panels, whatever was left")
    {
        ui::AppOptions asked{.settings = {.theme = ui::ThemeName::Projector}};
        ui::complete(asked, std::nullopt);
        CHECK(*asked.settings.has_panels == false);
        ui::AppOptions other{.settings = {.theme = ui::ThemeName::Dark}};
        ui::complete(other, std::nullopt);
        CHECK(*other.settings.has_panels == true);
    }
}
