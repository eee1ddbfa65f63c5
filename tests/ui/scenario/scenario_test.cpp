#include <doctest/doctest.h>

#include "ui/scenario/player.h"
#include "ui/scenario/script.h"

namespace {

// Understands one place and writes down what it is asked.
struct Recorder final : ui::Stage {
    std::vector<std::string> asked;

    Located find(std::string_view place) override
    {
        if (place == "node A") return ui::PointerPlace{100.0, 40.0};
        if (place == "node B") return ui::PointerPlace{340.0, 88.0};
        return "a node: A, B";
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

std::string mismatch(const char* script)
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

    TEST_CASE("A right click is one of the right button alone")
    {
        Recorder stage;
        const auto frames = played("rightclick node A", stage);
        REQUIRE(frames.size() == 6);
        CHECK(frames[2].is_right_down);
        CHECK_FALSE(frames[2].is_left_down);
        CHECK_FALSE(frames[4].is_right_down);
    }

    TEST_CASE("A drag holds the button from its first place to its last")
    {
        Recorder stage;
        const auto frames = played("drag node A to node B", stage);
        CHECK(frames.front().pointer == ui::PointerPlace{100.0, 40.0});
        CHECK(frames.back().pointer == ui::PointerPlace{340.0, 88.0});
        CHECK_FALSE(frames.back().is_left_down);
        const auto& middle = frames[4 + 5]; // half way through the twelve moves
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

    TEST_CASE("Keys are held while the mouse works, and only then")
    {
        Recorder stage;
        const auto frames = played("Ctrl+Shift+click node A\nhover node B\nAlt+drag node A to node B", stage);
        for (std::size_t i = 0; i < 6; ++i) CHECK(frames[i].held == ui::ctrl_shift);
        for (std::size_t i = 6; i < 8; ++i) CHECK(frames[i].held == ui::no_modifiers);
        CHECK(frames.back().held == ui::Modifiers{.alt = true});
    }

    TEST_CASE("A button that is pressed is held over other steps until it is released")
    {
        Recorder stage;
        const auto frames = played("press node A\nhover node B\nkey Esc\nrelease\nhover node A", stage);
        REQUIRE(frames.size() == 4 + 12 + 2 + 2 + 2);
        CHECK(frames[3].is_left_down);
        CHECK(frames[4 + 5].pointer.x == doctest::Approx(220.0)); // half way
        CHECK(frames[4 + 12 + 1].is_left_down);
        CHECK_FALSE(frames[4 + 12 + 2].is_left_down);
        CHECK(frames[4 + 12 + 2].pointer == ui::PointerPlace{340.0, 88.0});
    }

    TEST_CASE("What is wrong is told with its line, what was found and what is wanted")
    {
        CHECK(mismatch("click node A\nclick node K") == "line 2: found \"node K\", wanted a node: A, B");
        CHECK(mismatch("expect redo") == "line 1: found something else");
        CHECK(mismatch("\nkey Hyper+Q") ==
              "line 2: key: found \"Hyper+Q\", wanted a key, such as M, Ctrl+Shift+Z, F5 or Esc");
        CHECK(mismatch("click") ==
              "line 1: click: found nothing, wanted a place, such as node B, member AB 50%, (2, 0) or pixel 400 300");
        CHECK(mismatch("drag node A") ==
              "line 1: drag: found \"node A\", wanted a place, \"to\" and a place: node B to (2, 1)");
        CHECK(mismatch("wheel node A fast") == "line 1: wheel: found \"fast\", wanted a number of turns");
        CHECK(mismatch("release node A") ==
              "line 1: release: found \"node A\", wanted no place; hover moves the pointer");
        CHECK(mismatch("wait -1") == "line 1: wait: found \"-1\", wanted between 0 and 600 seconds");
        CHECK(mismatch("type 4") == "line 1: type: found \"4\", wanted a text in quotes: \"4<30\"");
        CHECK(mismatch("Hyper+click node A") ==
              "line 1: click: found \"Hyper\", wanted Ctrl, Shift or Alt before a step of the mouse");
        CHECK(mismatch("Shift+key A") ==
              "line 1: key: found \"Shift+key\", wanted a step of the mouse after a key that is held");
        CHECK(mismatch("jump") ==
              "line 1: found \"jump\", wanted a step: click, "
              "rightclick, hover, drag, press, release, wheel, key, type, command, wait, picture or expect");
    }
}
