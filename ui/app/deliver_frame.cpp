#include "ui/app/deliver_frame.h"

#include <algorithm>

namespace ui {

namespace {

constexpr double longest_step = 0.5; // s

} // namespace

void deliver_frame(App& app, Input input, Typing& typing)
{
    ImGuiSession& gui = app.gui();
    if (!gui.awaits_field()) typing.deliver_next(input, gui.reader());
    input.seconds = std::min(input.seconds, longest_step);
    app.frame(input);
    typing.put_back(gui.unread_text());
}

} // namespace ui
