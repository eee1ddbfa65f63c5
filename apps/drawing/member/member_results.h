#pragma once

#include <optional>

#include "apps/drawing/draw_options.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "ui/paint/painter.h"

namespace drawing {

/// The results along one member: its section forces and its deflection one under the other against a common axis,
/// extremes marked, and beside each the formula of every stretch.
///
///      Member BC · load case G                        x = 2.4 m
///      N [kN]    ─────────────────────|─────────────   N(x) = −14.2
///      V [kN]    ◣────────────────────|───────────◥   V(x) = 50.6 − 12.65 x
///      M [kN·m]  ◤───────◡◡◡◡◡◡◡◡◡◡◡◡|◡◡◡◡──────◥   M(x) = −42.68 + 50.6 x − 6.325 x²
///      v [mm]    ─────────────────────|─────────────   v(x) = ...
///                0                            8 m
///
/// Sides  N, V, T, v and w positive upwards; M on the side that it stretches, or on the other
///        (DrawOptions::moment_side)
struct MemberResultsSubject {
    const femoop::Model& model;
    const femoop::Results& results; ///< of this model
    const DrawOptions& options;     ///< which case, language, units, theme
    femoop::MemberId member;
    std::optional<double> cursor{}; ///< a section, from the first end of the flexible part [length]
};

/// \pre the results have the case and the member
void draw_member_results(ui::Painter& painter, const MemberResultsSubject& subject);

/// The section under a place of the sheet; nothing beside the diagrams.
std::optional<double> section_at(const MemberResultsSubject& subject, ui::Size sheet, ui::Point place);

/// One length of the model along the axis [logical pixels].
double pixels_per_length(const MemberResultsSubject& subject, ui::Size sheet);

/// Below this height of the sheet the diagrams are too low to be read [logical pixels].
double least_height(const MemberResultsSubject& subject);

} // namespace drawing
