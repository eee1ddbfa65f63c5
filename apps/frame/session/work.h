#pragma once

#include "apps/frame/session/session.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// What the tool in the hand works on.
inline Work work_of(Session& session)
{
    Prediction* const sketched = session.hidden && session.solution().results ? &session.prediction : nullptr;
    return {session.history().settled(), session.selection, sketched, &session.influence, session.units()};
}

} // namespace frame
