// Windows that everything else waits for, when two of them are wanted at once.
#include "tests/ui/widget_stage.h"
#include "ui/app/session_store.h"
#include "ui/text/catalogue.h"
#include "ui/widgets/side_window.h"
#include "ui/widgets/unsaved_question.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <optional>

TEST_SUITE_BEGIN("modal windows");

namespace {

/// The window's close button was pressed while something else was open over the picture.
struct Asked {
    ui_test::WidgetStage stage{1.0};
    std::optional<ui::UnsavedAnswer> answer;

    template <class Show> void frame(const ui::Input& input, const Show& show)
    {
        stage.frame(input, [&] {
            const ui::Catalogue english;
            show();
            if (!answer) answer = ui::ask_about_unsaved("beam.json", english);
        });
    }
    template <class Show> void rest(const Show& show)
    {
        for (int i = 0; i < 3; ++i) frame({}, show);
    }
    template <class Show> void escape(const Show& show)
    {
        frame({.keys = {{ui::Key::Escape, true}}}, show);
        frame({.keys = {{ui::Key::Escape, false}}}, show);
        rest(show);
    }
};

struct NoDesk {
    ui::Catalogue tr() const { return {}; }
    void open(const std::filesystem::path& /*path*/) {}
    void notify(const ui::Message& /*sentence*/) {}
    std::optional<std::uint64_t> recover(const ui::RecoverableFile& /*recoverable*/) { return std::nullopt; }
};

} // namespace

TEST_CASE("The question about unsaved changes takes the place of a window at the side and gives it back")
{
    if (!ui_test::has_renderer()) return;
    Asked asked;
    ui::SideWindow window;
    ui::TabStops stops;
    bool is_shown = false;
    const auto show = [&] {
        is_shown = window.begin(true, "###side", "Side", stops);
        if (is_shown) window.end(true, stops);
    };
    asked.rest(show);
    CHECK(!is_shown);
    asked.escape(show);
    CHECK(asked.answer == ui::UnsavedAnswer::Cancel);
    CHECK(is_shown);
}

TEST_CASE("Escape answers the question about unsaved changes first and then puts the list of last files away")
{
    if (!ui_test::has_renderer()) return;
    Asked asked;
    NoDesk workspace;
    ui::SessionStore kept(std::nullopt);
    kept.handle_request(ui::Request::RecentList);
    const auto show = [&] { kept.show(workspace); };
    asked.rest(show);
    asked.escape(show);
    CHECK(asked.answer == ui::UnsavedAnswer::Cancel);
    CHECK(kept.is_open());
    asked.escape(show);
    CHECK(!kept.is_open());
}

TEST_SUITE_END();
