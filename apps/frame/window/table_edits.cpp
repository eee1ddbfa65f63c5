// What is done to the cells of the panel's table: filled, pasted, cleared, rows deleted.
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "apps/frame/document/drawing.h"
#include "apps/frame/window/tables_panel.h"
#include "ui/text/catalogue.h"

namespace frame {

using ui::translatable;

namespace {

ui::Message change_label(TableKind kind) { return {translatable("Change table: {table}"), {{"table", title(kind)}}}; }

} // namespace

void TablesPanel::copy(const Workspace&) const
{
    const CellBlock block = grid_.block();
    if (block.rows.empty()) return;
    const bool is_cell = block.rows.size() == 1 && block.first_column == block.last_column;
    const tabular::Table copied = values(table_, block);
    tabular::SeparatedText cell(tabular::tabs);
    cell << copied.rows.front().cells.front();
    const std::string text = is_cell ? cell.take() : separated(copied, tabular::tabs);
    ImGui::SetClipboardText(text.c_str());
}

// One text fills the whole block.
void TablesPanel::paste(Workspace& workspace)
{
    const char* const text = ImGui::GetClipboardText();
    if (text == nullptr || is_result(kind_)) return;
    const CellBlock block = grid_.block();
    TextBlock texts = read_block(text, table_, block.first_column);
    const bool is_one = texts.size() == 1 && texts.front().size() == 1;
    if (is_one) {
        const std::vector<std::string> line(block.last_column - block.first_column + 1, texts.front().front());
        texts.assign(grid_.n_rows_of_block(), line);
    }
    fill(workspace, {grid_.first_row(), block.first_column, std::move(texts)});
}

void TablesPanel::clear_block(Workspace& workspace)
{
    const CellBlock block = grid_.block();
    if (is_result(kind_) || block.rows.empty()) return;
    const std::vector<std::string> line(block.last_column - block.first_column + 1);
    fill(workspace, {grid_.first_row(), block.first_column, TextBlock(block.rows.size(), line)});
}

void TablesPanel::remove_rows(Workspace& workspace)
{
    if (is_result(kind_)) return;
    std::vector<Part> parts;
    for (const std::size_t row : grid_.block().rows)
        if (table_.rows[row].part) parts.push_back(*table_.rows[row].part);
    const Document before = workspace.session.document();
    workspace.session.change({ui::Message(translatable("Delete rows: {table}"), {{"table", title(kind_)}}),
                              [&](Document& document) { remove(document, parts); }});
    message_.clear();
    if (!parts.empty() && workspace.session.document() == before)
        message_ = workspace.session.view.tr("what members have cannot be deleted; give them another one first");
}

// Fills cells, or says what hinders it and changes nothing.
bool TablesPanel::fill(Workspace& workspace, const GridEdit& edit)
{
    Session& session = workspace.session;
    Filled result = filled(session.document(), kind_, {edit.row, edit.column, grid_.order()}, edit.texts,
                           session.manner());
    message_.clear();
    if (!result.faults.empty()) {
        message_ = sentence(result.faults, table_, session.view.tr);
        return false;
    }
    if (result.document == session.document()) return true;
    const auto objection = session.change(
        {change_label(kind_), [&](Document& document) { document = std::move(result.document); }});
    if (objection) message_ = session.view.tr(*objection);
    return !objection;
}

// A new row is kept until it has all that it needs.
bool TablesPanel::fill_draft(Workspace& workspace, const GridEdit& edit)
{
    std::vector<std::string> line = grid_.draft;
    line[edit.column] = edit.texts.front().front();
    Filled result = filled(workspace.session.document(), kind_, {edit.row, 0, grid_.order()}, {line},
                           workspace.session.manner());
    std::erase_if(result.faults, [&](const CellFault& fault) { // what is still to be typed is no fault
        return fault.column >= line.size() || line[fault.column].empty();
    });
    if (!result.faults.empty()) {
        message_ = sentence(result.faults, table_, workspace.session.view.tr);
        return false;
    }
    grid_.draft = line;
    if (fill(workspace, {edit.row, 0, {line}})) grid_.draft.assign(line.size(), "");
    return true;
}

void TablesPanel::carry_out(Workspace& workspace, const GridEdit& edit)
{
    const bool is_new = edit.row >= table_.rows.size();
    const bool is_taken = is_new ? fill_draft(workspace, edit) : fill(workspace, edit);
    if (!is_taken) {
        grid_.reject(edit);
        return;
    }
    follow(workspace);
    grid_.accept();
    select_rows(workspace);
}

} // namespace frame
