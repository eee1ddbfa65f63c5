#include <cstddef>
#include <doctest/doctest.h>
#include <stdexcept>

#include "ui/history/history.h"

namespace {

using Numbers = ui::History<int>;

/// A document of a size that is told.
struct Drawing {
    int number = 0;
    std::size_t bytes = 100;

    friend bool operator==(const Drawing&, const Drawing&) = default;
    friend std::size_t memory_footprint(const Drawing& drawing) { return drawing.bytes; }
};
using Drawings = ui::History<Drawing>;

} // namespace

TEST_SUITE("ui history")
{
    TEST_CASE("Undo goes back through every step and redo forward, each with its label")
    {
        Numbers history(10);
        history.apply(20, "Twenty");
        history.apply(30, "Thirty");
        CHECK(history.undo_label() == ui::Message("Thirty"));
        history.undo();
        CHECK(history.current() == 20);
        CHECK(history.redo_label() == ui::Message("Thirty"));
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
        CHECK(history.undo_label() == ui::Message("Twenty"));
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

    TEST_CASE("A history forgets its oldest states where all together would take more memory than the limit")
    {
        Drawings history({.number = 0}, {}, 350);
        for (int i = 1; i <= 5; ++i) history.apply({.number = i}, "Draw");
        CHECK(history.n_states() == 3);
        CHECK(history.memory() == 300);
        CHECK(history.current().number == 5);
        while (history.can_undo()) history.undo();
        CHECK(history.current().number == 3);
    }

    TEST_CASE("One step can be undone however large its document is")
    {
        Drawings history({.number = 0}, {}, 350);
        history.apply({.number = 1, .bytes = 1000}, "Draw");
        history.apply({.number = 2, .bytes = 2000}, "Draw");
        CHECK(history.n_states() == 2);
        history.undo();
        CHECK(history.current().number == 1);
    }

    TEST_CASE("A gesture that grows beyond the limit forgets the oldest states and can still be cancelled")
    {
        Drawings history({.number = 0}, {}, 350);
        history.apply({.number = 1}, "Draw");
        for (int i = 2; i < 9; ++i) history.drag({.number = i, .bytes = 200}, "Drag");
        CHECK(history.settled().number == 1);
        CHECK(history.memory() == 300);
        history.cancel();
        CHECK(history.current().number == 1);
        CHECK(history.memory() == 100);
    }

    TEST_CASE("What can be redone no more takes no memory")
    {
        Drawings history({.number = 0}, {}, 1000);
        for (int i = 1; i <= 4; ++i) history.apply({.number = i}, "Draw");
        for (int i = 0; i < 3; ++i) history.undo();
        history.apply({.number = 9}, "Draw");
        CHECK(history.memory() == 300);
    }
}
