#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include "apps/frame/document/selection.h"
#include "apps/frame/session/commands.h"
#include "apps/frame/tables/data_table.h"
#include "apps/frame/window/member_panel.h"
#include "apps/frame/window/table_grid.h"
#include "ui/context/imgui_session.h"
#include "ui/context/input.h"
#include "ui/paint/text_measure.h"
#include "ui/widgets/path_dialog.h"

namespace frame {

/// The panel at the bottom of the window: the tables of the document and of its results, one at a time. While it has
/// the keyboard no key reaches the tools but those of commands with Ctrl and the F keys.
class TablesPanel {
public:
    /// Of the panel with its splitter [physical pixels]; 0 while it is closed.
    float height(const Workspace& workspace, float room) const;

    /// Fills what is left of the current window of Dear ImGui's.
    void show(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts);

    void settle(Workspace& workspace); ///< what is half typed goes into its cell
    bool is_editing() const { return grid_.is_editing(); }
    /// Takes what is meant for the table. \returns what is left for others
    ui::Input handle_input(Workspace& workspace, const ui::Input& input);
    /// To a window that everything else waits for, until `handle_input` is called again.
    static void lend_keyboard();
    void leave(); ///< it has the keyboard no longer

    /// Where the cursor is, in English: "Sections: column, Depth h [mm]"; nothing where no table is shown.
    std::optional<std::string> cell(const Workspace& workspace) const;

    void ask_for_file(const Workspace& workspace);
    bool is_asking() const { return path_dialog_.is_open(); }
    void show_dialog(Workspace& workspace);
    /// Writes the table that is shown. \returns why it could not
    std::optional<ui::Message> export_to(const Workspace& workspace, const std::filesystem::path& path);

private:
    void settle_before_leaving(Workspace& workspace);
    void follow(const Workspace& workspace);
    void follow_selection(const Workspace& workspace);
    void grab_keyboard_if_opened(Workspace& workspace);
    void go_to_wanted(Workspace& workspace);
    void show_splitter(float room);
    void show_tabs(Workspace& workspace);
    void show_group(Workspace& workspace, std::string_view label, std::initializer_list<TableKind> kinds);
    bool tab(Workspace& workspace, TableKind kind);
    bool begin_tab(const std::string& label, bool is_chosen);
    void show_table(Workspace& workspace);
    void show_member_tab(Workspace& workspace);
    std::optional<femoop::MovingEffect> number_in(const std::optional<std::pair<std::size_t, std::size_t>>& cell) const;
    std::optional<femoop::CaseId> case_in(std::pair<std::size_t, std::size_t> cell, const Session& session) const;
    void point_at_number(Workspace& workspace);
    void show_footer(const Session& session) const;
    void select_rows(Workspace& workspace);
    bool handle_key(Workspace& workspace, const ui::Chord& chord);
    static ui::Input take_presenter_keys(Workspace& workspace, const ui::Input& input);
    void carry_out(Workspace& workspace, const GridEdit& edit);
    bool fill_draft(Workspace& workspace, const GridEdit& edit);
    bool fill(Workspace& workspace, const GridEdit& edit);
    void copy(const Workspace& workspace) const;
    void paste(Workspace& workspace);
    void clear_block(Workspace& workspace);
    void remove_rows(Workspace& workspace);

    TableGrid grid_;
    MemberPanel member_;
    Table table_;
    std::string made_for_; ///< what the table was made for: another state of it makes it anew
    TableKind kind_ = TableKind::Nodes;
    std::uint64_t session_ = 0; ///< whose rows the cursor is in
    std::pair<BottomContent, TableKind> shown_{};
    bool was_open_ = false;
    bool has_keyboard_ = false;
    bool have_rows_come_back_ = false; ///< by undo: they are selected
    Selection chosen_;                 ///< that rows and selection agreed upon
    std::string message_;
    float height_ = 17.0F; ///< [ems]
    ui::PathDialog path_dialog_;
};

} // namespace frame
