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
