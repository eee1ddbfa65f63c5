#include "ui/app/unsaved_changes.h"

#include "tests/folder.h"
#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

namespace fs = std::filesystem;
using enum ui::UnsavedChanges::Fate;

TEST_SUITE_BEGIN("unsaved changes");

namespace {

struct Sheet {
    std::string name() const { return file ? file->filename().string() : "Untitled"; }
    const std::optional<fs::path>& path() const { return file; }
    bool is_dirty() const { return has_changes; }
    bool save(const fs::path& path)
    {
        if (!can_save) return false;
        file = path;
        has_changes = false;
        return true;
    }

    std::optional<fs::path> file{};
    bool has_changes = true, can_save = true;
};

/// An app with one changed document whose end was asked for.
struct Ending : ui_test::Hand {
    ui_test::WidgetStage stage{1.0};
    ui::Dialogs dialogs{{.extension = ".eul", .exports = {".png"}}};
    ui::UnsavedChanges changes;
    Sheet sheet;
    std::optional<ui::UnsavedChanges::Fate> fate;

    void frame(const ui::Input& input) override
    {
        stage.frame(input, [&] {
            const ui::Catalogue english;
            if (const auto file = dialogs.show_dialog(english)) sheet.save(file->path);
            if (!fate) fate = changes.ask(sheet, dialogs, english);
        });
    }
    /// An arrow shows which button has the keyboard: the first one.
    void choose_save()
    {
        rest();
        key(ui::Key::Left);
        key(ui::Key::Space);
    }
};

} // namespace

TEST_CASE("Changes of a document without a file are saved once the dialog has given it a name")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    Ending ending;
    ending.choose_save();
    CHECK(!ending.fate);
    CHECK(ending.dialogs.shows_dialog());
    ending.type((folder.path() / "cube").string());
    ending.key(ui::Key::Enter);
    CHECK(ending.fate == Saved);
    CHECK(ending.sheet.file == folder.path() / "cube.eul");
}

TEST_CASE("Who gives up the dialog keeps the document and its changes")
{
    if (!ui_test::has_renderer()) return;
    Ending ending;
    ending.choose_save();
    REQUIRE(ending.dialogs.shows_dialog());
    ending.key(ui::Key::Escape);
    CHECK(ending.fate == Kept);
    CHECK(ending.sheet.has_changes);
}

TEST_CASE("Changes that could not be saved under the name are kept")
{
    if (!ui_test::has_renderer()) return;
    Ending ending;
    ending.sheet.can_save = false;
    ending.choose_save();
    ending.type("/nowhere/cube");
    ending.key(ui::Key::Enter);
    CHECK(ending.fate == Kept);
}

TEST_CASE("Changes of a file are saved to it without a dialog, and kept where that fails")
{
    if (!ui_test::has_renderer()) return;
    for (const bool can_save : {true, false}) {
        CAPTURE(can_save);
        Ending ending;
        ending.sheet.file = "cube.eul";
        ending.sheet.can_save = can_save;
        ending.choose_save();
        CHECK(ending.fate == (can_save ? Saved : Kept));
        CHECK(!ending.dialogs.shows_dialog());
    }
}

TEST_SUITE_END();
