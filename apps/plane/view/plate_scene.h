#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/sketch/sketch.h"
#include "apps/plane/view/plate_outline.h"
#include "apps/plane/view/plate_picture.h"

namespace plane {

/// What every part of a picture of a plane model is drawn from.
struct PlateScene {
    const PlateInput& input;
    const PlateOptions& options;
    const PlateState& state;
    const PlateOutline& outline;
    const ui::PlaneCamera& camera;
    const ui::DisplayUnits& units;
    drawing::Sketch& sketch;
    const femoop::plane::PlaneModel* mesh = nullptr;  ///< null where there is none
    const femoop::plane::PlaneCase* result = nullptr; ///< likewise
    const PlaceLine* places = nullptr;                ///< of the mesh's points where they are drawn
    double magnification = 0.0;                       ///< of displacements where they are drawn; 0: the body at rest

    const femoop::plane::PlaneModel& model() const { return input.model; }
    /// Bands or errors fill the body.
    bool is_colored() const;
    bool shows(PlateShow item) const { return options.show.set.contains(item); }
    ui::Point place(const Eigen::Vector2d& at) const { return camera.to_sheet({at.x(), at.y()}); }
    /// A direction of the model on the sheet, of the same length.
    static ui::Point direction(const Eigen::Vector2d& d) { return {d.x(), -d.y()}; }
    std::vector<ui::Point> on_sheet(const PlaceLine& line) const;
    void shade_faces() const; ///< labels have a ground of their own there
    /// With a true minus sign and its unit.
    std::string text(double value, ui::Measure measure) const;
    std::string number(double value) const;
};

/// The mesh that is drawn and solved; null where there is none.
const femoop::plane::PlaneModel* mesh_of(const PlateInput& input);
/// The units that numbers of a model are shown in.
ui::DisplayUnits display_units(const femoop::plane::PlaneModel& model, const PlateOptions& options);
/// "plane stress  ·  load case P  ·  units kN, m"
std::string state_and_case(const femoop::plane::PlaneModel& model, const PlateOptions& options);
/// "plane stress  ·  mode 2: 12.3 Hz, period 0.0813 s, 45.1 % of the mass along x, 0 % along y  ·  units kN, m"
/// \pre a mode is shown
std::string state_and_mode(const PlateInput& input, const PlateOptions& options);
/// The mode that a picture shows; null where it shows none.
const femoop::plane::NaturalMode* shown_mode(const PlateInput& input, const PlateOptions& options);
/// A frequency, a period, a share of the mass as people read them.
struct ModeTexts {
    std::string frequency, period;     ///< with their units
    std::array<std::string, 2> shares; ///< of the mass along x and along y: "45.1 %"
};
ModeTexts mode_texts(const femoop::plane::NaturalModes& modes, std::size_t i, const ui::NumberFormat& numbers);
/// The outline of the drawing, or of the mesh.
PlateOutline outline_of(const PlateInput& input, double tolerance);

} // namespace plane
