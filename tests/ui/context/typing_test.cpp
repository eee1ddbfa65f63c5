#include "ui/context/typing.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

TEST_SUITE_BEGIN("typing");

using ui::Key;
using Reader = ui::Typing::Reader;

namespace {

struct Typist {
    ui::Typing typing;

    void press(Key key, ui::Modifiers held = {})
    {
        typing.add(ui::KeyEvent{key, true, held});
        typing.add(ui::KeyEvent{key, false, held});
    }
    void write(Key key, const char* text)
    {
        typing.add(ui::KeyEvent{key, true});
        typing.add(text);
        typing.add(ui::KeyEvent{key, false});
    }

    /// What each frame hears: its text, and its keys as letters (T: Tab, Enter: E).
    std::vector<std::string> frames(Reader reader)
    {
        std::vector<std::string> all;
        while (!typing.is_empty()) {
            ui::Input input;
            typing.deliver_next(input, reader);
            for (const ui::KeyEvent& event : input.keys)
                if (event.is_down && event.key == Key::Tab) input.text += " Tab";
                else if (event.is_down && event.key == Key::Enter) input.text += " Enter";
            all.push_back(input.text);
        }
        return all;
    }
};

} // namespace

TEST_CASE("Tab between letters stays between them, however fast they are typed")
{
    for (const Reader reader : {Reader::Field, Reader::Keys}) {
        Typist typist;
        typist.write(Key::W, "W");
        typist.press(Key::Tab);
        typist.write(Key::B, "B");
        typist.press(Key::Enter);
        CHECK(typist.frames(reader) == std::vector<std::string>{"W", " Tab", "B", " Enter"});
    }
}

TEST_CASE("A field reads many letters in a frame, shortcuts one key")
{
    const auto typed = [](Reader reader) {
        Typist typist;
        typist.write(Key::M, "m");
        typist.write(Key::Digit4, "4");
        typist.typing.add("<");
        return typist.frames(reader);
    };
    CHECK(typed(Reader::Field) == std::vector<std::string>{"m4<"});
    CHECK(typed(Reader::Keys) == std::vector<std::string>{"m", "4", "<"});
}

TEST_CASE("While more waits the modifiers are those of the stroke, not those of the end of the frame")
{
    Typist typist;
    typist.press(Key::A, ui::ctrl);
    typist.write(Key::X, "x");
    ui::Input input;
    typist.typing.deliver_next(input, Reader::Field);
    CHECK(input.modifiers.ctrl);
    CHECK(input.text.empty());
    ui::Input next;
    typist.typing.deliver_next(next, Reader::Field);
    CHECK(!next.modifiers.ctrl);
    CHECK(next.text == "x");
}

TEST_CASE("Text that is put back comes before what was typed later")
{
    ui::Typing typing;
    typing.add("emp");
    typing.put_back("t");
    ui::Input input;
    typing.deliver_next(input, Reader::Field);
    CHECK(input.text == "temp");
}

TEST_SUITE_END();
