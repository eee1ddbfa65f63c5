#include <doctest/doctest.h>

#include "tests/folder.h"
#include "ui/app/settings.h"

using ui::Settings;

TEST_SUITE("ui app")
{
    TEST_CASE("Settings that are written are read again as they were")
    {
        const Settings all{.theme = ui::ThemeName::Dark,
                           .language = ui::Language::Portuguese,
                           .units = ui::UnitSystem::KnCm,
                           .has_panels = false,
                           .window = ui::Size{1013.5, 707.0},
                           .tools = "grid on 0.75 m snap off"};
        CHECK(ui::settings_of(ui::settings_text(all)) == all);
        CHECK(ui::settings_of(ui::settings_text({})) == Settings{});
        for (const ui::UnitSystem units : ui::all_unit_systems)
            CHECK(ui::settings_of(ui::settings_text({.units = units})).units == units);
    }

    TEST_CASE("Units of single quantities are written and read again")
    {
        ui::UnitChoices choices;
        choices.choose("moment", "kN·cm");
        choices.choose("inertia", "cm⁴");
        CHECK(ui::settings_of(ui::settings_text({.unit_choices = choices})).unit_choices == choices);
        CHECK_FALSE(ui::settings_of("unit moment furlong\n").unit_choices);
    }

    TEST_CASE("A line that is not understood costs no other")
    {
        const Settings read = ui::settings_of("theme mauve\ncolour 7\n\nlanguage pt\nwindow 12 9\npanels perhaps\n");
        CHECK(read == Settings{.language = ui::Language::Portuguese});
        CHECK_FALSE(ui::settings_of("window nan inf").window);
        CHECK_FALSE(ui::settings_of("window 1280").window);
    }

    TEST_CASE("What was asked for comes before what was left")
    {
        const Settings asked{.theme = ui::ThemeName::Print};
        const Settings left{.theme = ui::ThemeName::Dark, .has_panels = false};
        CHECK(asked.or_else(left) == Settings{.theme = ui::ThemeName::Print, .has_panels = false});
    }

    TEST_CASE("What was asked for this time alone is not kept, until it is changed by hand")
    {
        const Settings kept{.theme = ui::ThemeName::Dark, .has_panels = true};
        Settings now{.theme = ui::ThemeName::Projector, .language = ui::Language::Portuguese, .has_panels = true};
        ui::ChosenSettings chosen(kept, {.theme = ui::ThemeName::Projector, .language = ui::Language::Portuguese});
        CHECK(chosen.update(now) == kept);
        now.has_panels = false;
        CHECK(chosen.update(now) == Settings{.theme = ui::ThemeName::Dark, .has_panels = false});
        now.theme = ui::ThemeName::Light;
        CHECK(chosen.update(now) == Settings{.theme = ui::ThemeName::Light, .has_panels = false});
        now.theme = ui::ThemeName::Projector; // by hand now
        CHECK(chosen.update(now) == Settings{.theme = ui::ThemeName::Projector, .has_panels = false});
    }

    TEST_CASE("Where nothing was kept there are no settings")
    {
        const Folder folder;
        CHECK(ui::read_settings(folder.path() / "settings") == Settings{});
    }

    TEST_CASE("Where settings cannot be read there are none")
    {
        const Folder folder;
        CHECK(ui::read_settings(folder.path()) == Settings{}); // a folder opens, and fails at the first byte
    }
}
