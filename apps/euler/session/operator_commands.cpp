#include "apps/euler/session/operator_commands.h"

#include <array>

namespace euler {

using ui::Key;
using ui::Message;
using ui::Reason;
using ui::translatable;

namespace {

constexpr std::array<std::string_view, n_verbs> operator_ids{
    "operator.mvfs", "operator.kvfs", "operator.mev",  "operator.split",  "operator.kev",   "operator.mef",
    "operator.kef",  "operator.kemr", "operator.mekr", "operator.kfmrh",  "operator.mfkrh", "operator.mvr",
    "operator.kvr",  "operator.semv", "operator.jekv", "operator.ringmv", "operator.move",  "operator.sweep"};

Reason needs_draft(const Workspace& workspace)
{
    if (workspace.session.draft()) return std::nullopt;
    return translatable("no operator is chosen");
}

Reason why_not_accept(const Workspace& workspace)
{
    if (Reason reason = needs_draft(workspace)) return reason;
    if (workspace.session.draft()->is_complete()) return std::nullopt;
    return {{translatable("{what} is missing"), {{"what", Message(workspace.session.draft()->next().prompt)}}}};
}

// Of what is being made: the text of the script, a line that is drawn, or an operator.
void cancel(Workspace& workspace)
{
    if (workspace.session.edited_text) return workspace.session.cancel_text();
    if (workspace.session.is_drawing()) workspace.session.draw_or_look();
    workspace.session.cancel_operator();
}

Reason why_not_cancel(const Workspace& workspace)
{
    return workspace.session.is_drawing() || workspace.session.edited_text ? std::nullopt : needs_draft(workspace);
}

Message cancel_label(const Workspace& workspace)
{
    return workspace.session.edited_text ? translatable("Give up the text") : translatable("Give up the operator");
}

} // namespace

void show_operators(Workspace& workspace)
{
    workspace.topic = Topic::Operators;
    workspace.has_panels = true;
}

std::string command_id(const OperatorForm& form)
{
    return std::string(operator_ids[static_cast<std::size_t>(form.verb)]);
}

namespace {

void add_operator(ui::MenuBuilder<Workspace>& menu, const OperatorForm& form)
{
    const auto begin = [verb = form.verb](Workspace& workspace) {
        workspace.session.begin(verb);
        show_operators(workspace);
    };
    auto& row = menu.step({operator_ids[static_cast<std::size_t>(form.verb)], form.meaning}, begin);
    row.is_on = [verb = form.verb](const Workspace& workspace) {
        return workspace.session.draft() && workspace.session.draft()->form().verb == verb;
    };
    row.live_label = [&form](const Workspace&) -> Message {
        return {translatable("{operator}: {meaning}"),
                {{"operator", std::string(form.name)}, {"meaning", Message(form.meaning)}}};
    };
}

} // namespace

void add_operator_commands(CommandTable& table)
{
    ui::MenuBuilder<Workspace> menu(table, translatable("Operator"));
    for (const OperatorForm& form : operator_forms()) add_operator(menu, form);
    menu.toggle(
        {"operator.draw", translatable("Draw lines, and be told their operators"), {{Key::L, {}}}},
        [](const Workspace& workspace) { return workspace.session.is_drawing(); },
        [](Workspace& workspace, bool) { workspace.session.draw_or_look(); });
    menu.step(
        {"operator.accept", translatable("Apply the operator"), {{Key::Enter, {}}}},
        [](Workspace& workspace) { workspace.session.accept(); }, why_not_accept);
    menu.step(
        {"operator.take_back", translatable("Take back the last argument"), {{Key::Backspace, {}}}},
        [](Workspace& workspace) { workspace.session.undo_choice(); }, needs_draft);
    menu.step({"operator.cancel", translatable("Give up the operator"), {{Key::Escape, {}}}}, cancel, why_not_cancel)
        .live_label = cancel_label;
    table.with_argument("operator.choose", [](Workspace& workspace, const ui::Argument& argument) {
        return workspace.session.choose_typed(argument.text);
    });
}

} // namespace euler
