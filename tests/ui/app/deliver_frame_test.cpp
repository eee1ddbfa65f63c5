#include "ui/app/deliver_frame.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/ui/widget_stage.h"

namespace {

/// Notes how long its frames are.
class ClockApp final : public ui::App {
public:
    void frame(const ui::Input& input) override
    {
        seconds.push_back(input.seconds);
        stage_.frame(input, [] {});
    }
    bool is_moving() const override { return false; }
    void ask_to_quit() override {}
    bool wants_to_quit() const override { return false; }
    std::string window_title() const override { return "clock"; }
    ui::ExportToApp copy_of_document() const override { return {}; }
    std::string document_in_words() const override { return {}; }
    std::optional<std::string> replace_document(const std::filesystem::path&) override { return std::nullopt; }
    std::optional<std::string> run_command(const std::string&, const std::string&) override { return std::nullopt; }
    ui::ImGuiSession& gui() override { return stage_.session; }
    const ui::ImGuiSession& gui() const override { return stage_.session; }

    std::vector<double> seconds;

private:
    ui_test::WidgetStage stage_{1.0};
};

} // namespace

TEST_CASE("What the app itself takes long for is no time in which somebody reads a notice")
{
    if (!ui_test::has_renderer()) return;
    ClockApp app;
    ui::Typing typing;
    ui::deliver_frame(app, {.seconds = 0.02}, typing);
    ui::deliver_frame(app, {.seconds = 14.0}, typing);
    CHECK(app.seconds == std::vector{0.02, 0.5});
}
