#include "apps/frame/session/clipboard_commands.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "apps/frame/document/drawing.h"
#include "apps/frame/session/edit_commands.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

Reason why_not_copy(const Workspace& workspace)
{
    if (std::ranges::none_of(workspace.session.selection.parts(), can_be_clipped))
        return translatable("nothing is selected that can be copied");
    return std::nullopt;
}

void copy_selection(Workspace& workspace)
{
    workspace.clipboard = std::make_shared<const Clipping>(
        *clipping_of(workspace.session.document(), workspace.session.selection.parts()));
}

void cut_selection(Workspace& workspace)
{
    copy_selection(workspace);
    const auto selected = workspace.session.selection.parts();
    workspace.session.change({translatable("Cut"), [parts = std::vector<Part>(selected.begin(), selected.end())](
                                                       Document& document) { remove(document, parts); }});
}

Reason why_not_put(const Workspace& workspace)
{
    if (!workspace.clipboard) return translatable("nothing was copied yet");
    return frame::why_not_paste(workspace.session.model(), workspace.session.selection.parts(), *workspace.clipboard);
}

void put_clipboard(Workspace& workspace)
{
    cancel_transform(workspace);
    if (std::vector<femoop::Fault> faults = weightless(workspace.session.model(), *workspace.clipboard);
        !faults.empty()) {
        workspace.session.notice = refusal_of(std::move(faults));
        return;
    }
    if (workspace.clipboard->holds == Clipping::Holds::Structure)
        return workspace.tool_controller.carry(workspace.clipboard, workspace.session.model().units);
    const auto selected = workspace.session.selection.parts();
    workspace.session.change_soundly(
        {translatable("Paste the loads"),
         [clipping = workspace.clipboard, parts = std::vector<Part>(selected.begin(), selected.end())](
             Document& document) { paste_loads(document, *clipping, parts); }});
}

} // namespace

void add_clipboard_commands(CommandTable& table)
{
    Menu menu(table, translatable("Edit"));
    menu.step({"edit.cut", translatable("Cut"), {{Key::X, ui::ctrl}}}, cut_selection, why_not_copy);
    menu.step({"edit.clip", translatable("Copy to the clipboard"), {{Key::C, ui::ctrl}}}, copy_selection, why_not_copy);
    menu.step({"edit.paste", translatable("Paste"), {{Key::V, ui::ctrl}}}, put_clipboard, why_not_put);
}

} // namespace frame
