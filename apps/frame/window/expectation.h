#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/drawing/cut.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/window/application.h"

namespace frame {

/// What a scenario can expect of the app, sentences in English whatever language the app speaks:
///
///     value member AB M at 50% is -12.5 kN·m   as the reading of the section shows it
///     node B at (2, 4)                         in the unit of the file
///     nodes 4     members 3     loads 5     dimensions 2     how many
///     drawn "58.52"     not drawn "58.52"      a string of the picture
///     written all.csv "Node;x"                 a file that was written, with this in it
///     ends yes                                 the program would end now
///     undo Move: Node C     redo nothing       the step that would be taken back or done again
///     selection Node B, Member AB     case ULS     problems 0     notice nothing
///     derivation 3 of 9, M(BC, 50%)            the step of the number that is explained
///     tool draw.member     typed 4<30          what the hand holds, what is typed while drawing
///     file portal.json     tabs 2     changed no
///
/// \returns what was found instead and what was wanted
std::optional<std::string> why_not(std::string_view expectation, const Application& application);

/// The section of a member of the model: `50%` of its length, or so far from its start.
std::optional<Cut> cut_at(const femoop::Model& model, const std::string& member, std::string_view at);

/// "(2, 0)" or "(2, 0, 1)".
std::optional<Eigen::Vector3d> point_in(std::string_view text);

} // namespace frame
