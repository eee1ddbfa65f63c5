#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/cross/session/session.h"
#include "apps/cross/view/scene.h"
#include "ui/paint/geometry.h"
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
    /// Likewise where no panel is seen: at the foot of the picture, with what is asked. \param picture  in the window
    void show_at_foot(Session& session, const ui::Box& picture, float scale);
    bool is_half_typed() const { return cell_ && text_ != written_; }
    /// Has the keyboard, and was not typed into since it was opened.
    bool is_untouched() const { return cell_ && has_keyboard_ && !was_typed_into_; }

private:
    void follow(Session& session);
    enum class Place : std::uint8_t { Sheet, Panel, Foot };
    void edit(Session& session, Place place);
    void edit_at(Session& session, Place place, ui::Point middle, float width);
    void drop_reason(Session& session);
    bool confirm(Session& session, femoop::cross::BlankId cell);

    std::optional<femoop::cross::BlankId> cell_;
    std::string text_, written_, reason_; ///< why the text was not taken
    Place place_ = Place::Sheet;          ///< where it was last: it may have left the picture with its cell
    int n_openings_ = 0;
    bool is_fresh_ = false, has_keyboard_ = false, was_typed_into_ = false;
    std::size_t of_ = 0; ///< solution: of another exercise
    bool was_told_ = true;
    ui::KeyboardBack keyboard_;
};

/// Whether the sheet shows the cell that is being filled.
bool is_drawn(const Session& session, const Drawn& drawn);

} // namespace cross
