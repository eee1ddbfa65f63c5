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
using ui::translatable;

namespace {

using Reason = std::optional<ui::Phrase>;

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
    constexpr std::string_view menu = translatable("Edit");
    table.add({.id = "edit.cut",
               .menu = menu,
               .label = translatable("Cut"),
               .shortcuts = {{Key::X, ui::ctrl}},
               .run = cut_selection,
               .why_not = why_not_copy});
    table.add({.id = "edit.clip",
               .menu = menu,
               .label = translatable("Copy to the clipboard"),
               .shortcuts = {{Key::C, ui::ctrl}},
               .run = copy_selection,
               .why_not = why_not_copy});
    table.add({.id = "edit.paste",
               .menu = menu,
               .label = translatable("Paste"),
               .shortcuts = {{Key::V, ui::ctrl}},
               .run = put_clipboard,
               .why_not = why_not_put});
}

} // namespace frame
