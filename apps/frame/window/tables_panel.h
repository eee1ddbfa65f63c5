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
    float height(const Desk& desk, float room) const;

    /// Fills what is left of the current window of Dear ImGui's.
    void show(Desk& desk, ui::ImGuiSession& gui, const ui::Fonts& fonts);

    /// Takes what is meant for the table. \returns what is left for others
    ui::Input take(Desk& desk, const ui::Input& input);
    /// To a window that everything else waits for, until `take` is called again.
    static void lend_keyboard();

    /// Where the cursor is, in English: "Sections: column, Depth h [mm]"; nothing where no table is shown.
    std::optional<std::string> cell(const Desk& desk) const;

    void ask_for_file(const Desk& desk);
    bool is_asking() const { return path_dialog_.is_open(); }
    void show_dialog(Desk& desk);
    /// Writes the table that is shown. \returns why it could not
    std::optional<ui::Phrase> export_to(const Desk& desk, const std::filesystem::path& path);

private:
    void follow(const Desk& desk);
    void follow_selection(const Desk& desk);
    void take_keyboard_if_opened(const Desk& desk);
    void go_to_wanted(Desk& desk);
    void show_splitter(float room);
    void show_tabs(Desk& desk);
    void show_group(Desk& desk, std::string_view label, std::initializer_list<TableKind> kinds);
    bool tab(Desk& desk, TableKind kind);
    bool begin_tab(const std::string& label, bool is_chosen);
    void show_table(Desk& desk);
    void show_member_tab(Desk& desk);
    void show_footer(const Session& session) const;
    void select_rows(Desk& desk);
    bool take_key(Desk& desk, const ui::Chord& chord);
    void carry_out(Desk& desk, const GridEdit& edit);
    bool fill_draft(Desk& desk, const GridEdit& edit);
    bool fill(Desk& desk, const GridEdit& edit);
    void copy(const Desk& desk) const;
    void paste(Desk& desk);
    void clear_block(Desk& desk);
    void remove_rows(Desk& desk);
    void leave();

    TableGrid grid_;
    MemberPanel member_;
    Table table_;
    std::string made_for_; ///< what the table was made for: another state of it makes it anew
    TableKind kind_ = TableKind::Nodes;
    std::string document_; ///< whose rows the cursor is in
    std::pair<BottomContent, TableKind> shown_{};
    bool was_open_ = false;
    bool has_keyboard_ = false;
    Selection chosen_; ///< that rows and selection agreed upon
    std::string message_;
    float height_ = 17.0F; ///< [ems]
    ui::PathDialog path_dialog_;
};

} // namespace frame
