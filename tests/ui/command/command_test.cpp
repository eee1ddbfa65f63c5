#include <doctest/doctest.h>

#include "ui/command/command_table.h"

namespace {

struct Lamp {
    bool is_lit = false;
    bool has_bulb = true;
};

ui::CommandTable<Lamp> lamp_commands()
{
    ui::CommandTable<Lamp> table;
    table.add({.id = "lamp.switch",
               .menu = "Lamp",
               .label = "Switch",
               .shortcuts = {{ui::Key::L, ui::ctrl}},
               .run = [](Lamp& lamp) { lamp.is_lit = !lamp.is_lit; },
               .why_not = [](const Lamp& lamp) -> std::optional<ui::Phrase> {
                   if (lamp.has_bulb) return std::nullopt;
                   return "the lamp has no bulb";
               },
               .is_on = [](const Lamp& lamp) { return lamp.is_lit; }});
    table.add({.id = "lamp.unscrew", .menu = "Lamp", .label = "Take the bulb out", .run = [](Lamp& lamp) {
                   lamp = {.is_lit = false, .has_bulb = false};
               }});
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

    TEST_CASE("A command that cannot run says why and changes nothing")
    {
        const auto table = lamp_commands();
        Lamp lamp{.is_lit = false, .has_bulb = false};
        CHECK(run(*table.find("lamp.switch"), lamp) == ui::Phrase("the lamp has no bulb"));
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
            table.add(
                {.id = id,
                 .menu = "Lamp",
                 .label = label,
                 .run = [](Lamp&) {},
                 .why_not =
                     [can_run](const Lamp&) { return can_run ? std::nullopt : std::optional<ui::Phrase>("not now"); }});
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

    TEST_CASE("A whole word is better than its beginning, that better than its middle, and that than scattered letters")
    {
        CHECK(ui::match_rank("moment", "Bending moment") == 0);
        CHECK(ui::match_rank("mom", "Bending moment") == 1);
        CHECK(ui::match_rank("omen", "Bending moment") == 2);
        CHECK(ui::match_rank("bnm", "Bending moment").value() > ui::worst_rank_of_words);
        CHECK(ui::match_rank("acao", "Reação").value() >= 1);
        CHECK(ui::match_rank("case", "New case (load cases)") == 0); // also behind a worse place
        CHECK(ui::match_rank("moment bending", "Bending moment") == 0);
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
    }
}
