#include "apps/frame/window/tables_panel.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "apps/drawing/results/envelope_cases.h"
#include "apps/frame/document/drawing.h"
#include "apps/frame/session/table_commands.h"
#include "apps/frame/tables/result_table.h"
#include "apps/frame/window/derivation_panel.h"
#include "apps/frame/window/no_results.h"
#include "apps/frame/window/solver_panel.h"
#include "femoop/files/whole_file.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/widgets/panel.h"

namespace frame {

using ui::Key;
using ui::translatable;

namespace {

// Of what is no table [ems].
constexpr float least_height_of_diagrams = 20.0F;
constexpr float least_height_of_solver = 27.0F;
constexpr float least_height_of_derivation = 24.0F;

Table table_of(const Session& session, TableKind kind)
{
    if (!is_result(kind)) return data_table(session.model(), kind, session.manner());
    const auto& results = session.solution().results;
    if (session.why_no_results() || results->n_cases() == 0) return {};
    const std::vector<femoop::CaseId> chosen = envelope_cases(session.model(), session.results_view());
    return result_table({session.model(), *results, session.view.load_case, chosen}, kind, session.manner());
}

// Where an envelope is chosen, its values stand for those of one case.
TableKind shown_kind(const Session& session, TableKind kind)
{
    if (!session.view.is_envelope || session.shows_train_envelope()) return kind;
    if (kind == TableKind::Extremes) return TableKind::Envelope;
    return kind == TableKind::Reactions ? TableKind::ReactionEnvelope : kind;
}

bool have_same_headings(const Table& a, const Table& b)
{
    const auto label = [](const Heading& heading) { return heading.column.label(); };
    return std::ranges::equal(a.headings, b.headings, {}, label, label);
}

/// Where nothing is derived, and nothing can be chosen (as in another tab), the bar and the sentence that says so.
float height_of_sentence(const DerivationShow& show, const ui::Catalogue& tr)
{
    const float em = ImGui::GetFontSize();
    const float width = ImGui::GetContentRegionAvail().x - 1.2F * em;
    const std::string sentence = tr(*show.why_none());
    return ImGui::GetFrameHeight() + ImGui::CalcTextSize(sentence.c_str(), nullptr, false, width).y +
           (1.2F + ui::splitter_ems) * em;
}

ui::Message why_no_table(const Session& session)
{
    return session.why_no_results().value_or(ui::Message(translatable("The model has no load case.")));
}

} // namespace

// ---- what is shown ----

float TablesPanel::height(const Workspace& workspace, float room) const
{
    if (!workspace.bottom.is_open) return 0.0F;
    float least = 0.0F;
    if (workspace.bottom.content == BottomContent::Member) least = least_height_of_diagrams;
    if (workspace.bottom.content == BottomContent::Solver) least = least_height_of_solver;
    if (workspace.bottom.content == BottomContent::Derivation) least = least_height_of_derivation;
    const float height = std::max(height_, least);
    const bool is_beside_drawing = workspace.bottom.content ==
                                   BottomContent::Derivation; // which goes on being looked at
    const float most = std::min(height * ImGui::GetFontSize(), (is_beside_drawing ? 0.5F : 0.7F) * room);
    const DerivationShow& derived = workspace.derivation;
    const bool is_sentence = is_beside_drawing && derived.why_none() && derived.n_steps() == 0 &&
                             derived.choices().empty();
    return is_sentence ? std::min(most, height_of_sentence(derived, workspace.session.view.tr)) : most;
}

void TablesPanel::follow(const Workspace& workspace)
{
    const Session& session = workspace.session;
    const TableKind kind = shown_kind(session, workspace.bottom.table);
    const std::string now = std::to_string(session.number()) + ' ' +
                            std::to_string(static_cast<int>(session.model().analysis)) + ' ' +
                            std::to_string(session.generation()) + ' ' + std::to_string(session.view.load_case.index) +
                            ' ' + std::string(code(session.units().system())) + ' ' + session.view.unit_choices.text() +
                            ' ' + std::string(code(session.view.tr.language())) + ' ' +
                            std::to_string(static_cast<int>(kind)) + (session.hidden ? " hidden " : " ") +
                            envelope_text(session.model(), session.results_view());
    const bool is_other = kind_ != kind || session_ != session.number();
    if (is_other) {
        grid_.reset();
        message_.clear();
        chosen_ = {};
    }
    kind_ = kind;
    session_ = session.number();
    if (now == made_for_) return;
    made_for_ = now;
    const Table before = std::exchange(table_, table_of(session, kind_));
    if (table_.headings.empty()) return;
    const std::vector<std::size_t> order = grid_.order();
    grid_.follow(table_, can_grow(kind_));
    if (!is_other && !is_result(kind_) && have_same_headings(before, table_))
        have_rows_come_back_ = grid_.keep_places(before, order, table_);
}

// What is selected elsewhere is gone to.
void TablesPanel::follow_selection(const Workspace& workspace)
{
    const Selection& selection = workspace.session.selection;
    if (selection == chosen_) return;
    chosen_ = selection;
    if (selection.is_empty()) return;
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
        if (table_.rows[i].part != selection.parts().front()) continue;
        grid_.go_to(i);
        return;
    }
}

// What is opened has the keyboard, though the click on a menu took it away.
void TablesPanel::grab_keyboard_if_opened(Workspace& workspace)
{
    const std::pair now{workspace.bottom.content, workspace.bottom.table};
    const bool is_other = std::exchange(shown_, now) != now;
    const bool is_asked = std::exchange(workspace.bottom.asks_for_keyboard, false);
    if (!std::exchange(was_open_, true) || is_other || is_asked) has_keyboard_ = true;
}

void TablesPanel::go_to_wanted(Workspace& workspace)
{
    const std::optional<WantedCell> wanted = std::exchange(workspace.bottom.wanted, std::nullopt);
    if (!wanted) return;
    has_keyboard_ = true;
    chosen_ = workspace.session.selection; // which would be gone to
    const auto row = std::ranges::find(table_.rows, std::optional(wanted->row), &Row::part);
    if (row != table_.rows.end()) grid_.go_to(static_cast<std::size_t>(row - table_.rows.begin()), wanted->column);
}

void TablesPanel::show(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui,
                       const ui::Fonts& fonts)
{
    const float em = ImGui::GetFontSize();
    show_splitter(ImGui::GetWindowHeight());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.6F * em, 0.3F * em});
    ImGui::BeginChild("###tables", {0.0F, 0.0F}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.4F * em, 0.3F * em});
    if (is_table_or_member(workspace.bottom.content)) show_tabs(workspace);
    settle_before_leaving(workspace);
    follow(workspace);
    grab_keyboard_if_opened(workspace);
    go_to_wanted(workspace);
    switch (workspace.bottom.content) {
    case BottomContent::Table: show_table(workspace); break;
    case BottomContent::Member: member_.show(workspace, gui, fonts); break;
    case BottomContent::Solver: solver_panel(workspace, gui, fonts); break;
    case BottomContent::Derivation: derivation_panel(workspace, commands, gui, fonts); break;
    }
    const bool is_over = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                                                ImGuiHoveredFlags_AllowWhenBlockedByPopup |
                                                ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    const bool is_clicked = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (is_clicked && !is_over) {
        settle(workspace);
        if (!grid_.is_editing()) leave();
    }
    if (is_clicked && is_over && !workspace.bottom.shows(BottomContent::Table)) has_keyboard_ = true;
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void TablesPanel::leave()
{
    has_keyboard_ = false;
    lend_keyboard();
}

void TablesPanel::lend_keyboard() { ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard; }

void TablesPanel::show_splitter(float room)
{
    const float em = ImGui::GetFontSize();
    ImGui::InvisibleButton("###tables splitter", {ImGui::GetContentRegionAvail().x, ui::splitter_ems * em});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    if (!ImGui::IsItemActive()) return;
    height_ = std::clamp(height_ - ImGui::GetIO().MouseDelta.y / em, 8.0F, 0.7F * room / em);
}

void TablesPanel::show_table(Workspace& workspace)
{
    if (table_.headings.empty()) {
        const ui::Catalogue& tr = workspace.session.view.tr;
        if (!explain_no_results(workspace)) ImGui::TextWrapped("%s", tr("The model has no load case.").c_str());
        return;
    }
    if (std::exchange(have_rows_come_back_, false)) select_rows(workspace);
    follow_selection(workspace);
    const Selection& selection = workspace.session.selection;
    const auto is_selected = [&](std::size_t row) {
        return table_.rows[row].part && selection.contains(*table_.rows[row].part);
    };
    grid_.show({table_, can_grow(kind_), is_selected}, ImGui::GetTextLineHeightWithSpacing());
    if (grid_.takes_clicks()) {
        has_keyboard_ = true;
        select_rows(workspace);
    } else if (has_keyboard_ && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        select_rows(workspace);
    }
    if (const auto edit = grid_.apply_edit()) carry_out(workspace, *edit);
    point_at_number(workspace);
    show_footer(workspace.session);
}

std::optional<femoop::MovingEffect> TablesPanel::number_in(
    const std::optional<std::pair<std::size_t, std::size_t>>& cell) const
{
    return cell ? table_.rows[cell->first].cells[cell->second].number : std::nullopt;
}

// Where an envelope is shown a table's number is still of one case.
std::optional<femoop::CaseId> TablesPanel::case_in(std::pair<std::size_t, std::size_t> cell,
                                                   const Session& session) const
{
    if (const auto of = table_.rows[cell.first].cells[cell.second].of_case) return of;
    return session.view.is_envelope ? std::optional(session.view.load_case) : std::nullopt;
}

// The number under the mouse, else, where the table has the keyboard, the one at its cursor.
void TablesPanel::point_at_number(Workspace& workspace)
{
    const auto under_mouse = number_in(grid_.cell_under_mouse());
    const auto point_at = [&](const std::optional<std::pair<std::size_t, std::size_t>>& cell) {
        workspace.pointed_number.reset();
        if (const auto number = number_in(cell))
            workspace.pointed_number = {.effect = *number, .of = case_in(*cell, workspace.session)};
    };
    if (under_mouse) point_at(grid_.cell_under_mouse());
    else if (has_keyboard_ && !workspace.pointed_number) point_at(grid_.cell_of_cursor());
    if (!under_mouse || !ImGui::IsMouseReleased(ImGuiMouseButton_Right)) return;
    has_keyboard_ = true;
    grid_.go_to_mouse();
    select_rows(workspace);
    workspace.menu_number = workspace.pointed_number;
    workspace.requests.push_back(Request::ContextMenu);
}

void TablesPanel::show_footer(const Session& session) const
{
    const ui::Catalogue& tr = session.view.tr;
    if (!message_.empty()) {
        const ui::Color red = ui::Theme(session.view.theme)[ui::Role::Error].text;
        ImGui::TextColored(ImColor(red.r, red.g, red.b), "%s", message_.c_str());
        return;
    }
    std::string text = tr(
        "Type to change a cell: 25 kN/m, 2*3.5, 1/3. New rows at the end, or pasted from a spreadsheet.");
    if (is_envelope(kind_)) text = envelope_text(session.model(), session.results_view());
    else if (is_result(kind_)) text = tr("Case {case}", {{"case", session.model().case_name(session.view.load_case)}});
    ImGui::TextDisabled("%s", text.c_str());
}

void TablesPanel::select_rows(Workspace& workspace)
{
    Selection selection;
    for (const std::size_t row : grid_.block().rows) {
        if (table_.rows[row].part) selection.add(*table_.rows[row].part);
    }
    workspace.session.selection = chosen_ = selection;
}

// ---- keyboard ----

ui::Input TablesPanel::handle_input(Workspace& workspace, const ui::Input& input)
{
    if (!workspace.bottom.is_open) {
        if (std::exchange(was_open_, false)) leave();
        return input;
    }
    settle_before_leaving(workspace);
    grab_keyboard_if_opened(workspace);
    if (!has_keyboard_ && workspace.bottom.shows(BottomContent::Derivation))
        return take_presenter_keys(workspace, input);
    if (!has_keyboard_ || (table_.headings.empty() && workspace.bottom.shows(BottomContent::Table))) return input;
    ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard; // the arrows are the table's
    ui::Input rest = input;
    rest.keys.clear();
    if (workspace.bottom.shows(BottomContent::Table)) follow(workspace);
    for (const ui::KeyEvent& event : input.keys) {
        const bool is_taken = event.is_down && handle_key(workspace, event.chord());
        if (!is_taken) rest.keys.push_back(event);
    }
    const bool is_typed = has_keyboard_ && !input.modifiers.ctrl && workspace.bottom.shows(BottomContent::Table);
    if (is_typed && !table_.headings.empty()) {
        grid_.type(input.text, table_);
        rest.text.clear();
    }
    return rest;
}

void TablesPanel::settle(Workspace& workspace)
{
    grid_.settle();
    if (const auto edit = grid_.apply_edit()) carry_out(workspace, *edit);
}

// To another table one goes with what was typed into this one, and not at all where that is refused.
void TablesPanel::settle_before_leaving(Workspace& workspace)
{
    const bool stays = shown_kind(workspace.session, workspace.bottom.table) == kind_ &&
                       workspace.bottom.shows(BottomContent::Table);
    if (!grid_.is_editing() || stays) return;
    const auto wanted = workspace.bottom;
    workspace.bottom.table = kind_;
    workspace.bottom.content = BottomContent::Table;
    settle(workspace);
    if (!grid_.is_editing()) workspace.bottom = wanted;
}

// While the hand is at the drawing the class is led on all the same.
ui::Input TablesPanel::take_presenter_keys(Workspace& workspace, const ui::Input& input)
{
    if (ImGui::GetIO().WantTextInput) return input;
    ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard; // PageDown would scroll the panels
    ui::Input rest = input;
    std::erase_if(rest.keys, [&](const ui::KeyEvent& event) {
        return event.is_down && workspace.bottom.is_open && handle_presenter_key(workspace, event.chord());
    });
    return rest;
}

bool TablesPanel::handle_key(Workspace& workspace, const ui::Chord& chord)
{
    if (workspace.bottom.content == BottomContent::Member)
        return chord.key == Key::Escape || member_.handle_key(workspace.session, chord);
    if (workspace.bottom.content == BottomContent::Solver) return handle_solver_key(workspace, chord);
    if (workspace.bottom.content == BottomContent::Derivation) return handle_derivation_key(workspace, chord);
    follow(workspace); // the key before may have changed the document
    if (table_.headings.empty()) return false;
    if (grid_.handle_key(chord, table_)) {
        if (const auto edit = grid_.apply_edit()) carry_out(workspace, *edit);
        else if (!grid_.is_editing()) select_rows(workspace);
        if (chord.key == Key::Escape) message_.clear();
        return true;
    }
    if (grid_.is_editing()) return false;
    const bool is_about_number = chord == ui::Chord{Key::W, {}} || chord == ui::Chord{Key::W, ui::shift};
    if (is_about_number && is_result(kind_)) return false; // asked after, released, or refused with the reason
    if (chord == ui::Chord{Key::C, ui::ctrl}) copy(workspace);
    else if (chord == ui::Chord{Key::V, ui::ctrl}) paste(workspace);
    else if (chord == ui::Chord{Key::Delete, {}} && can_grow(kind_) && grid_.has_whole_rows(table_))
        remove_rows(workspace);
    else if (chord == ui::Chord{Key::Delete, {}} || chord == ui::Chord{Key::Backspace, {}}) clear_block(workspace);
    else return !chord.modifiers.ctrl && !ui::is_function_key(chord.key);
    return true;
}

std::optional<std::string> TablesPanel::cell(const Workspace& workspace) const
{
    if (!workspace.bottom.shows(BottomContent::Table) || table_.headings.empty()) return std::nullopt;
    const std::size_t row = grid_.first_row();
    const std::string name = row < grid_.order().size() ? table_.rows[grid_.order()[row]].cells.front().value.shown
                                                        : "new";
    return ui::Catalogue()(title(kind_)) + ": " + name + ", " + table_.headings[grid_.column()].column.label();
}

// ---- files ----

void TablesPanel::ask_for_file(const Workspace& workspace)
{
    std::filesystem::path start = workspace.session.path().value_or("table.json");
    start.replace_extension();
    const std::string name = start.filename().string() + " " +
                             workspace.session.view.tr(title(workspace.bottom.table)) + ".csv";
    path_dialog_.open(ui::PathDialog::Purpose::Save, std::filesystem::absolute(start).replace_filename(name), ".csv");
}

void TablesPanel::show_dialog(Workspace& workspace)
{
    const auto path = path_dialog_.show(workspace.session.view.tr);
    if (!path) return;
    if (const auto reason = export_to(workspace, *path)) workspace.session.notice = Notice{ui::lasting(*reason)};
}

std::optional<ui::Message> TablesPanel::export_to(const Workspace& workspace, const std::filesystem::path& path)
{
    const Table table = table_of(workspace.session, shown_kind(workspace.session, workspace.bottom.table));
    const ui::Message::Argument file{"file", path.filename().string()};
    if (table.headings.empty()) return why_no_table(workspace.session);
    if (!files::write_whole_file(path, csv(table, workspace.session.units().format().mark))) return std::nullopt;
    return ui::Message(translatable("{file} was not saved"), {file});
}

} // namespace frame
