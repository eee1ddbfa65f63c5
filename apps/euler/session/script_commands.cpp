#include "apps/euler/session/script_commands.h"

namespace euler {

using ui::Key;
using ui::translatable;

namespace {

constexpr std::string_view script_menu = translatable("Step");

} // namespace

void show_script(Desk& desk)
{
    desk.topic = Topic::Script;
    desk.has_panels = true;
    desk.requests.push_back(Request::WriteScript);
}

void add_script_commands(CommandTable& table)
{
    table.add({.id = "script.write",
               .menu = script_menu,
               .label = translatable("Write a line of the script"),
               .shortcuts = {{Key::S, {}}},
               .run = show_script});
    table.add({.id = "script.edit",
               .menu = script_menu,
               .label = translatable("Edit the script as text"),
               .shortcuts = {{Key::S, ui::shift}},
               .run =
                   [](Desk& desk) {
                       if (!desk.session.edited_text) desk.session.edit_text();
                       show_script(desk);
                   },
               .why_not = [](const Desk& desk) { return desk.session.why_not_edit_text(); },
               .is_on = [](const Desk& desk) { return desk.session.edited_text.has_value(); }});
    table.add({.id = "script.accept",
               .menu = script_menu,
               .label = translatable("Apply the text"),
               .shortcuts = {{Key::Enter, ui::ctrl}},
               .run = [](Desk& desk) { desk.session.accept_text(); },
               .why_not = [](const Desk& desk) -> std::optional<ui::Phrase> {
                   if (desk.session.edited_text) return std::nullopt;
                   return translatable("the script is not edited as text");
               }});
}

} // namespace euler
