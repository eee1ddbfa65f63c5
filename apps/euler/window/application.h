#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/euler/session/commands.h"
#include "apps/euler/window/canvas.h"
#include "apps/euler/window/operators_panel.h"
#include "apps/euler/window/tables_panel.h"
#include "ui/app/app.h"
#include "ui/context/context.h"
#include "ui/context/imgui_session.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/path_dialog.h"

namespace euler {

/// The stepper on a context, on the screen or off it. Each frame goes one way: input, step, picture.
class Application final : public ui::App {
public:
    /// \pre context and fonts outlive the application
    Application(ui::Context& context, const ui::Fonts& fonts, Session session);

    void frame(const ui::Input& input) override;
    bool is_moving() const override;
    void ask_to_quit() override;
    bool wants_to_quit() const override { return wants_to_quit_; }
    std::string window_title() const override;
    ui::ImGuiSession& gui() override { return gui_; }

    Desk& desk() { return desk_; }
    const Desk& desk() const { return desk_; }
    const Session& session() const { return desk_.session; }
    const CommandTable& commands() const { return commands_; }
    const Canvas& canvas() const { return canvas_; }
    /// Writes the picture to a file (.png, .svg or .pdf), and tells how it went. \returns why it cannot
    std::optional<ui::Phrase> export_as(const std::filesystem::path& path);

private:
    void take_keys(const ui::Input& input);
    void take_files(const std::vector<std::string>& files);
    void take_requests();
    void take(Request request);
    void ask_for_path(ui::PathDialog::Purpose purpose, const std::filesystem::path& start);
    void explain(const ui::Phrase& reason);
    void copy_picture();
    void show_menu_bar();
    void show_body();
    void show_left(float width);
    void show_right(float width);
    void show_canvas();
    void show_notice();
    void show_status_bar();
    void show_dialogs();
    void ask_about_unsaved();

    Desk desk_;
    CommandTable commands_;
    ui::ImGuiSession gui_;
    ui::Context& context_;
    const ui::Fonts& fonts_;
    Canvas canvas_;
    OperatorsPanel operators_;
    TablesPanel tables_;
    ui::CommandPalette palette_;
    ui::PathDialog path_dialog_;
    ui::ThemeName theme_;
    ui::SidePanels sides_{{17.0F, 23.0F}, {0.25F, 0.32F}};
    float tables_height_ = 15.0F;
    bool shows_shortcuts_ = false;
    bool shows_description_ = false;
    bool is_exporting_ = false; ///< what the path dialog is open for
    bool wants_to_quit_ = false;
};

} // namespace euler
