#include "apps/euler/session/script_commands.h"

namespace euler {

using ui::Key;
using ui::translatable;

void show_script(Desk& desk)
{
    desk.topic = Topic::Script;
    desk.has_panels = true;
    desk.requests.push_back(Request::WriteScript);
}

namespace {

void edit_script(Desk& desk)
{
    if (!desk.session.edited_text) desk.session.edit_text();
    show_script(desk);
}

ui::Reason why_not_accept_text(const Desk& desk)
{
    if (desk.session.edited_text) return std::nullopt;
    return translatable("the script is not edited as text");
}

} // namespace

void add_script_commands(CommandTable& table)
{
    ui::MenuBuilder<Desk> menu(table, translatable("Step"));
    menu.step({"script.write", translatable("Write a line of the script"), {{Key::S, {}}}}, show_script);
    menu.step({"script.edit", translatable("Edit the script as text"), {{Key::S, ui::shift}}}, edit_script,
              [](const Desk& desk) { return desk.session.why_not_edit_text(); })
        .is_on = [](const Desk& desk) { return desk.session.edited_text.has_value(); };
    menu.step(
        {"script.accept", translatable("Apply the text"), {{Key::Enter, ui::ctrl}}},
        [](Desk& desk) { desk.session.accept_text(); }, why_not_accept_text);
}

} // namespace euler
