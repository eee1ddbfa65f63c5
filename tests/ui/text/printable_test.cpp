#include <doctest/doctest.h>

#include "ui/text/printable.h"

TEST_SUITE("ui text")
{
    TEST_CASE("A name cannot speak to the terminal: its control characters are written out, all else stays")
    {
        CHECK(ui::printable("A\x1B[31mB\x07") == "A\\u001b[31mB\\u0007");
        CHECK(ui::printable("\x7F") == "\\u007f");
        CHECK(ui::printable("A\xC2\x9B") == "A\\u009b");
        CHECK(ui::printable("line\n\tnó °\r\n") == "line\n\tnó °\r\n");
        CHECK(ui::printable("") == "");
        CHECK(ui::printable("M − 3 ≤ 4 σ′ 日本 😀") == "M − 3 ≤ 4 σ′ 日本 😀");
    }

    TEST_CASE("A name cannot turn what is read: characters of direction and without width are written out")
    {
        CHECK(ui::printable("A\u202e\u2066B\u2069") == "A\\u202e\\u2066B\\u2069");
        CHECK(ui::printable("A\u200bB\u00ad\ufeff") == "A\\u200bB\\u00ad\\ufeff");
        CHECK(ui::printable("cut \xE2\x80") == "cut \xE2\x80");
        CHECK(ui::printable("A\U000E0001B\U000E007F") == "A\\udb40\\udc01B\\udb40\\udc7f");
        CHECK(ui::printable("cut \xF3\xA0\x81") == "cut \xF3\xA0\x81");
    }
}
