#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "apps/cross/session/drag_controller.h"
#include "apps/cross/window/cell_field.h"
#include "apps/cross/window/value_field.h"
#include "ui/app/canvas.h"

namespace cross {

/// The picture of a session, and what a hand does on it: a click on a joint balances it; in the
/// picture of the structure a hand changes it (drag_controller.h); Shift and a click, or the right button, changes what
/// holds a node; a double click on a value opens a field for it; with a tool in hand a click puts a load. While a pupil
/// fills the sheet a click chooses a cell.
class Canvas : public ui::Canvas {
public:
    using ui::Canvas::Canvas;

    /// \pre within a window of Dear ImGui's, which it fills
    /// \param has_panels  beside it, which have the field of a cell that is not drawn
    void show(Session& session, ui::ImGuiSession& gui, bool has_panels);

    /// About the pointer, else about the middle of the calculation sheet.
    void zoom(Session& session, double factor);
    CellField& cell_field() { return cell_field_; }
    const CellField& cell_field() const { return cell_field_; }
    bool is_typing_value() const { return value_field_.is_open(); } ///< on the picture
    /// The picture without what the pointer marks.
    ui::Picture picture_of(const Session& session) const;
    /// Where a joint is in the window [logical pixels]; nothing where it is not drawn.
    std::optional<ui::Point> in_window(femoop::cross::JointId joint, Part part) const;
    const Drawn& drawn() const { return drawn_; }

private:
    void redraw(Session& session);
    bool bring_into_sight(Session& session, const std::optional<ui::Point>& way) const;
    void bring_turn_into_sight(Session& session);
    bool enlarge_sheet(Session& session);
    double times_larger(const Session& session) const;
    ui::Point middle_of_interest(const Session& session) const;
    void follow(Session& session);
    void follow_pupil(Session& session);
    bool follow_values(Session& session);
    void put_load(Session& session, const Aim& aim);
    void press(Session& session);
    void release(Session& session);
    void move_about(Session& session);
    bool is_over_structure(ui::Point beam) const;
    void draw_hint(ui::Painter& painter, const Session& session) const;
    void draw_load_hint(ui::Painter& painter, const Session& session) const;

    Drawn drawn_;
    std::size_t drawn_of_ = 0; ///< Session::n_solved of what is drawn
    DragController drag_;
    std::optional<femoop::cross::BlankId> cell_in_sight_;     ///< that was brought into sight last
    std::optional<std::array<std::size_t, 3>> turn_in_sight_; ///< likewise: solved, sheet, turns
    /// A sheet and a window for which its numbers were enlarged, or needed not be.
    struct EnlargedFor {
        std::size_t n_solved = 0, stage = 0;
        double least_type = 0.0, width = 0.0, height = 0.0;
        friend bool operator==(const EnlargedFor&, const EnlargedFor&) = default;
    };
    std::optional<EnlargedFor> enlarged_for_;
    std::optional<femoop::cross::BlankId> pressed_cell_; ///< where the hand that is down, or was last, began
    CellField cell_field_;
    ValueField value_field_;
};

} // namespace cross
