#pragma once

#include <cstdint>
#include <functional>

#include "apps/plane/document/document.h"
#include "ui/text/message.h"

namespace plane {

/// Whether a change is a step of its own or belongs to the gesture that is under way.
enum class Step : std::uint8_t { Click, Drag };

/// What somebody wants done to the document, as the history names it. The changes of one gesture all start from the
/// document as it was before the gesture, so each says the whole of what the hand has done so far.
struct Change {
    ui::Message label;
    std::function<void(Document&)> command;
    Step step = Step::Click;
};

} // namespace plane
