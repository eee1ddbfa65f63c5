#include "apps/cross/window/cell_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "apps/cross/view/pupil_words.h"
#include "apps/cross/window/field_reason.h"

namespace cross {

namespace {

std::string written_in(const Session& session, femoop::cross::BlankId cell)
{
    const auto& written = session.document().pupil->written;
    return cell.index < written.size() ? written[cell.index] : "";
}

const CellMark* mark_of(const Session& session, const Drawn& drawn)
{
    const auto found = std::ranges::find_if(drawn.cells,
                                            [&](const CellMark& mark) { return mark.cell == session.cell(); });
    return found == drawn.cells.end() ? nullptr : &*found;
}

} // namespace

bool is_drawn(const Session& session, const Drawn& drawn) { return mark_of(session, drawn) != nullptr; }

void CellField::show(Session& session, const Drawn& drawn, ui::Point corner, float scale)
{
    follow(session);
    if (!cell_) return;
    const CellMark* const mark = mark_of(session, drawn);
    if (mark == nullptr) return;
    const auto factor = static_cast<double>(scale);
    const ui::Point middle = factor * (corner + mark->box.center());
    edit_at(session, Place::Sheet, middle,
            std::max(static_cast<float>(mark->box.width()) * scale, 5.0F * ImGui::GetFontSize()));
    if (cell_ && !reason_.empty()) show_reason(reason_, middle, factor * corner.x);
}

/// Into a window of Dear ImGui's [physical pixels].
void CellField::edit_at(Session& session, Place place, ui::Point middle, float width)
{
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ImGui::GetStyle().FramePadding.x, 2.0F));
    const float height = ImGui::GetFrameHeight();
    ImGui::SetCursorScreenPos(
        {static_cast<float>(middle.x) - 0.5F * width, static_cast<float>(middle.y) - 0.5F * height});
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.0F);
    edit(session, place);
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

void CellField::show_at_foot(Session& session, const ui::Box& picture, float scale)
{
    if (!cell_) return;
    const auto factor = static_cast<double>(scale), em = static_cast<double>(ImGui::GetFontSize());
    const ui::Point middle{factor * picture.center().x, factor * picture.max.y - 6.0 * em};
    const std::string asked = session.tr()(question(*session.worksheet(), session.document().model, *cell_));
    show_reason(reason_.empty() ? asked : reason_, middle, factor * picture.min.x);
    edit_at(session, Place::Foot, middle, 10.0F * ImGui::GetFontSize());
}

void CellField::show_here(Session& session)
{
    follow(session);
    if (!cell_) return;
    ImGui::SetNextItemWidth(-1.0F);
    edit(session, Place::Panel);
}

// Another cell was chosen, or what was written into this one changed, as by undo.
void CellField::follow(Session& session)
{
    if (session.worksheet() == nullptr) {
        cell_.reset();
        return;
    }
    if (std::exchange(of_, session.n_solved()) != session.n_solved()) cell_.reset();
    const bool shows_judgement = session.worksheet()->shows_judgement;
    if (!std::exchange(was_told_, shows_judgement) && shows_judgement && cell_)
        confirm(session, *cell_); // "Judge now" means it too
    if (cell_ && cell_ != session.cell()) {
        const auto next = session.cell();
        if (!confirm(session, *std::exchange(cell_, std::nullopt))) return;
        session.go_to_cell(next);
    }
    if (!session.cell()) return;
    const std::string written = written_in(session, *session.cell());
    if (cell_ == session.cell() && written == written_) return;
    cell_ = session.cell();
    text_ = written_ = written;
    reason_.clear();
    keyboard_.forget();
    ++n_openings_;
    is_fresh_ = true;
    was_typed_into_ = false;
}

void CellField::edit(Session& session, Place place)
{
    if (std::exchange(place_, place) != place) keyboard_.lose();
    if (is_fresh_) ImGui::SetKeyboardFocusHere();
    keyboard_.before_field();
    ImGui::PushID(n_openings_); // an editor of its own for each cell
    constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                                          ImGuiInputTextFlags_CallbackAlways;
    const bool is_entered = ImGui::InputText("###number", &text_, flags, ui::KeyboardBack::place_cursor, &keyboard_);
    keyboard_.after_field();
    ImGui::PopID();
    has_keyboard_ = ImGui::IsItemActive();
    was_typed_into_ |= ImGui::IsItemEdited();
    is_fresh_ = is_fresh_ && !has_keyboard_; // it takes a frame or two to get the keyboard
    const bool is_left = ImGui::IsItemDeactivated();
    const bool is_tab = (has_keyboard_ || is_left) && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab));
    if (!is_entered && !is_tab && !is_left) return;
    if (is_left && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        drop_reason(session);
        cell_.reset();
        session.go_to_cell({});
        return;
    }
    if (!is_entered && !is_tab) return keyboard_.lose(); // by a click, which judges nothing half typed
    if (!confirm(session, *cell_)) return;
    cell_.reset();
    session.go_to_cell(session.neighbour(is_tab && ImGui::GetIO().KeyShift ? -1 : 1, false));
}

/// What was told of a text that has gone goes with it.
void CellField::drop_reason(Session& session)
{
    if (!std::exchange(reason_, {}).empty()) session.notice.reset();
}

/// False, with a notice, where it is no number: the field stays.
bool CellField::confirm(Session& session, femoop::cross::BlankId cell)
{
    drop_reason(session);
    if (text_ == written_) return true;
    const auto reason = session.write(cell, text_);
    if (!reason) return true;
    session.notify(*reason);
    reason_ = session.tr()(*reason);
    session.go_to_cell(cell);
    cell_ = cell;
    ++n_openings_;
    is_fresh_ = true;
    return false;
}

} // namespace cross
