#include "ui/app/deliver_frame.h"

namespace ui {

void deliver_frame(App& app, Input input, Typing& typing)
{
    ImGuiSession& gui = app.gui();
    if (!gui.awaits_field()) typing.deliver_next(input, gui.reader());
    app.frame(input);
    typing.put_back(gui.unread_text());
}

} // namespace ui
