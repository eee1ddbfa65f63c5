#include "apps/plane/session/mesher_commands.h"

#include <string>

namespace plane {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

Reason why_not_watched(const Workspace& workspace)
{
    if (workspace.session.player() != nullptr) return std::nullopt;
    return translatable("no mesh is watched; watch the mesh being made first");
}

Reason why_no_step_back(const Workspace& workspace)
{
    if (const Reason reason = why_not_watched(workspace)) return reason;
    if (workspace.session.player()->place() > 0) return std::nullopt;
    return translatable("this is the beginning");
}

Reason why_no_step_ahead(const Workspace& workspace)
{
    if (const Reason reason = why_not_watched(workspace)) return reason;
    if (workspace.session.player()->place() < workspace.session.player()->n_steps()) return std::nullopt;
    return translatable("this is the end");
}

void watch(Workspace& workspace, bool is_on)
{
    Session& session = workspace.session;
    if (!is_on) return session.watch.end();
    if (const auto reason = session.watch_mesher()) session.notify(*reason);
}

void go(Workspace& workspace, std::size_t place) { workspace.session.watch.go_to(place); }

/// What a scenario gives: a step's number.
Reason go_to_step(Workspace& workspace, const ui::Argument& argument)
{
    if (const Reason reason = why_not_watched(workspace)) return reason;
    const auto place = argument.number();
    const std::size_t most = workspace.session.player()->n_steps();
    if (!place || *place < 0.0 || *place > static_cast<double>(most))
        return argument.wanted("a step from 0 to " + std::to_string(most));
    go(workspace, static_cast<std::size_t>(*place));
    return std::nullopt;
}

} // namespace

void add_mesher_commands(CommandTable& table)
{
    ui::MenuBuilder<Workspace> menu(table, translatable("Results"));
    menu.toggle(
        {"mesher.watch", translatable("Watch the mesh being made"), {{Key::M, ui::shift}}},
        [](const Workspace& workspace) { return workspace.session.player() != nullptr; }, watch);
    menu.step(
        {"mesher.first", translatable("To the beginning"), {{Key::Home, {}}}},
        [](Workspace& workspace) { go(workspace, 0); }, why_no_step_back);
    menu.step(
        {"mesher.back", translatable("Step back"), {{Key::Left, {}}, {Key::PageUp, {}}}},
        [](Workspace& workspace) { go(workspace, workspace.session.player()->place() - 1); }, why_no_step_back);
    menu.toggle(
        {"mesher.play", translatable("Play"), {{Key::Space, {}}}},
        [](const Workspace& workspace) { return workspace.session.watch.is_playing(); },
        [](Workspace& workspace, bool is_on) { workspace.session.watch.play(is_on); }, why_not_watched);
    menu.step(
        {"mesher.forward", translatable("Next step"), {{Key::Right, {}}}},
        [](Workspace& workspace) { go(workspace, workspace.session.player()->place() + 1); }, why_no_step_ahead);
    menu.step(
        {"mesher.last", translatable("To the end"), {{Key::End, {}}}},
        [](Workspace& workspace) { go(workspace, workspace.session.player()->n_steps()); }, why_no_step_ahead);
    menu.step(
        {"mesher.slower", translatable("Slower"), {{Key::Down, {}}}},
        [](Workspace& workspace) { workspace.session.watch.change_speed(0.5); }, why_not_watched);
    menu.step(
        {"mesher.faster", translatable("Faster"), {{Key::Up, {}}}},
        [](Workspace& workspace) { workspace.session.watch.change_speed(2.0); }, why_not_watched);
    table.with_argument("mesher.go_to", go_to_step);
}

} // namespace plane
