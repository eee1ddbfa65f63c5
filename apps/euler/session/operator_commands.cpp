#include "apps/euler/session/operator_commands.h"

#include <array>

namespace euler {

using ui::Key;
using ui::Phrase;
using ui::Reason;
using ui::translatable;

namespace {

constexpr std::array<std::string_view, n_verbs> operator_ids{
    "operator.mvfs", "operator.kvfs", "operator.mev",  "operator.split",  "operator.kev",   "operator.mef",
    "operator.kef",  "operator.kemr", "operator.mekr", "operator.kfmrh",  "operator.mfkrh", "operator.mvr",
    "operator.kvr",  "operator.semv", "operator.jekv", "operator.ringmv", "operator.move",  "operator.sweep"};

Reason needs_draft(const Desk& desk)
{
    if (desk.session.draft()) return std::nullopt;
    return translatable("no operator is chosen");
}

Reason why_not_accept(const Desk& desk)
{
    if (Reason reason = needs_draft(desk)) return reason;
    if (desk.session.draft()->is_complete()) return std::nullopt;
    return {{translatable("{what} is missing"), {{"what", Phrase(desk.session.draft()->next().prompt)}}}};
}

// Of what is being made: the text of the script, a line that is drawn, or an operator.
void cancel(Desk& desk)
{
    if (desk.session.edited_text) return desk.session.give_up_text();
    if (desk.session.is_drawing()) desk.session.draw_or_look();
    desk.session.give_up();
}

Reason why_not_cancel(const Desk& desk)
{
    return desk.session.is_drawing() || desk.session.edited_text ? std::nullopt : needs_draft(desk);
}

Phrase cancel_label(const Desk& desk)
{
    return desk.session.edited_text ? translatable("Give up the text") : translatable("Give up the operator");
}

} // namespace

void show_operators(Desk& desk)
{
    desk.topic = Topic::Operators;
    desk.has_panels = true;
}

std::string command_id(const OperatorForm& form)
{
    return std::string(operator_ids[static_cast<std::size_t>(form.verb)]);
}

namespace {

void add_operator(ui::MenuBuilder<Desk>& menu, const OperatorForm& form)
{
    const auto begin = [verb = form.verb](Desk& desk) {
        desk.session.begin(verb);
        show_operators(desk);
    };
    auto& row = menu.step({operator_ids[static_cast<std::size_t>(form.verb)], form.meaning}, begin);
    row.is_on = [verb = form.verb](const Desk& desk) {
        return desk.session.draft() && desk.session.draft()->form().verb == verb;
    };
    row.live_label = [&form](const Desk&) -> Phrase {
        return {translatable("{operator}: {meaning}"),
                {{"operator", std::string(form.name)}, {"meaning", Phrase(form.meaning)}}};
    };
}

} // namespace

void add_operator_commands(CommandTable& table)
{
    ui::MenuBuilder<Desk> menu(table, translatable("Operator"));
    for (const OperatorForm& form : operator_forms()) add_operator(menu, form);
    menu.toggle(
        {"operator.draw", translatable("Draw lines, and be told their operators"), {{Key::L, {}}}},
        [](const Desk& desk) { return desk.session.is_drawing(); },
        [](Desk& desk, bool) { desk.session.draw_or_look(); });
    menu.step(
        {"operator.accept", translatable("Apply the operator"), {{Key::Enter, {}}}},
        [](Desk& desk) { desk.session.accept(); }, why_not_accept);
    menu.step(
        {"operator.take_back", translatable("Take back the last argument"), {{Key::Backspace, {}}}},
        [](Desk& desk) { desk.session.take_back_choice(); }, needs_draft);
    menu.step({"operator.cancel", translatable("Give up the operator"), {{Key::Escape, {}}}}, cancel, why_not_cancel)
        .live_label = cancel_label;
    table.with_argument("operator.choose", [](Desk& desk, const ui::Argument& argument) {
        return desk.session.choose_typed(argument.text);
    });
}

} // namespace euler
