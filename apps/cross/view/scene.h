#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "apps/cross/document/solution.h"
#include "apps/cross/view/bay_scale.h"
#include "apps/cross/view/look.h"
#include "apps/cross/view/worksheet.h"
#include "apps/drawing/sketch/sketch.h"
#include "ui/canvas/plane_camera.h"
#include "ui/paint/painter.h"

namespace cross {

/// All that a picture is drawn from.
struct Scene {
    const Document& document;
    const Solution& solution;
    const femoop::Results* state = nullptr; ///< of the present locks; null where there is no task
    double phase = 1.0;                     ///< how much of the last turn is done: 1 at rest
    std::optional<femoop::cross::JointId> hover;
    const Look& look;
    const Worksheet* worksheet = nullptr;         ///< that a pupil fills; null: the app works the sheet
    std::optional<femoop::cross::BlankId> cell{}; ///< that is being filled
    std::size_t worksheet_stage = 0;              ///< the sheet of the paper that is seen
};

/// The four pictures.
enum class Part : std::uint8_t { Structure, Deformed, Moments, Sheet };

/// Where a joint stands in one of them.
struct JointMark {
    femoop::cross::JointId joint;
    Part part;
    ui::Point at;
};

/// A node in the picture of the structure.
struct NodeMark {
    femoop::NodeId node;
    ui::Point at;
};

/// A cell of a pupil's sheet.
struct CellMark {
    femoop::cross::BlankId cell;
    ui::Box box;
};

/// A string and where it was written, so that a hand can choose what it says.
struct WrittenText {
    std::string text;
    ui::Box box;
    ui::Color color;
};

/// What a picture shows, for a hand.
struct Drawn {
    std::vector<CellMark> cells;
    /// How far the pictures are to be moved along so that the cell that is being filled is seen whole; nothing where
    /// it is, or has no place.
    std::optional<ui::Point> way_to_cell;
    std::optional<ui::Point> way_to_turn; ///< likewise the columns of an enlarged sheet's last turn, or its next
    double sheet_type = 0.0;              ///< size of the numbers of the sheet that the app works
    std::size_t n_without_room = 0;       ///< member ends whose columns are left out of it
    std::vector<JointMark> joints;
    std::vector<NodeMark> nodes;
    std::vector<drawing::LoadMark> loads;
    std::vector<WrittenText> texts; ///< of the structure's picture
    ui::Point corner;               ///< of the structure's picture
    ui::PlaneCamera camera;         ///< within it

    /// One of the pictures, for a hand that zooms.
    struct View {
        ui::Box box;
        ui::PlaneCamera camera;
        double stretch = 1.0;
        BayScale bays, storeys;

        /// In lengths as the picture has them, which need not be the structure's.
        Eigen::Vector2d drawn_at(ui::Point at) const;
        Eigen::Vector2d drawn(Eigen::Vector2d place) const { return {bays(place.x()), storeys(place.y())}; }
        Eigen::Vector2d place(Eigen::Vector2d drawn) const
        {
            return {bays.inverse(drawn.x()), storeys.inverse(drawn.y())};
        }
        Zoom drawn(const Zoom& zoom) const;
        Zoom place(const Zoom& zoom) const;
    };
    Zoom zoom;                                        ///< as far as there is something to see
    std::vector<View> views;                          ///< the structure's first
    Eigen::Vector2d middle = Eigen::Vector2d::Zero(); ///< of the structure

    /// The place of the structure that is shown there; nothing beside the pictures.
    std::optional<Eigen::Vector2d> place_at(ui::Point at) const;
    /// A hand zooms at a place, or moves the pictures along: what lies under it stays under it. Nothing beside them.
    std::optional<Zoom> zoomed_at(const Zoom& zoom, ui::Point at, double factor) const;
    std::optional<Zoom> moved_along(const Zoom& zoom, ui::Point from, ui::Point to) const;
    const View* view_at(ui::Point at) const; ///< null beside the pictures
    bool is_in_structure(ui::Point at) const { return !views.empty() && views.front().box.contains(at); }
    ui::Point on_sheet(ui::World2 place) const { return corner + camera.to_sheet(place); }
    ui::World2 in_structure(ui::Point at) const { return camera.to_world(at - corner); }
};

/// Draws structure, deformed shape, moments and calculation sheet on the painter's whole sheet: below one another for
/// a beam, so that everything stands below its support; beside one another for a frame. Where the structure cannot be
/// distributed it says why.
Drawn draw(ui::Painter& painter, const Scene& scene);

/// How much larger than the whole structure its sheet is to be drawn so that every column has room, on the projector in
/// type that the last row reads; 1 for a frame at a desk.
double legible_zoom(ui::Painter& painter, const Scene& scene);

/// The node of the structure's picture, the joint of any picture within reach of a place [logical pixels].
std::optional<femoop::NodeId> pick_node(const Drawn& drawn, ui::Point at, double reach);
std::optional<femoop::cross::JointId> pick(const Drawn& drawn, ui::Point at, double reach);
/// The cell of a pupil's sheet that is there.
std::optional<femoop::cross::BlankId> pick_cell(const Drawn& drawn, ui::Point at);
/// Whether a load's arrows are there, or its value. Where a moment acts is its node's, and its arc alone the moment's.
bool is_within(const drawing::LoadMark& mark, ui::Point at);
/// The load whose arrows are there; null where there is none.
const drawing::LoadMark* pick_load(const Drawn& drawn, ui::Point at);

} // namespace cross
