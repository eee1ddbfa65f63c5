#include "apps/frame/session/clipboard_commands.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "apps/frame/document/drawing.h"
#include "apps/frame/session/edit_commands.h"
#include "apps/frame/session/in_plane.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

Reason why_not_copy(const Desk& desk)
{
    if (!is_in_plane(desk))
        return translatable("a structure in space is not moved with the mouse; change its numbers instead");
    if (std::ranges::none_of(desk.session.selection.parts(), can_be_clipped))
        return translatable("nothing is selected that can be copied");
    return std::nullopt;
}

void copy_selection(Desk& desk)
{
    desk.clipboard = std::make_shared<const Clipping>(
        *clipping_of(desk.session.document(), desk.session.selection.parts()));
}

void cut_selection(Desk& desk)
{
    copy_selection(desk);
    const auto selected = desk.session.selection.parts();
    desk.session.change({translatable("Cut"), [parts = std::vector<Part>(selected.begin(), selected.end())](
                                                  Document& document) { remove(document, parts); }});
}

Reason why_not_put(const Desk& desk)
{
    if (!desk.clipboard) return translatable("nothing was copied yet");
    return frame::why_not_paste(desk.session.model(), desk.session.selection.parts(), *desk.clipboard);
}

void put_clipboard(Desk& desk)
{
    cancel_transform(desk);
    if (std::vector<femoop::Fault> faults = weightless(desk.session.model(), *desk.clipboard); !faults.empty()) {
        desk.session.notice = refusal_of(std::move(faults));
        return;
    }
    if (desk.clipboard->holds == Clipping::Holds::Structure)
        return desk.hand.carry(desk.clipboard, desk.session.model().units);
    const auto selected = desk.session.selection.parts();
    desk.session.change_soundly(
        {translatable("Paste the loads"),
         [clipping = desk.clipboard, parts = std::vector<Part>(selected.begin(), selected.end())](Document& document) {
             paste_loads(document, *clipping, parts);
         }});
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
