#pragma once

#include <vector>

#include "apps/drawing/cut.h"
#include "apps/drawing/reading.h"
#include "apps/frame/session/commands.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// The results of an envelope of trains: which train, beside which case, and the largest and least section forces of
/// every member with their sections. \pre such an envelope is shown
void train_envelope_panel(Workspace& workspace, ui::NumberFields& fields);

/// What trains do at most and at least at a section. \pre the envelope that is shown has values
std::vector<drawing::ReadingLine> envelope_lines(const Session& session, const drawing::Cut& cut);

} // namespace frame
