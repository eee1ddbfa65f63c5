#include <doctest/doctest.h>

#include "ui/text/catalogue.h"

TEST_SUITE("ui text")
{
    TEST_CASE("English gives the sentence back, Portuguese its translation, an unknown sentence stays English")
    {
        const ui::Catalogue tr(ui::Language::Portuguese, {{"node", "nó", 1}});
        CHECK(ui::Catalogue()("node") == "node");
        CHECK(tr("node") == "nó");
        CHECK(tr("hinge") == "hinge");
        CHECK(tr.has("node"));
        CHECK_FALSE(tr.has("hinge"));
    }

    TEST_CASE("Places are filled by name in the order of the translation, and what is no place stays")
    {
        const ui::Catalogue tr(ui::Language::Portuguese, {{"{member} of {model}", "em {model}: {member} {} {x}", 1}});
        CHECK(ui::Catalogue()("{member} of {model}", {{"model", "portal"}, {"member", "AB"}}) == "AB of portal");
        CHECK(tr("{member} of {model}", {{"model", "{member}"}, {"member", "AB"}}) == "em {member}: AB {} {x}");
    }

    TEST_CASE("The places of a sentence are listed as often as they stand")
    {
        CHECK(ui::places("{1} to {0}, {name} {1} {not a place}") == std::vector<std::string>{"0", "1", "1", "name"});
    }

    TEST_CASE("A language is known by its code, whatever its country")
    {
        CHECK(ui::language_named("pt") == ui::Language::Portuguese);
        CHECK(ui::language_named("pt_BR.UTF-8") == ui::Language::Portuguese);
        CHECK(ui::language_named("en-GB") == ui::Language::English);
        CHECK_FALSE(ui::language_named("ptx"));
        CHECK_FALSE(ui::language_named(""));
    }

    TEST_CASE("A phrase is said in the language of the catalogue that it is given to")
    {
        const ui::Message message("Move node {node}", {{"node", "B"}});
        CHECK(ui::Catalogue()(message) == "Move node B");
        CHECK(ui::Catalogue(ui::Language::Portuguese, {{"Move node {node}", "Mover o nó {node}", 1}})(message) ==
              "Mover o nó B");
    }

    TEST_CASE("Numbers of a sentence have true minus signs; a text that was typed, and a name, stay as they are")
    {
        const ui::Catalogue tr;
        const auto said = [&](const char* value) { return tr(ui::Message("from {a}", {{"a", value}})); };
        CHECK(said("-180 mm") == "from −180 mm");
        CHECK(said("-1.2e-5") == "from −1.2e−5");
        CHECK(said("0,5") == "from 0,5");
        CHECK(said("A-1") == "from A-1");
        CHECK(said("2026-11-24") == "from 2026-11-24");
        CHECK(tr(ui::Message("found \"{a}\"", {{"a", "-180"}})) == "found \"-180\"");
    }

    TEST_CASE("A phrase within a phrase is translated, a name within it is not")
    {
        const ui::Catalogue tr(ui::Language::Portuguese,
                               {{"Move {part}", "Mover {part}", 1}, {"node {id}", "nó {id}", 3}, {"node", "nó", 5}});
        const ui::Message part("node {id}", {{"id", "node"}});
        CHECK(tr(ui::Message("Move {part}", {{"part", part}})) == "Mover nó node");
    }
}
