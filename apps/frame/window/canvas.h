#pragma once

#include <optional>
#include <vector>

#include "apps/frame/session/commands.h"
#include "apps/frame/view/pick.h"
#include "apps/frame/view/sheet/subject.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/painter.h"
#include "ui/paint/picture.h"

namespace frame {

/// The picture in the middle of the window: it shows the session's model, is moved and zoomed by the mouse, and says
/// what lies under the pointer. It changes camera, hover, selection and pin alone.
///
///     wheel: zoom to the cursor      drag: pan, in space orbit      middle or right button, or Shift: pan
///     click: select, read a cut      double click on nothing: show the whole model
class Canvas {
public:
    explicit Canvas(const ui::Fonts& fonts) : fonts_(fonts) {}

    /// Fills what is left of the current window of Dear ImGui's.
    void show(Desk& desk, ui::ImGuiSession& gui);

    /// From now on the camera follows the sheet and the structure, until it is moved by hand.
    void fit(Session& session);
    void zoom(Session& session, double factor) const;

    /// Where something of the model lies in the window [logical pixels]; nothing before the first frame.
    std::optional<ui::Point> in_window(const Eigen::Vector3d& place) const;
    std::optional<ui::Point> in_window(const Cut& cut) const;
    /// The picture that was drawn last, for golden texts.
    const std::optional<ui::Picture>& picture() const { return picture_; }

private:
    struct Pointer {
        ui::Point at; ///< on the sheet
        bool is_over = false;
    };

    void follow(Desk& desk, const Pointer& pointer);
    void press(Session& session, const Pick& under);
    void move(Session& session);
    void paint(const Session& session);
    void follow_structure(const Session& session);
    /// The panel of the sheet under a point, the first one where there is none.
    Projection projection_at(ui::Point at) const;
    double pixels_along(const Projection& projection, const Cut& cut) const;
    ui::Point corner_of_panel(ui::Point at) const;

    const ui::Fonts& fonts_;
    ui::Size sheet_{};
    ui::Point corner_{}; ///< of the sheet in the window [logical pixels]
    /// What the fitted camera was made for: it is made anew when one of these changes, and not when a load does, so
    /// that the picture rests while a number is dragged.
    struct FittedFor {
        ui::Size sheet;
        ShowSet show;
        Layout layout;
        ui::ThemeName theme;
        std::vector<Eigen::Vector3d> nodes;
        femoop::AnalysisKind kind;
        std::optional<std::size_t> mechanism;

        friend bool operator==(const FittedFor&, const FittedFor&) = default;
    };

    StructureShape shape_;
    Subject::Plan plan_; ///< how the sheet is divided, and the camera of its panels
    std::optional<FittedFor> fitted_for_;
    std::uint64_t generation_ = 0; ///< that shape_ belongs to
    std::optional<ui::Picture> picture_;
    ui::Point hover_panel_{}; ///< corner of the panel that the pointer is in
    bool is_panning_ = false;
};

} // namespace frame
