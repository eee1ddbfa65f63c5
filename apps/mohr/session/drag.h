#pragma once

#include <optional>

#include "apps/mohr/document/edit.h"
#include "apps/mohr/view/scene.h"
#include "ui/text/message.h"

namespace mohr {

/// What a hand that drags took hold of: the state as it was then, and the picture.
struct Grip {
    Handle handle;
    Document document;
    Solution solution;
    Drawn drawn;
    Frame frame;
};

/// What dragging to a place of the sheet makes of the document. Components snap to round numbers, about a hundredth of
/// the largest, and angles to whole degrees; with `is_fine` they do not.
Edit dragged(const Grip& grip, ui::Point at, bool is_fine);

/// The step's name in the history.
ui::Message label_of(Handle handle);

} // namespace mohr
