#pragma once

#include "apps/plane/session/commands.h"

namespace plane {

/// Tools, what they have begun, deleting, gaps and disputes.
void add_edit_commands(CommandTable& table);
void add_drawing_commands(CommandTable& table);

/// What a click with the selecting tool does at a part, or where there is none: a face without an entry gets one.
void click_part(Workspace& workspace, const std::optional<Part>& part, bool adds);
/// The gap of an open outline, as it is told: not while a curve is drawn or a point dragged.
std::optional<Gap> told_gap(const Workspace& workspace);
/// A probe is placed, or an end of a cut. \pre the hand holds a tool that reads
void read_at(Workspace& workspace, const FlatPoint& place);
/// A place that was typed, as if it had been clicked.
void type_place(Workspace& workspace, const FlatPoint& place);
/// So far off that the rest of the drawing would be one place beside it.
bool is_out_of_reach(const PlaneModel& model, const FlatPoint& place);
/// The face gets an entry, and is selected.
void make_region_at(Workspace& workspace, const FacePlace& place);

} // namespace plane
