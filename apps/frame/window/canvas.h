#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "apps/drawing/pick.h"
#include "apps/drawing/sheet/subject.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/session/commands.h"
#include "apps/frame/window/aim.h"
#include "ui/app/canvas.h"

namespace frame {

/// The picture in the middle of the window: it shows the session's model, is moved and zoomed by the mouse, and says
/// what lies under the pointer. What the left button does is the tool's in the hand.
///
///     wheel: zoom to the cursor      middle or right button, or the space bar held: pan
///     left button in space: orbit    double click on nothing: show the whole model
///     with Shift in space: a window that selects
///     double click on a load, a node, a dimension: its first number is typed in the panel of properties
///     right click: the menu of what lies there
class Canvas : public ui::Canvas {
public:
    using ui::Canvas::Canvas;

    /// Fills what is left of the current window of Dear ImGui's.
    void show(Workspace& workspace, ui::ImGuiSession& gui);

    /// From now on the camera follows the sheet and the structure, until it is moved by hand.
    void fit(Session& session);
    void zoom(Session& session, double factor) const;
    /// What is looked at where the camera was moved by hand, in the plane; nothing: the whole model.
    std::optional<Region> region(const Session& session) const;

    /// Where something of the model lies in the window [logical pixels]; nothing before the first frame.
    std::optional<ui::Point> in_window(const Eigen::Vector3d& place) const;
    std::optional<ui::Point> in_window(const Cut& cut) const;
    /// The structure as it is seen now, without what the hand is doing.
    ui::Picture picture_of(const Workspace& workspace) const;
    /// A load, a node or a dimension was double clicked: its first number is to be typed. Said once.
    bool takes_number() { return std::exchange(takes_number_, false); }

private:
    void follow(Workspace& workspace, const Pointer& pointer);
    Work work_in_hand(Session& session) const;
    void work(Workspace& workspace, const Aim& aim, const Pick& under);
    void press(Workspace& workspace, const Aim& aim);
    static void ask_at_diagram(Workspace& workspace, Aim aim);
    void release(Workspace& workspace, const Aim& aim, const Pick& under);
    void click_in_space(Workspace& workspace, const Aim& aim, const Pick& under);
    static void ask_for_menu(Workspace& workspace, const Aim& aim);
    void move_camera(Session& session);
    void paint_all(const Workspace& workspace, ui::Painter& painter);
    Subject::Picture draw(const Workspace& workspace, const DrawOptions& options, const DrawState& state,
                          ui::Painter& painter) const;
    DrawState state(const Workspace& workspace) const;
    DrawOptions seen_options(const Workspace& workspace) const;
    struct SeenCut {
        Cut cut;
        ui::Point panel; ///< corner of the panel that it is seen in
    };
    void draw_cut(const Session& session, const DrawOptions& options, const Subject::Picture& picture,
                  const SeenCut& seen, ui::Painter& painter) const;
    void ask_at_envelope(Workspace& workspace, const Cut& section);
    /// The panel of a diagram of forces that lies there; null where none does.
    const Panel* diagram_at(ui::Point at) const;
    void point_at_diagram(Session& session, const Panel& panel, ui::Point at);
    void look_at_region(Workspace& workspace);
    void follow_structure(Workspace& workspace);
    bool is_all_in_sight(const Workspace& workspace) const;
    /// The panel of the sheet under a point, the first one where there is none.
    Projection projection_at(ui::Point at) const;
    double pixels_along(const Projection& projection, const Cut& cut) const;
    ui::Point corner_of_panel(ui::Point at) const;

    double lent_ = 0.0; ///< of the sheet's height to what is told at the window's foot, which must not move the picture
    /// What the fitted camera was made for: it is made anew when one of these changes, and not when a part, a load or
    /// what is shown does, so that the picture rests under the hand.
    struct FittedFor {
        std::uint64_t session;
        ui::Size sheet;
        Layout layout;
        ui::ThemeName theme;
        bool is_in_space;
        bool has_pencil;               ///< a guess needs room beside the structure
        bool has_line;                 ///< what it took gives its room back when it is closed
        bool has_train;                ///< a train on it needs room for its forces and its curve
        std::size_t free_body;         ///< and each free body for its forces: its number, 0 where none is lifted
        std::size_t funicular;         ///< likewise
        std::size_t work;              ///< likewise
        bool has_diagram;              ///< of forces, which takes half the sheet
        std::size_t n_lines;           ///< that are kept, each in a panel
        std::array<double, 3> factors; ///< of diagrams, loads and symbols: what shrinks gives its room back
        double lent;                   ///< height that a notice took of the sheet: it comes back with it

        bool serves(const FittedFor& wanted) const;
    };
    FittedFor wanted_fit(const Session& session, const DrawOptions& options) const;
    ui::Size whole_sheet() const { return {sheet().width, sheet().height + lent_}; }
    void fit_new_body(Session& session);
    void hold_still(Session& session, const Subject::Plan& before);

    StructureShape shape_;
    Subject::Plan plan_;            ///< how the sheet is divided, and the camera of its panels
    std::size_t body_in_sight_ = 0; ///< the number of the free body that was last looked for
    /// For which a camera by hand was fitted, and what it was before.
    struct FittedForBody {
        ui::OrbitCamera before, fitted;
    };
    std::optional<FittedForBody> fitted_for_body_;
    std::optional<FittedFor> fitted_for_;
    std::uint64_t session_ = 0, generation_ = 0; ///< that shape_ belongs to
    ui::Point hover_panel_{};                    ///< corner of the panel that the pointer is in
    Subject::Picture drawn_;                     ///< last
    bool was_whole_ = false;                     ///< the picture that the camera was fitted for
    bool is_just_fitted_ = false;
    bool is_working_ = false; ///< the left button was pressed in the picture and is held
    bool takes_number_ = false;
};

} // namespace frame
