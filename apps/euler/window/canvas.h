#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "apps/euler/session/commands.h"
#include "apps/euler/view/planar/planar_shapes.h"
#include "apps/euler/view/shapes/shapes.h"
#include "topology/geometry/point.h"
#include "ui/app/canvas.h"

namespace euler {

/// The picture in the middle of the window: it shows the solids, is moved by the mouse, and says what lies under the
/// pointer. A click selects, or gives the operator that asks its next argument.
///
///     wheel: zoom to the cursor      left button: orbit      middle or right button, or Shift and the left: pan
///     double click on nothing: show everything
class Canvas : public ui::Canvas {
public:
    using ui::Canvas::Canvas;

    /// Fills what is left of the current window of Dear ImGui's.
    void show(Session& session, ui::ImGuiSession& gui);
    void zoom(Session& session, double factor) const;
    static void look(Session& session, ui::StandardView view);

    /// Where an entity of a solid lies in the window [logical pixels]; nothing where it is not to be seen.
    std::optional<ui::Point> in_window(const Part& part) const;
    /// Where a place in space lies.
    ui::Point in_window(const Session& session, const topology::Point& place) const;
    /// The solids as they are seen now, without what the pointer does.
    ui::Picture picture_of(const Session& session);

private:
    void follow(Session& session);
    void move_camera(Session& session);
    void click(Session& session, const std::optional<Part>& under) const;
    void notify(const Session& session) const;
    void draw_line(Session& session);
    topology::Point place_under_pointer(const Session& session) const;
    void paint_drawing(const Session& session, ui::Painter& painter) const;
    void fit(Session& session);
    void follow_room(Session& session);
    void give_room_to_draw(Session& session);
    void fit_view(Session& session);
    Shapes shapes_of(const Session& session, std::span<const Subject> subjects);
    PlanarMap map_of(const Session& session, std::span<const Subject> subjects);
    void follow_shapes(const Session& session, std::span<const Subject> subjects);
    void repaint(const Session& session);

    using Solids = std::vector<std::shared_ptr<const topology::Solid>>;
    static Solids solids_of(std::span<const Snapshot> snapshots);
    /// A map that is kept as long as its solids are the same: to find places takes a while.
    class Map {
    public:
        const PlanarMap& of(const Solids& solids, std::span<const Subject> subjects);

    private:
        PlanarMap map_;
        Solids solids_;
    };
    /// All that the places of what is seen depend on.
    struct ViewTransform {
        Solids solids;
        std::vector<double> progress; ///< of the step, by solid
        std::uint64_t generation = 0;
        ViewKind view{};
        ui::OrbitCamera eye, map_eye;
        ui::PlaneCamera polygon_eye;
        double explosion = 0.0, size = 0.0;
        bool has_faces = false;
        ui::ThemeName theme{};
        ui::Language language{};

        friend bool operator==(const ViewTransform&, const ViewTransform&) = default;
    };
    /// All that the picture depends on.
    struct Painting {
        ViewTransform transform;
        std::vector<Marks> marks; ///< by solid
        std::set<topology::EntityKind> names;
        bool has_hatching = false, has_half_edges = false;
        ui::Size sheet{};

        friend bool operator==(const Painting&, const Painting&) = default;
    };
    Painting painting_of(const Session& session, std::span<const Subject> subjects) const;
    static ViewTransform transform_of(const Session& session, std::span<const Subject> subjects);
    /// All that the fitted camera depends on, and the camera.
    struct Fitting {
        Solids now, at_end;
        ui::Size sheet{};
        ViewKind view{};
        double explosion = 0.0;
        double way = 1.0; ///< of a step
        ui::OrbitCamera eye, map_eye;
        ui::PlaneCamera polygon_eye;

        friend bool operator==(const Fitting&, const Fitting&) = default;
    };
    Fitting fitting_of(const Session& session) const;

    Shapes shapes_;                                            ///< drawn last
    std::optional<ViewTransform> seen_;                        ///< that the shapes belong to
    std::optional<Painting> painted_;                          ///< that the picture shows; none of one that is drawn on
    std::optional<Fitting> fitted_;                            ///< last
    ui::Size room_ = sheet();                                  ///< that the views were moved in
    Map map_, other_map_;                                      ///< of what is drawn, and of the other end of a step
    std::optional<topology::Point> line_start_{}, line_end_{}; ///< of a line that is being drawn
};

/// "vertex v1", in the language of the session.
std::string describe(const Session& session, const Part& part);

} // namespace euler
