#include "ui/widgets/path_dialog.h"

#include "tests/folder.h"
#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

namespace fs = std::filesystem;

TEST_SUITE_BEGIN("path dialog");

namespace {

struct DialogStage : ui_test::Hand {
    ui_test::WidgetStage stage{1.0};
    ui::PathDialog dialog;
    std::optional<fs::path> chosen;

    void frame(const ui::Input& input) override
    {
        stage.frame(input, [&] {
            const ui::Catalogue english;
            if (const auto path = dialog.show(english)) chosen = path;
        });
    }
};

} // namespace

TEST_CASE("A path that is typed is opened, with the ending that was left out")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    DialogStage stage;
    stage.dialog.open(ui::PathDialog::Purpose::Open, folder.path() / "old.json", ".json");
    stage.rest();
    stage.type("beam");
    stage.key(ui::Key::Enter);
    CHECK(stage.chosen == folder.path() / "beam.json");
    CHECK(!stage.dialog.is_open());
}

TEST_CASE("A file that exists is replaced only when asked twice")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    folder.write("there.json", "{}");
    DialogStage stage;
    stage.dialog.open(ui::PathDialog::Purpose::Save, folder.path() / "", ".json");
    stage.rest();
    stage.type("there.json");
    stage.key(ui::Key::Enter);
    CHECK(!stage.chosen);
    CHECK(stage.dialog.is_open());
}

TEST_CASE("Saving begins with the old name selected: what is typed takes its place")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    DialogStage stage;
    stage.dialog.open(ui::PathDialog::Purpose::Save, folder.path() / "old.json", ".json");
    stage.rest();
    stage.type("other");
    stage.key(ui::Key::Enter);
    CHECK(stage.chosen == folder.path() / "other.json");
}

TEST_CASE("A document is saved with its own ending alone, but under the name that it came with")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    DialogStage stage;
    stage.dialog.open(ui::PathDialog::Purpose::Save, folder.path() / "came.txt", ".json");
    stage.rest();
    stage.type("frame.pdf");
    stage.key(ui::Key::Enter);
    CHECK(!stage.chosen);
    CHECK(stage.dialog.is_open());
    DialogStage again;
    again.dialog.open(ui::PathDialog::Purpose::Save, folder.path() / "came.txt", ".json");
    again.rest();
    again.key(ui::Key::Enter);
    CHECK(again.chosen == folder.path() / "came.txt");
}

TEST_CASE("An export with a wrong ending keeps the dialog and the keyboard, and the ending can be mended")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    DialogStage stage;
    stage.dialog.open_export(folder.path() / "beam.svg", {".svg", ".report.pdf"});
    stage.rest();
    stage.type("beam.doc");
    stage.key(ui::Key::Enter);
    CHECK(!stage.chosen);
    REQUIRE(stage.dialog.is_open());
    for (int i = 0; i < 4; ++i) stage.key(ui::Key::Backspace);
    stage.type(".report.pdf");
    stage.key(ui::Key::Enter);
    CHECK(stage.chosen == folder.path() / "beam.report.pdf");
}

TEST_CASE("A number after a point belongs to the name")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    DialogStage stage;
    stage.dialog.open_export(folder.path() / "beam.svg", {".svg", ".report.pdf"});
    stage.rest();
    stage.type("beam v1.2");
    stage.key(ui::Key::Enter);
    CHECK(stage.chosen == folder.path() / "beam v1.2.svg");
}

TEST_CASE("What cannot be written is asked for again, with the name that was typed")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    DialogStage stage;
    stage.dialog.open_export(folder.path() / "beam.svg", {".svg"});
    stage.rest();
    stage.key(ui::Key::Enter);
    REQUIRE(stage.chosen);
    stage.chosen.reset();
    stage.dialog.refuse(ui::Message("the disk is full"));
    stage.rest();
    CHECK(stage.dialog.is_open());
    stage.key(ui::Key::Enter);
    CHECK(stage.chosen == folder.path() / "beam.svg");
}

TEST_CASE("Esc closes the dialog and chooses nothing")
{
    if (!ui_test::has_renderer()) return;
    const Folder folder;
    DialogStage stage;
    stage.dialog.open(ui::PathDialog::Purpose::Open, folder.path() / "", ".json");
    stage.rest();
    stage.key(ui::Key::Escape);
    CHECK(!stage.chosen);
    CHECK(!stage.dialog.is_open());
}

TEST_SUITE_END();
