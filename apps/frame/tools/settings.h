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
    Force, ///< on a node, or at a place of a member
    Moment,
    Uniform,       ///< along a whole member
    UniformAcross, ///< along a whole member, square to it, against its y'
    Triangular,    ///< from nothing at one end to the value at the other
};

/// Along which axis a positive value acts, or about which it turns counter-clockwise. Down is against y in a plane
/// frame, and against z in a grillage and in space.
enum class LoadWay : std::uint8_t { Down, X, Y, Z };

struct ToolLoad {
    LoadKind kind = LoadKind::Uniform;
    LoadWay way = LoadWay::Down;

    friend bool operator==(const ToolLoad&, const ToolLoad&) = default;
};

/// How the tools that put something on a part do it.
struct ToolSettings {
    femoop::SupportKind support = femoop::SupportKind::Pin;
    ToolLoad load{};
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
