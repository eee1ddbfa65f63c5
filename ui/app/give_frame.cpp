#include "ui/app/give_frame.h"

namespace ui {

void give_frame(App& app, Input input, Typing& typing)
{
    ImGuiSession& gui = app.gui();
    if (!gui.awaits_field()) typing.give_next(input, gui.reader());
    app.frame(input);
    typing.put_back(gui.unread_text());
}

} // namespace ui
