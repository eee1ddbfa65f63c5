#include <doctest/doctest.h>

#include "ui/scenario/player.h"
#include "ui/scenario/script.h"

namespace {

// Understands one place and writes down what it is asked.
struct Recorder final : ui::Stage {
    std::vector<std::string> asked;

    std::optional<ui::PointerPlace> find(std::string_view place) override
    {
        if (place == "node A") return ui::PointerPlace{100.0, 40.0};
        if (place == "node B") return ui::PointerPlace{340.0, 88.0};
        return std::nullopt;
    }
    std::optional<std::string> run_command(std::string_view id, std::string_view argument) override
    {
        asked.push_back("command " + std::string(id) + "|" + std::string(argument));
        return std::nullopt;
    }
    std::optional<std::string> take_picture(std::string_view name) override
    {
        asked.push_back("picture " + std::string(name));
        return std::nullopt;
    }
    std::optional<std::string> expect(std::string_view words) override
    {
        return words == "undo" ? std::nullopt : std::optional<std::string>("found something else");
    }
};

std::vector<ui::InputFrame> played(const char* script, Recorder& stage)
{
    ui::Player player(ui::read_scenario(script));
    std::vector<ui::InputFrame> frames;
    while (const auto frame = player.next(stage)) frames.push_back(*frame);
    return frames;
}

std::string complaint(const char* script)
{
    Recorder stage;
    try {
        played(script, stage);
    } catch (const ui::ScenarioError& error) {
        return error.what();
    }
    return "nothing";
}

} // namespace

TEST_SUITE("ui scenario")
{
    TEST_CASE("A click moves, presses and releases at its place")
    {
        Recorder stage;
        const auto frames = played("# a comment\n\nclick node A\n", stage);
        REQUIRE(frames.size() == 6);
        for (const ui::InputFrame& frame : frames) CHECK(frame.pointer == ui::PointerPlace{100.0, 40.0});
        CHECK_FALSE(frames[1].is_left_down);
        CHECK(frames[2].is_left_down);
        CHECK(frames[3].is_left_down);
        CHECK_FALSE(frames[4].is_left_down);
    }

    TEST_CASE("A drag holds the button from its first place to its last")
    {
        Recorder stage;
        const auto frames = played("drag node A to node B", stage);
        CHECK(frames.front().pointer == ui::PointerPlace{100.0, 40.0});
        CHECK(frames.back().pointer == ui::PointerPlace{340.0, 88.0});
        CHECK_FALSE(frames.back().is_left_down);
        const auto middle = frames[4 + 5]; // half way through the twelve moves
        CHECK(middle.is_left_down);
        CHECK(middle.pointer.x == doctest::Approx(220.0));
        CHECK(middle.pointer.y == doctest::Approx(64.0));
    }

    TEST_CASE("Keys, texts and the wheel come once each")
    {
        Recorder stage;
        const auto frames = played("key Ctrl+Z\ntype \"4 \\\"m\\\"\"\nwheel node A -2", stage);
        int n_keys = 0, n_texts = 0;
        double turns = 0.0;
        for (const ui::InputFrame& frame : frames) {
            n_keys += frame.key == ui::Chord{ui::Key::Z, ui::ctrl} ? 1 : 0;
            n_texts += frame.text == "4 \"m\"" ? 1 : 0;
            turns += frame.wheel;
        }
        CHECK(n_keys == 1);
        CHECK(n_texts == 1);
        CHECK(turns == -2.0);
    }

    TEST_CASE("Half a second is thirty frames")
    {
        Recorder stage;
        CHECK(played("wait 0.5", stage).size() == 30);
    }

    TEST_CASE("Commands and pictures happen in their order")
    {
        Recorder stage;
        played("command view.fit\npicture first\ncommand file.open a b.json\nexpect undo\n", stage);
        CHECK(stage.asked ==
              std::vector<std::string>{"command view.fit|", "picture first", "command file.open|a b.json"});
    }

    TEST_CASE("What is wrong is named with its line")
    {
        CHECK(complaint("click node A\nclick node K") == "line 2: no place \"node K\"");
        CHECK(complaint("expect redo") == "line 1: found something else");
        CHECK(complaint("\nkey Hyper+Q") == "line 2: no key \"Hyper+Q\"");
        CHECK(complaint("click") == "line 1: click wants a place");
        CHECK(complaint("drag node A") == "line 1: drag wants a place, \"to\" and a place");
        CHECK(complaint("wheel node A fast") == "line 1: expected a number, found \"fast\"");
        CHECK(complaint("wait -1") == "line 1: wait wants between 0 and 600 seconds");
        CHECK(complaint("type 4") == "line 1: type wants a text in quotes");
        CHECK(complaint("jump") ==
              "line 1: no step \"jump\"; there are click, hover, drag, wheel, key, type, command, wait, "
              "picture and expect");
    }
}
