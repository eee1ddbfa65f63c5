#include "apps/euler/session/commands.h"

#include <array>
#include <utility>

#include "apps/euler/session/challenge/challenge_commands.h"
#include "apps/euler/session/gallery_commands.h"
#include "apps/euler/session/look_commands.h"
#include "apps/euler/session/operator_commands.h"
#include "apps/euler/session/step_commands.h"

namespace euler {

using ui::Key;
using ui::translatable;

namespace {

constexpr std::string_view file_menu = translatable("File");
constexpr std::string_view help_menu = translatable("Help");

void add_file_commands(CommandTable& table)
{
    table.add({.id = "file.new",
               .menu = file_menu,
               .label = translatable("New"),
               .shortcuts = {{Key::N, ui::ctrl}},
               .run = [](Desk& desk) { leave_lesson(desk, [](Desk& left) { left.session.begin_anew(); }); }});
    table.add({.id = "file.open",
               .menu = file_menu,
               .label = translatable("Open…"),
               .shortcuts = {{Key::O, ui::ctrl}},
               .run = [](Desk& desk) { leave_lesson(desk, asks(Request::OpenDialog)); }});
    table.add({.id = "file.save",
               .menu = file_menu,
               .label = translatable("Save"),
               .shortcuts = {{Key::S, ui::ctrl}},
               .run = [](Desk& desk) {
                   if (desk.session.path()) desk.session.save(*desk.session.path());
                   else desk.requests.push_back(Request::SaveDialog);
               }});
    table.add({.id = "file.save_as",
               .menu = file_menu,
               .label = translatable("Save as…"),
               .shortcuts = {{Key::S, ui::ctrl_shift}},
               .run = asks(Request::SaveDialog)});
    table.add({.id = "file.export",
               .menu = file_menu,
               .label = translatable("Export picture…"),
               .shortcuts = {{Key::E, ui::ctrl_shift}},
               .run = asks(Request::ExportDialog)});
    table.add({.id = "file.copy_picture",
               .menu = file_menu,
               .label = translatable("Copy picture"),
               .shortcuts = {{Key::C, ui::ctrl_shift}},
               .run = asks(Request::CopyPicture)});
    table.add({.id = "file.describe",
               .menu = file_menu,
               .label = translatable("Script and solids in words"),
               .shortcuts = {{Key::D, ui::ctrl_shift}},
               .run = asks(Request::Description)});
    table.add({.id = "file.quit",
               .menu = file_menu,
               .label = translatable("Quit"),
               .shortcuts = {{Key::Q, ui::ctrl}},
               .run = [](Desk& desk) { leave_lesson(desk, asks(Request::Quit)); }});
}

void add_help_commands(CommandTable& table)
{
    table.add({.id = "help.palette",
               .menu = help_menu,
               .label = translatable("Find a command…"),
               .shortcuts = {{Key::K, ui::ctrl}, {Key::F3, {}}},
               .run = asks(Request::Palette)});
    table.add({.id = "help.shortcuts",
               .menu = help_menu,
               .label = translatable("Keys"),
               .shortcuts = {{Key::F1, {}}},
               .run = asks(Request::ShortcutList)});
}

} // namespace

std::function<void(Desk&)> asks(Request request)
{
    return [request](Desk& desk) { desk.requests.push_back(request); };
}

void leave_lesson(Desk& desk, std::function<void(Desk&)> then)
{
    if (desk.session.is_dirty()) desk.after_question = std::move(then);
    else then(desk);
}

CommandTable command_table()
{
    CommandTable table;
    add_file_commands(table);
    add_gallery_commands(table);
    add_challenge_commands(table);
    add_step_commands(table);
    add_operator_commands(table);
    add_look_commands(table);
    add_panel_commands(table);
    add_help_commands(table);
    return table;
}

} // namespace euler
