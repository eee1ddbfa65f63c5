#pragma once

namespace ui {

/// The drivers that draw end the program where they get no memory, so that it is looked for before they are asked: some
/// 800 MB of addresses, where the system sets a limit (`ulimit -v`). \throws ContextError
void require_room_to_draw();

} // namespace ui
