#include <doctest/doctest.h>
#include <stdexcept>

#include "ui/history/history.h"

namespace {

using Numbers = ui::History<int>;

} // namespace

TEST_SUITE("ui history")
{
    TEST_CASE("Undo goes back through every step and redo forward, each with its label")
    {
        Numbers history(10);
        history.apply(20, "Twenty");
        history.apply(30, "Thirty");
        CHECK(history.undo_label() == ui::Phrase("Thirty"));
        history.undo();
        CHECK(history.current() == 20);
        CHECK(history.redo_label() == ui::Phrase("Thirty"));
        history.undo();
        history.undo();
        CHECK(history.current() == 10);
        CHECK_FALSE(history.undo_label());
        history.redo();
        history.redo();
        history.redo();
        CHECK(history.current() == 30);
        CHECK_FALSE(history.can_redo());
    }

    TEST_CASE("A gesture of many changes is one step")
    {
        Numbers history(10);
        for (const int value : {11, 12, 17, 15}) history.drag(value, "Drag");
        CHECK(history.current() == 15);
        history.settle();
        CHECK(history.n_states() == 2);
        history.undo();
        CHECK(history.current() == 10);
    }

    TEST_CASE("Two gestures are two steps, though settle stands alone between them")
    {
        Numbers history(10);
        history.drag(11, "First");
        history.settle();
        history.drag(12, "Second");
        history.settle();
        history.undo();
        CHECK(history.current() == 11);
    }

    TEST_CASE("A gesture that ends where it began is no step")
    {
        Numbers history(10);
        history.drag(11, "Drag");
        history.drag(10, "Drag");
        history.settle();
        CHECK(history.n_states() == 1);
        CHECK_FALSE(history.can_undo());
    }

    TEST_CASE("A cancelled gesture leaves the document as it was")
    {
        Numbers history(10);
        history.apply(20, "Twenty");
        history.drag(25, "Drag");
        history.cancel();
        CHECK(history.current() == 20);
        CHECK(history.undo_label() == ui::Phrase("Twenty"));
    }

    TEST_CASE("Undo in the middle of a gesture takes back the whole gesture and nothing before it")
    {
        Numbers history(10);
        history.apply(20, "Twenty");
        history.drag(21, "Drag");
        history.drag(22, "Drag");
        history.undo();
        CHECK(history.current() == 20);
        CHECK_FALSE(history.is_dragging());
    }

    TEST_CASE("A step that changes nothing is no step")
    {
        Numbers history(10);
        history.apply(10, "Nothing");
        history.drag(10, "Nothing");
        CHECK(history.n_states() == 1);
        CHECK_FALSE(history.is_dragging());
    }

    TEST_CASE("A new step after an undo forgets what could be redone")
    {
        Numbers history(10);
        history.apply(20, "Twenty");
        history.apply(30, "Thirty");
        history.undo();
        history.apply(40, "Forty");
        CHECK(history.n_states() == 3);
        CHECK_FALSE(history.can_redo());
        history.undo();
        CHECK(history.current() == 20);
    }

    TEST_CASE("A jump reaches any state and keeps those after it")
    {
        Numbers history(10);
        for (const int value : {20, 30, 40}) history.apply(value, "Step");
        history.jump(1);
        CHECK(history.current() == 20);
        history.jump(3);
        CHECK(history.current() == 40);
        CHECK_THROWS_AS(history.jump(4), std::out_of_range);
        CHECK(history.current() == 40);
    }
}
