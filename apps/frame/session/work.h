#pragma once

#include "apps/frame/session/session.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// The envelope of trains, while it is seen and found; null otherwise.
inline const AskedEnvelope* seen_train_envelope(const Session& session)
{
    const AskedEnvelope& envelope = session.train_envelope;
    const bool is_seen = session.shows_train_envelope() && !session.hidden && !session.influence.is_on(session.model());
    const bool is_found = is_seen && session.solution().results &&
                          envelope.picture(session.model(), session.generation(), session.results_view()) != nullptr;
    return is_found ? &envelope : nullptr;
}

/// What a tool works on in a document of the session's.
inline Work work_on(const Document& document, Session& session)
{
    Prediction* const sketched = session.hidden && session.solution().results ? &session.prediction : nullptr;
    const auto* const line = sketched != nullptr ? session.shown_line() : nullptr;
    return {.document = document,
            .selection = session.selection,
            .prediction = sketched,
            .sketched_line = line,
            .influence = &session.influence,
            .free_body = &session.free_body,
            .funicular = &session.funicular,
            .virtual_work = &session.virtual_work,
            .train_envelope = seen_train_envelope(session),
            .units = session.units()};
}

/// What the tool in the hand works on: its own gesture counts from what was there before.
inline Work work_of(Session& session) { return work_on(session.history().settled(), session); }

/// What it points at before it is pressed: what is seen, such as a typical structure that is not inserted yet.
inline Work work_seen(Session& session) { return work_on(session.document(), session); }

} // namespace frame
