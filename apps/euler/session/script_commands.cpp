#include "apps/euler/session/script_commands.h"

namespace euler {

using ui::Key;
using ui::translatable;

void show_script(Workspace& workspace)
{
    workspace.topic = Topic::Script;
    workspace.has_panels = true;
    workspace.requests.push_back(Request::WriteScript);
}

namespace {

void edit_script(Workspace& workspace)
{
    if (!workspace.session.edited_text) workspace.session.edit_text();
    show_script(workspace);
}

ui::Reason why_not_accept_text(const Workspace& workspace)
{
    if (workspace.session.edited_text) return std::nullopt;
    return translatable("the script is not edited as text");
}

} // namespace

void add_script_commands(CommandTable& table)
{
    ui::MenuBuilder<Workspace> menu(table, translatable("Step"));
    menu.step({"script.write", translatable("Write a line of the script"), {{Key::S, {}}}}, show_script);
    menu.step({"script.edit", translatable("Edit the script as text"), {{Key::S, ui::shift}}}, edit_script,
              [](const Workspace& workspace) { return workspace.session.why_not_edit_text(); })
        .is_on = [](const Workspace& workspace) { return workspace.session.edited_text.has_value(); };
    menu.step(
        {"script.accept", translatable("Apply the text"), {{Key::Enter, ui::ctrl}}},
        [](Workspace& workspace) { workspace.session.accept_text(); }, why_not_accept_text);
}

} // namespace euler
