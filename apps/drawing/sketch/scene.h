#pragma once

#include "apps/drawing/draw_options.h"
#include "apps/drawing/draw_state.h"
#include "apps/drawing/geometry/level_of_detail.h"
#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/sketch/sketch.h"
#include "femoop/model/model.h"
#include "ui/text/display_units.h"

#include <cstdint>
#include <string>

namespace drawing {

/// Where a panel says the units of forces, moments and lengths: with each value, or once, in its title.
enum class UnitsStand : std::uint8_t { WithValues, InTitle };

/// What every part of a picture is drawn from. Lives while one panel is drawn.
struct Scene {
    const femoop::Model& model;
    const StructureShape& shape;
    const Projection& projection;
    const DrawOptions& options;
    const DrawState& state;
    const ui::DisplayUnits& units;
    Sketch& sketch;
    const LevelOfDetail& detail;
    ShowSet show; ///< what this panel shows of what the options ask for
    UnitsStand units_stand = UnitsStand::WithValues;

    bool shows(Show item) const { return show.contains(item); }
    ui::Point place(femoop::NodeId node) const { return projection(shape[node]); }
    /// A symbol frame at a place of a member, x along the member, y along its y' axis.
    SymbolFrame frame_on(const MemberShape& member, double along) const
    {
        return projection.frame(member.at(along), member.x(), member.y());
    }
    /// A number as books print it, with a true minus sign; `text` adds the unit, but where the title says it.
    std::string number(double value, ui::Measure measure) const;
    std::string text(double value, ui::Measure measure) const;
    /// No result is drawn over the structure, so there is room to say what it is made of.
    bool explains() const;
    bool is_flat() const { return projection.is_plane(); }
    /// Null where the scales are those of the results drawn, as in every envelope.
    const LockedScale* locked_scale() const;
};

/// A number's text with a true minus sign for its hyphen.
std::string with_minus(const std::string& text);

/// The units that numbers of a model are shown in.
ui::DisplayUnits display_units(const femoop::Model& model, const DrawOptions& options);

} // namespace drawing
