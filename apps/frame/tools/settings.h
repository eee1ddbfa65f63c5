#pragma once

#include <cstdint>
#include <string>

#include "apps/drawing/moment_side.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/tools/working_plane.h"
#include "femoop/model/model.h"

namespace frame {

/// What the load tool puts on a part.
enum class LoadKind : std::uint8_t {
    ForceDown, ///< on a node, or at a place of a member
    ForceRight,
    Moment,         ///< counter-clockwise
    UniformDown,    ///< along a whole member
    UniformAcross,  ///< along a whole member, square to it, against its y'
    TriangularDown, ///< from nothing at one end to the value at the other
};

/// How the tools that put something on a part do it.
struct ToolSettings {
    femoop::SupportKind support = femoop::SupportKind::Pin;
    LoadKind load = LoadKind::UniformDown;
    femoop::Quantity force{10.0}, moment{10.0}, line_load{10.0};
    femoop::CaseId load_case;                     ///< that is shown
    MomentSide moment_side = MomentSide::Tension; ///< on which a positive moment is drawn
    WorkingPlane plane{};                         ///< of what is drawn in space
    std::string spacing{};                        ///< of the grid's lines, with its unit: "0.75 m"; "": a round one
    double grid = 1.0;                            ///< their distance at the scale of the picture [length]
    bool draws_to_grid = true;
    bool draws_to_parts = true; ///< nodes, members, and rays from where drawing began
};

} // namespace frame
