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
    }
}
