#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// What one looks at in place of the results of a case: one at a time, so that what was asked for last is seen.
enum class ShownMethod { InfluenceLine, FreeBody, Funicular, VirtualWork, Truss, Counting, TrainEnvelope };

/// Ends all others, and puts away the tool of one of these that asks for a part of the structure.
void close_other_methods(Workspace& workspace, ShownMethod but);

/// The free body, funicular, displacement by virtual work or truss by hand that is shown, as the body of a LaTeX document;
/// empty where there is none.
std::string shown_method_latex(const Session& session);

} // namespace frame
