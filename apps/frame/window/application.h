#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/frame/session/commands.h"
#include "apps/frame/session/linked_programs.h"
#include "apps/frame/window/canvas.h"
#include "apps/frame/window/case_list.h"
#include "apps/frame/window/context_menu.h"
#include "apps/frame/window/export.h"
#include "apps/frame/window/kind_question.h"
#include "apps/frame/window/property_sets.h"
#include "apps/frame/window/questions.h"
#include "apps/frame/window/section_window.h"
#include "apps/frame/window/tables_panel.h"
#include "apps/frame/window/title_rows.h"
#include "apps/frame/window/typical_window.h"
#include "apps/frame/window/view_list.h"
#include "ui/app/app.h"
#include "ui/app/dialogs.h"
#include "ui/app/session_store.h"
#include "ui/context/context.h"
#include "ui/context/imgui_session.h"
#include "ui/context/input.h"
#include "ui/paint/text_measure.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/path_dialog.h"

namespace frame {

/// The frame app on a context, on the screen or off it. Each frame goes one way: input, edits, document, solution,
/// picture.
class Application final : public ui::App {
public:
    /// \pre context and fonts outlive the application
    Application(ui::Context& context, const ui::Fonts& fonts, Session session);

    void frame(const ui::Input& input) override;

    Workspace& workspace() { return workspace_; }
    const Workspace& workspace() const { return workspace_; }
    Session& session() { return workspace_.session; }
    const Session& session() const { return workspace_.session; }
    const CommandTable& commands() const { return commands_; }
    const Canvas& canvas() const { return canvas_; }
    bool is_moving() const override;
    bool wants_to_quit() const override { return wants_to_quit_; }
    void ask_to_quit() override;
    /// From now on the last files and drafts of unsaved work are kept there. Offers what was left behind.
    void remember_in(const ui::DraftFolder& folder);
    /// Starts another program of the suite. \returns why it cannot
    using StartProgram = std::function<std::optional<ui::Message>(const ui::ExportToApp&)>;
    void start_programs_by(StartProgram start) { start_program_ = std::move(start); }
    /// What another program was given last.
    const std::optional<ui::ExportToApp>& handed() const { return handed_; }
    /// Writes the picture, the results or a report to a file (export.h), and tells that it did. \returns why it cannot
    std::optional<ui::Message> export_as(const std::filesystem::path& path);
    std::optional<ui::Message> copy_picture(); ///< to the system's clipboard. \returns why it cannot
    std::string window_title() const override;
    ui::ImGuiSession& gui() override { return gui_; }
    TablesPanel& tables() { return tables_; }
    const TablesPanel& tables() const { return tables_; }

private:
    void handle_keys(const ui::Input& all);
    bool handle_typing(ui::Key key);
    bool close_topmost_window();
    void explain(const ui::Message& reason);
    void handle_files(const std::vector<std::string>& files);
    void handle_requests();
    void take(ui::Request request);
    void take(Request request);
    void take(const ui::ChosenFile& file);
    void hand_over(ui::ExportToApp exported);
    void show_menu_bar();
    void show_body();
    void show_left(float width);
    void show_right(float width);
    void show_tabs();
    void show_canvas();
    void show_dialogs();
    bool is_swinging() const; ///< the deformed shape or a mechanism
    void animate(double seconds);

    Workspace workspace_;
    CommandTable commands_;
    ui::ImGuiSession gui_;
    ui::Context& context_;
    const ui::Fonts& fonts_;
    Canvas canvas_;
    TypicalWindow typical_window_;
    TablesPanel tables_;
    SectionWindow section_window_;
    ViewList view_list_;
    PropertySets property_sets_;
    TitleRows title_rows_;
    CaseList case_list_;
    ContextMenu context_menu_;
    KindQuestion kind_question_;
    ui::PathDialog import_dialog_;
    ui::NumberFields fields_;
    ui::Dialogs dialogs_{{.extension = ".json", .left_out = ".view.json", .exports = export_endings()}};
    Questions questions_;
    ui::SessionStore session_store_{std::nullopt};
    ui::ThemeName theme_;
    ui::SidePanels sides_{{16.5F, 24.0F}, {0.25F, 0.30F}};
    double time_;                ///< of the animation since the middle of a swing [s]
    StartProgram start_program_; ///< none: nothing is started, as in a scenario
    std::optional<ui::ExportToApp> handed_;
    LinkedPrograms linked_;
    bool wants_to_quit_ = false;
    bool had_popup_ = false; ///< in the last frame: Esc, which has closed it since, was for it
};

} // namespace frame
