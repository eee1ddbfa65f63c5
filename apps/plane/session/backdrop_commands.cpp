#include "apps/plane/session/backdrop_commands.h"

namespace plane {

using ui::translatable;

void add_backdrop_commands(CommandTable& table)
{
    ui::MenuBuilder<Workspace> draw(table, translatable("Draw"));
    draw.step(
        {"background.remove", translatable("Take the image behind the drawing away")},
        [](Workspace& workspace) {
            if (workspace.hand.tool() == ToolKind::Align) workspace.hand.select(ToolKind::Select);
            workspace.change({translatable("Take the image behind the drawing away"),
                              [](Document& document) { document.backdrop.reset(); }});
        },
        why_no_backdrop);
    table.with_argument("background.opacity", [](Workspace& workspace, const ui::Argument& argument) -> ui::Reason {
        if (const auto reason = why_no_backdrop(workspace)) return reason;
        const auto percent = argument.number();
        if (!percent || *percent < 100.0 * least_opacity || *percent > 100.0)
            return argument.wanted("a percentage from 5 to 100");
        return workspace.change(opacity_change(*percent / 100.0, Step::Click));
    });
}

ui::Reason why_no_backdrop(const Workspace& workspace)
{
    if (workspace.session.document().backdrop) return std::nullopt;
    return translatable("there is no image behind the drawing; the menu File has one from a file");
}

Change opacity_change(double opacity, Step step)
{
    return {translatable("Make the image paler or stronger"),
            [opacity](Document& document) { document.backdrop->opacity = opacity; }, step};
}

} // namespace plane
