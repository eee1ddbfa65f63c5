#include <doctest/doctest.h>

#include "ui/text/po_reader.h"

TEST_SUITE("ui text")
{
    TEST_CASE("A translation file gives its entries without the header, long strings joined, escapes read")
    {
        const auto entries = ui::read_po(
            "msgid \"\"\nmsgstr \"Language: pt_BR\\n\"\n\n# a comment\nmsgid \"node\"\n"
            "msgstr \"nó\"\n\nmsgid \"\"\n\"say \\\"\"\n\"hinge\\\"\"\nmsgstr \"rótula\\n\"\n");
        REQUIRE(entries.size() == 2);
        CHECK(entries[0] == ui::PoEntry{"node", "nó", 5});
        CHECK(entries[1] == ui::PoEntry{"say \"hinge\"", "rótula\n", 8});
    }

    TEST_CASE("A file with Windows line ends reads the same")
    {
        CHECK(ui::read_po("msgid \"a\"\r\nmsgstr \"b\"\r\n") == ui::read_po("msgid \"a\"\nmsgstr \"b\"\n"));
    }

    TEST_CASE("What the reader refuses is named with its line")
    {
        const auto words = [](const char* text) -> std::string {
            try {
                ui::read_po(text);
            } catch (const ui::PoError& error) {
                return error.what();
            }
            return "nothing";
        };
        CHECK(words("msgid \"a\"\n") == "line 1: msgid \"a\" without a msgstr");
        CHECK(words("msgid \"a\"\nmsgstr \"\"\n") == "line 2: msgid \"a\" has an empty translation");
        CHECK(words("msgstr \"b\"\n") == "line 1: msgstr without a msgid before it");
        CHECK(words("msgid \"a\nmsgstr \"b\"\n") == "line 1: a string without its closing quote");
        CHECK(words("msgid \"a\\q\"\n") == "line 1: unknown escape \\q");
        CHECK(words("msgid \"a\\\"\n") == "line 1: a string without its closing quote");
        CHECK(words("msgid \"a\"\nmsgstr \"b\"\nmsgid \"a\"\nmsgstr \"c\"\n") == "line 4: msgid \"a\" stands twice");
        CHECK(words("msgid_plural \"a\"\n") ==
              "line 1: expected msgid, msgstr, a string in quotes or a comment, found: msgid_plural \"a\"");
    }
}
