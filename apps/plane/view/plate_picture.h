#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "apps/mohr/view/scene.h"
#include "apps/plane/backdrop/backdrop.h"
#include "apps/plane/discretize/drawing.h"
#include "apps/plane/view/plate_show.h"
#include "femoop/plane/analysis/natural_modes.h"
#include "femoop/plane/analysis/plane_results.h"
#include "femoop/plane/mesh/cut.h"
#include "ui/canvas/plane_camera.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace discretize {
class ErrorCycle;
class MeshPlayer;
} // namespace discretize

namespace plane {

/// What a picture is of. All of it outlives whatever draws it.
struct PlateInput {
    const femoop::plane::PlaneModel& model;          ///< as its file gives it: a drawing, or a mesh
    const discretize::Drawing* drawing = nullptr;    ///< of the model, where it is drawn; none when null
    const femoop::plane::PlaneModel* mesh = nullptr; ///< made of the drawing; null where the model is a mesh itself
    const femoop::plane::PlaneResults* results = nullptr; ///< of the mesh or the model; null where there are none
    /// That of the case that is shown, where it is kept from picture to picture: what it has recovered need not be found
    /// again. Taken from the results when null.
    const femoop::plane::PlaneCase* result = nullptr;
    /// How the body can move without strain, of the mesh's points, the largest 1; null where it cannot.
    const std::vector<femoop::NodeVector>* motion = nullptr;
    /// How it vibrates by itself, of the mesh or the model; drawn in place of results. Null: it is not shown.
    const femoop::plane::NaturalModes* modes = nullptr;
    /// Of the drawing, half way: drawn in place of its mesh and results.
    const discretize::MeshPlayer* player = nullptr;
    /// That the mesh comes from: its curve stands below. Null: the mesh was not refined.
    const discretize::ErrorCycle* cycle = nullptr;
    /// Results that were kept, of the same case on another mesh, and of it the case: where the deformed shape is shown
    /// they stand behind these in dashes. Null: none.
    const femoop::plane::PlaneResults* kept_results = nullptr;
    const femoop::plane::PlaneCase* kept_result = nullptr;

    const Backdrop* backdrop = nullptr; ///< null: nothing lies behind the body

    bool is_compared() const { return kept_result != nullptr && results != nullptr && result != nullptr; }
};

/// What its reader chose of a picture.
struct PlateOptions {
    PlateShown show = plate_shown_by_default();
    femoop::CaseId load_case; ///< whose loads and results are drawn
    std::size_t mode = 0;     ///< that is drawn, of those of the input
    femoop::plane::StressReading reading = femoop::plane::StressReading::Smoothed; ///< or of elements, with their jumps
    std::optional<std::array<double, 2>> range{}; ///< of the colours, least first; that of the values when absent
    std::optional<double> deformation_scale{};    ///< 50 draws displacements fifty times as large
    std::vector<Eigen::Vector2d> probes{};        ///< places whose state is written beside them
    /// Of the probes the one whose values stand in a panel beside the drawing, with Mohr's circle.
    std::optional<std::size_t> circle{};
    std::vector<femoop::plane::Cut> cuts{}; ///< drawn across, with their stresses in panels of their own
    /// The body with the kept results stands at the left of the other one, to the same scales, in place of behind it.
    bool is_beside = false;
    ui::ThemeName theme = ui::ThemeName::Light;
    ui::Catalogue tr{};                    ///< language of the words
    std::optional<ui::UnitSystem> units{}; ///< the file's own when absent
    ui::UnitChoices unit_choices{};        ///< of single quantities, in place of those
    ui::NumberFormat numbers{.digits = 4}; ///< digits and decimal mark
};

/// What the cursor is over, or what is selected.
struct PlateHighlight {
    std::vector<femoop::NodeId> points{};
    std::vector<femoop::plane::CurveId> curves{};
    std::vector<std::size_t> faces{}; ///< of the drawing
};

/// What of a picture changes from one moment to the next.
struct PlateState {
    std::optional<ui::PlaneCamera> camera{}; ///< fits the sheet when absent
    PlateHighlight hover{}, selection{};
    double phase = 1.0; ///< share of the displacement that is drawn, -1 to 1: animation
    /// Scales of Mohr's circle, kept while a hand drags its probe so that it is seen to grow; that fit it when absent.
    std::optional<mohr::Frame> circle_frame{};
};

/// Draws a plane model on the painter's whole sheet, with what the options show of it: its geometry and regions, its
/// mesh, supports and loads, and where there are results what they show. What needs a mesh or results that are not
/// there is left out.
///
/// Signs  those of femoop: x right, y up, tension positive
/// \returns what head, legend and panels leave of the sheet for the body
ui::Box draw(ui::Painter& painter, const PlateInput& input, const PlateOptions& options, const PlateState& state = {});

/// The camera that shows everything: what `draw` uses when the state has none.
ui::PlaneCamera fitted_camera(const PlateInput& input, const PlateOptions& options, ui::Size sheet,
                              const ui::Fonts& fonts);

/// The scales that fit Mohr's circle of the picture; nothing where it has none.
std::optional<mohr::Frame> circle_frame(const PlateInput& input, const PlateOptions& options);

/// Where a place of the body is drawn, and the place that is drawn there: they differ where the deformed shape is shown.
/// \param phase  as in PlateState
Eigen::Vector2d drawn_place(const PlateInput& input, const PlateOptions& options, const Eigen::Vector2d& at,
                            double phase = 1.0);
Eigen::Vector2d place_at_rest(const PlateInput& input, const PlateOptions& options, const Eigen::Vector2d& drawn,
                              double phase = 1.0);

/// The sheet's colour under the options' theme.
ui::Color background(const PlateOptions& options);

} // namespace plane
