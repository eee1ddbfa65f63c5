#pragma once

#include <optional>
#include <string>

#include "apps/cross/session/session.h"
#include "ui/widgets/keyboard_back.h"

namespace cross {

/// The field in which a pupil types the number of a cell, on the sheet itself: Enter and Tab go to the next cell,
/// Shift+Tab to the one before, Esc leaves the cell as it was. What is no number stays in the field, and so does what is
/// half typed when a click goes elsewhere than into another cell.
class CellField {
public:
    /// \param corner  of the picture in the window, \param scale  physical pixels of a logical one
    void show(Session& session, const Drawn& drawn, ui::Point corner, float scale);
    /// For a cell that has no room on the sheet: where the cursor of Dear ImGui's is.
    void show_here(Session& session);
    bool is_half_typed() const { return cell_ && text_ != written_; }

private:
    void follow(Session& session);
    void edit(Session& session);
    void drop_reason(Session& session);
    bool take(Session& session, femoop::cross::BlankId cell);

    std::optional<femoop::cross::BlankId> cell_;
    std::string text_, written_, reason_; ///< why the text was not taken
    int n_openings_ = 0;
    bool is_fresh_ = false;
    std::size_t of_ = 0; ///< solution: of another exercise
    bool was_told_ = true;
    ui::KeyboardBack keyboard_;
};

/// Whether the sheet shows the cell that is being filled.
bool is_drawn(const Session& session, const Drawn& drawn);

} // namespace cross
