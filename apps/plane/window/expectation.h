#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/plane/window/application.h"

namespace plane {

/// What a scenario can expect of the plane app, beside what it can expect of every app (ui/app/expectation.h):
///
///     points 4     curves 4     faces 1     empty 0        faces without a region
///     regions R1: steel, R2: hole       `nothing`
///     areas 2100 78.54                  of the faces, the largest first, four digits
///     selection Curve C1, Point A       `nothing`
///     supports C4                       points and curves that have one; `nothing`
///     loads C2 qx 100 qy 0              of the case that is shown, on curves; `nothing`
///     problems 0                        errors and warnings
///     gap 0.5                           the width of an open outline that is told; `nothing`
///     dispute R1, R2                    entries that claim one face; `nothing`
///     elements 312                      of the mesh, where it is shown; `nothing`
///     reason nothing                    why there are no results
///     tool tool.line     typed 60, 20
///     at A 70 30                        where a point is
///     notice nothing     file Untitled     changed no
std::optional<std::string> why_not(std::string_view expectation, const Application& application);

} // namespace plane
