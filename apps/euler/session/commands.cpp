#include "apps/euler/session/commands.h"

#include <utility>

#include "apps/euler/session/challenge/challenge_commands.h"
#include "apps/euler/session/gallery_commands.h"
#include "apps/euler/session/look_commands.h"
#include "apps/euler/session/operator_commands.h"
#include "apps/euler/session/script_commands.h"
#include "apps/euler/session/step_commands.h"
#include "ui/workspace/file_commands.h"

namespace euler {

using ui::translatable;

std::function<void(Workspace&)> asks(Request request)
{
    return [request](Workspace& workspace) { workspace.requests.push_back(request); };
}

CommandTable command_table()
{
    CommandTable table;
    ui::standard::add_file_commands(
        table, {.exported = translatable("Export picture…"), .described = translatable("Script and solids in words")});
    add_gallery_commands(table);
    add_challenge_commands(table);
    add_step_commands(table);
    add_script_commands(table);
    add_operator_commands(table);
    add_look_commands(table);
    add_panel_commands(table);
    ui::standard::add_help(table);
    return table;
}

} // namespace euler
