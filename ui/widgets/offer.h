#pragma once

#include <cstddef>
#include <string_view>

#include "ui/text/catalogue.h"
#include "ui/widgets/panel.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// What a linked program offers, with both answers, at the window's foot: there it covers nothing and has its room
/// however long the menus are. \param sentence  key of the catalogue
FootMessage offer_message(std::string_view sentence, const Catalogue& tr);
/// What the window is asked for by a button of the message.
Request answer_of_button(std::size_t button);

} // namespace ui
