#include "apps/frame/session/influence_commands.h"

#include <algorithm>

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

void choose_next(Workspace& workspace)
{
    AskedLine& line = workspace.session.influence;
    const femoop::Model& model = workspace.session.model();
    const std::vector<femoop::MovingEffect> choices = line.choices(model);
    const auto now = std::ranges::find(choices, line.effect(model));
    const bool has_next = now != choices.end() && now + 1 != choices.end();
    if (!choices.empty()) line.choose(has_next ? *(now + 1) : choices.front());
}

Reason needs_kept_line(const Workspace& workspace)
{
    if (Reason reason = needs_influence_line(workspace)) return reason;
    if (!workspace.session.influence.kept(workspace.session.model()).empty()) return std::nullopt;
    return translatable("no influence line is kept; Ctrl+Shift+I keeps the one that is shown");
}

// Panels would become too low for their numbers.
Reason why_not_keep_line(const Workspace& workspace)
{
    constexpr std::size_t most = 5;
    if (Reason reason = needs_influence_line(workspace)) return reason;
    if (workspace.session.influence.kept(workspace.session.model()).size() < most) return std::nullopt;
    return translatable("the sheet has five kept lines; take one off first");
}

} // namespace

Reason needs_influence_line(const Workspace& workspace)
{
    if (workspace.session.influence.is_on(workspace.session.model())) return std::nullopt;
    return translatable("no influence line is shown; press I and click a section or a support");
}

Reason why_no_influence_line(const Workspace& workspace)
{
    if (workspace.session.solution().results) return std::nullopt;
    return translatable("the model has no results");
}

void add_influence_commands(CommandTable& table)
{
    Menu menu(table, methods_menu);
    menu.step({"view.influence.next", translatable("The next quantity of the influence line"), {{Key::I, ui::shift}}},
              choose_next, needs_influence_line);
    menu.step(
        {"view.influence.trace", translatable("Trace the influence line with a unit load"), {{Key::U, {}}}},
        [](Workspace& workspace) {
            AskedLine& line = workspace.session.influence;
            if (line.is_traced()) line.choose_train({});
            else line.trace();
        },
        needs_influence_line);
    menu.step(
        {"view.influence.keep", translatable("Keep this influence line on the sheet"), {{Key::I, ui::ctrl_shift}}},
        [](Workspace& workspace) { workspace.session.influence.keep(workspace.session.model()); }, why_not_keep_line);
    menu.step(
        {"view.influence.drop", translatable("Take the last kept influence line off"), {{Key::X, ui::ctrl_shift}}},
        [](Workspace& workspace) {
            AskedLine& line = workspace.session.influence;
            line.drop(workspace.session.model(), line.kept(workspace.session.model()).back());
        },
        needs_kept_line);
    menu.step(
        {"view.influence.close", translatable("Close the influence line")},
        [](Workspace& workspace) { workspace.session.influence.clear(); }, needs_influence_line);
}

} // namespace frame
