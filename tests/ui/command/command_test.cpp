#include <doctest/doctest.h>

#include <array>
#include <string>

#include "ui/command/command_table.h"
#include "ui/command/menu_builder.h"

namespace {

struct Lamp {
    bool is_lit = false;
    bool has_bulb = true;
    int brightness = 1;
};

ui::CommandTable<Lamp> lamp_commands()
{
    ui::CommandTable<Lamp> table;
    table.add({.id = "lamp.switch",
               .menu = "Lamp",
               .label = "Switch",
               .shortcuts = {{ui::Key::L, ui::ctrl}},
               .run = [](Lamp& lamp) { lamp.is_lit = !lamp.is_lit; },
               .why_not = [](const Lamp& lamp) -> std::optional<ui::Message> {
                   if (lamp.has_bulb) return std::nullopt;
                   return "the lamp has no bulb";
               },
               .is_on = [](const Lamp& lamp) { return lamp.is_lit; }});
    table.add({.id = "lamp.unscrew", .menu = "Lamp", .label = "Take the bulb out", .run = [](Lamp& lamp) {
                   lamp = {.is_lit = false, .has_bulb = false, .brightness = 1};
               }});
    return table;
}

std::optional<ui::Message> why_dark(const Lamp& lamp)
{
    return lamp.has_bulb ? std::nullopt : std::optional<ui::Message>("the lamp has no bulb");
}

ui::CommandTable<Lamp> built_commands()
{
    ui::CommandTable<Lamp> table;
    ui::MenuBuilder<Lamp> menu(table, "Lamp");
    menu.step({"lamp.off", "Put it out"}, [](Lamp& lamp) { lamp.is_lit = false; });
    menu.toggle(
        {"lamp.switch", "Switch", {{ui::Key::L, ui::ctrl}}}, [](auto& lamp) -> auto& { return lamp.is_lit; }, why_dark);
    constexpr std::array levels{ui::Choice<int>{1, "lamp.dim", "Dim"}, ui::Choice<int>{5, "lamp.bright", "Bright"}};
    menu.choices(
        levels, [](auto& lamp) -> auto& { return lamp.brightness; }, why_dark);
    const auto set = [](Lamp& lamp, const ui::Argument& argument) -> std::optional<ui::Message> {
        if (!argument.number()) return argument.wanted("a brightness");
        lamp.brightness = static_cast<int>(*argument.number());
        return std::nullopt;
    };
    table.with_argument("lamp.bright", set);
    table.with_argument("lamp.set", set);
    return table;
}

} // namespace

TEST_SUITE("ui command")
{
    TEST_CASE("A command is found by its id and by its shortcut, and runs")
    {
        const auto table = lamp_commands();
        Lamp lamp;
        CHECK(table.find(ui::Chord{ui::Key::L, ui::ctrl}) == table.find("lamp.switch"));
        CHECK(table.find("lamp.break") == nullptr);
        CHECK_FALSE(run(*table.find("lamp.switch"), lamp));
        CHECK(lamp.is_lit);
    }

    TEST_CASE("A toggle turns its switch and shows how it stands")
    {
        const auto table = built_commands();
        const auto& command = *table.find(ui::Chord{ui::Key::L, ui::ctrl});
        Lamp lamp;
        CHECK_FALSE(command.is_on(lamp));
        run(command, lamp);
        CHECK(lamp.is_lit);
        CHECK(command.is_on(lamp));
        run(command, lamp);
        CHECK_FALSE(lamp.is_lit);
    }

    TEST_CASE("Of choices the one that was chosen last is on, and none can be where a reason stands against it")
    {
        const auto table = built_commands();
        Lamp lamp;
        run(*table.find("lamp.bright"), lamp);
        CHECK(lamp.brightness == 5);
        CHECK(table.find("lamp.bright")->is_on(lamp));
        CHECK_FALSE(table.find("lamp.dim")->is_on(lamp));
        lamp.has_bulb = false;
        CHECK(run(*table.find("lamp.dim"), lamp) == ui::Message("the lamp has no bulb"));
        CHECK(lamp.brightness == 5);
    }

    TEST_CASE("A scenario gives an argument to a command that takes one, and is told what another does not take")
    {
        const auto table = built_commands();
        Lamp lamp;
        CHECK_FALSE(run_by_name(table, {"lamp.set", "7"}, lamp));
        CHECK(lamp.brightness == 7);
        CHECK(run_by_name(table, {"lamp.set", "much"}, lamp) == "lamp.set: found \"much\", wanted a brightness");
        CHECK(run_by_name(table, {"lamp.off", "now"}, lamp) == "lamp.off: found \"now\", wanted no argument");
        CHECK(run_by_name(table, {"lamp.break", ""}, lamp).value().starts_with("found command \"lamp.break\""));
        lamp.has_bulb = false;
        CHECK(run_by_name(table, {"lamp.bright", "3"}, lamp) == "the lamp has no bulb");
        CHECK(table.find("lamp.set") == nullptr); // of no menu and not in the palette
    }

    TEST_CASE("A command that cannot run says why and changes nothing")
    {
        const auto table = lamp_commands();
        Lamp lamp{.is_lit = false, .has_bulb = false, .brightness = 1};
        CHECK(run(*table.find("lamp.switch"), lamp) == ui::Message("the lamp has no bulb"));
        CHECK_FALSE(lamp.is_lit);
    }

    TEST_CASE("Two commands cannot share an id or a shortcut")
    {
        auto table = lamp_commands();
        CHECK_THROWS_WITH(table.add({.id = "lamp.switch", .run = [](Lamp&) {}}), "two commands named lamp.switch");
        CHECK_THROWS_WITH(table.add({.id = "lamp.light", .shortcuts = {{ui::Key::L, ui::ctrl}}, .run = [](Lamp&) {}}),
                          "two commands on Ctrl+L");
    }

    TEST_CASE("The palette finds commands by their words in the user's language, the best first")
    {
        const auto table = lamp_commands();
        const ui::Catalogue tr(ui::Language::Portuguese, {{"Switch", "Acender ou apagar", 1},
                                                          {"Take the bulb out", "Retirar a lâmpada", 3},
                                                          {"Lamp", "Luminária", 5}});
        const auto found = table.matching("lampada", {}, tr);
        REQUIRE(found.size() == 1);
        CHECK(found[0]->id == "lamp.unscrew");
        CHECK(table.matching("", {}, tr).size() == 2);
        CHECK(table.matching("apagar", {}, tr).at(0)->id == "lamp.switch");
    }

    TEST_CASE("In Portuguese the palette finds commands by their English words too")
    {
        const auto table = lamp_commands();
        const ui::Catalogue tr(ui::Language::Portuguese, {{"Take the bulb out", "Retirar a lâmpada", 3}});
        CHECK(table.matching("bulb", {}, tr).at(0)->id == "lamp.unscrew");
    }

    TEST_CASE("Of commands with the same words those that can run come first, and of these labels of fewer words")
    {
        ui::CommandTable<Lamp> table;
        const auto add = [&](std::string_view id, std::string_view label, bool can_run) {
            table.add({.id = id,
                       .menu = "Lamp",
                       .label = label,
                       .run = [](Lamp&) {},
                       .why_not =
                           [can_run](const Lamp&) {
                               return can_run ? std::nullopt : std::optional<ui::Message>("not now");
                           }});
        };
        add("refused", "Light", false);
        add("long", "Light of the hall", true);
        add("short", "Light up", true);
        std::string order;
        for (const auto* command : table.matching("light", {}, ui::Catalogue()))
            order += std::string(command->id) + ' ';
        CHECK(order == "short long refused ");
        CHECK(table.matching("", {}, ui::Catalogue()).at(1)->id == "long"); // where nothing was typed: as in the menus
    }

    TEST_CASE("The command whose own name begins with the typed words comes before those with the words elsewhere")
    {
        ui::CommandTable<Lamp> table;
        const auto add = [&](std::string_view id, std::string_view menu, std::string_view label) {
            table.add({.id = id, .menu = menu, .label = label, .run = [](Lamp&) {}});
        };
        add("to the end", "Construction", "To the end");
        add("end", "Exercises", "End the exercise");
        for (const char* typed : {"end", "end t", "end the", "exercises end"}) {
            CAPTURE(typed);
            CHECK(table.matching(typed, {}, ui::Catalogue()).at(0)->id == "end");
        }
    }

    TEST_CASE("A whole word is better than its beginning, that better than its middle, and that than scattered letters")
    {
        CHECK(ui::match_rank("moment", "Bending moment") == 2);
        CHECK(ui::match_rank("bending", "Bending moment") == 0);
        CHECK(ui::match_rank("bend", "Bending moment") == 1);
        CHECK(ui::match_rank("mom", "Bending moment") == 3);
        CHECK(ui::match_rank("omen", "Bending moment") == 4);
        CHECK(ui::match_rank("bnm", "Bending moment").value() > ui::worst_rank_of_words);
        CHECK(ui::match_rank("acao", "Reação").value() >= 3);
        CHECK(ui::match_rank("case", "New case (load cases)") == 2); // also behind a worse place
        CHECK(ui::match_rank("moment bending", "Bending moment") == 2);
        CHECK(ui::match_rank("bending mom", "Bending moment") == 1);
        CHECK(ui::match_rank("s", "An order of one's own") == 4);
        CHECK_FALSE(ui::match_rank("xyz", "Bending moment"));
    }

    TEST_CASE("Every chord is read back from its text, letter case aside")
    {
        for (int key = 0; key < ui::n_keys; ++key) {
            const ui::Chord chord{static_cast<ui::Key>(key),
                                  {.ctrl = key % 2 == 0, .shift = key % 3 == 0, .alt = key % 5 == 0}};
            CAPTURE(text(chord));
            CHECK(ui::chord_typed(text(chord)) == chord);
        }
        CHECK(ui::chord_typed("ctrl+shift+z") == ui::Chord{ui::Key::Z, ui::ctrl_shift});
        CHECK_FALSE(ui::chord_typed("Ctrl+"));
        CHECK_FALSE(ui::chord_typed("Hyper+Z"));
    }

    TEST_CASE("Undo, paste and the like belong to the field of text that has the keyboard, the rest to the app")
    {
        for (const char* keys : {"Ctrl+A", "Ctrl+C", "Ctrl+V", "Ctrl+X", "Ctrl+Y", "Ctrl+Z"})
            CHECK(ui::is_edit_of_text(*ui::chord_typed(keys)));
        for (const char* keys : {"Z", "Shift+Z", "Ctrl+Shift+Z", "Ctrl+S", "Ctrl+Enter"})
            CHECK_FALSE(ui::is_edit_of_text(*ui::chord_typed(keys)));
        for (const char* keys : {"Ctrl+Y", "Ctrl+Z"}) CHECK(ui::is_undo_or_redo(*ui::chord_typed(keys)));
        for (const char* keys : {"Z", "Ctrl+A", "Ctrl+X"}) CHECK_FALSE(ui::is_undo_or_redo(*ui::chord_typed(keys)));
    }
}
