#pragma once

#include "apps/frame/session/session.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// What a tool works on in a document of the session's.
inline Work work_on(const Document& document, Session& session)
{
    Prediction* const sketched = session.hidden && session.solution().results ? &session.prediction : nullptr;
    const auto* const line = sketched != nullptr ? session.shown_line() : nullptr;
    return {document,           session.selection,     sketched,       line, &session.influence, &session.free_body,
            &session.funicular, &session.virtual_work, session.units()};
}

/// What the tool in the hand works on: its own gesture counts from what was there before.
inline Work work_of(Session& session) { return work_on(session.history().settled(), session); }

/// What it points at before it is pressed: what is seen, such as a typical structure that is not inserted yet.
inline Work work_seen(Session& session) { return work_on(session.document(), session); }

} // namespace frame
