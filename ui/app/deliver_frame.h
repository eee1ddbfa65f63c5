#pragma once

#include "ui/app/app.h"
#include "ui/context/typing.h"

namespace ui {

/// A frame of the app, in which it hears the next stroke that was typed - unless a field is about to get the keyboard:
/// then all that was typed waits for it. Time that the app itself took, for a report say, is none in which somebody
/// read a notice or held a key: no frame is longer than half a second.
void deliver_frame(App& app, Input input, Typing& typing);

} // namespace ui
