#include "ui/workbench/edited_document.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

namespace {

/// A session of a number that must not be larger than what is allowed.
class Counter : public ui::EditedDocument<int> {
public:
    Counter() : EditedDocument(3) {}

    void set(int value) { history_.apply(value, ui::Message("Set")); }
    void drag(int value) { history_.drag(value, ui::Message("Drag")); }
    void open_another(int value) { begin(value); }
    int allowed = 100;
    std::vector<int> before; ///< what `follow` was told
    const ui::Catalogue& tr() const override { return tr_; }

private:
    std::optional<ui::Notice> read(const std::filesystem::path&) override { return std::nullopt; }
    std::string file_text() const override { return std::to_string(document()); }
    std::string about(const ui::Catalogue&) const override { return file_text(); }
    std::optional<ui::Message> why_not_here() const override
    {
        return document() > allowed ? std::optional<ui::Message>("too large") : std::nullopt;
    }
    void follow(const int& former) override { before.push_back(former); }

    ui::Catalogue tr_;
};

} // namespace

TEST_SUITE("ui workbench")
{
    TEST_CASE("Undo, redo and a way to any state tell what was there before")
    {
        Counter counter;
        counter.set(5);
        counter.set(8);
        counter.undo();
        CHECK(counter.document() == 5);
        counter.redo();
        CHECK(counter.document() == 8);
        counter.go_to_state(0);
        CHECK(counter.document() == 3);
        CHECK(counter.before == std::vector{8, 5, 8});
        CHECK_FALSE(counter.is_dirty());
    }

    TEST_CASE("A state that the session refuses is left again, with a notice")
    {
        Counter counter;
        counter.set(50);
        counter.set(20);
        counter.allowed = 30;
        counter.undo();
        CHECK(counter.document() == 20);
        CHECK(counter.history().place() == 2);
        REQUIRE(counter.notice);
        CHECK(counter.tr()(counter.notice->sentence) == "too large");
    }

    TEST_CASE("What was told of a state goes with it, but for what waits to be closed")
    {
        Counter counter;
        counter.set(5);
        counter.notify("five");
        counter.undo();
        CHECK_FALSE(counter.notice);
        counter.notice = ui::lasting("a file is damaged");
        counter.redo();
        CHECK(counter.notice);
    }

    TEST_CASE("A gesture that came back to where it began is no state to be gone back to")
    {
        Counter counter;
        counter.set(50);
        counter.set(20);
        counter.allowed = 30;
        counter.drag(7);
        counter.drag(20);
        counter.undo();
        CHECK(counter.document() == 20);
        CHECK(counter.history().n_states() == 3);
    }

    TEST_CASE("Another document begins saved and with nothing to undo")
    {
        Counter counter;
        counter.set(5);
        counter.open_another(11);
        CHECK(counter.document() == 11);
        CHECK_FALSE(counter.history().can_undo());
        CHECK_FALSE(counter.is_dirty());
    }
}
