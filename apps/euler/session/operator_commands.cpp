#include "apps/euler/session/operator_commands.h"

#include <array>

namespace euler {

using ui::Key;
using ui::Phrase;
using ui::translatable;

namespace {

using Reason = std::optional<Phrase>;

constexpr std::string_view operator_menu = translatable("Operator");

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

void add_operator_commands(CommandTable& table)
{
    for (const OperatorForm& form : operator_forms()) {
        table.add({.id = operator_ids[static_cast<std::size_t>(form.verb)],
                   .menu = operator_menu,
                   .label = form.meaning,
                   .run =
                       [verb = form.verb](Desk& desk) {
                           desk.session.begin(verb);
                           show_operators(desk);
                       },
                   .is_on =
                       [verb = form.verb](const Desk& desk) {
                           return desk.session.draft() && desk.session.draft()->form().verb == verb;
                       },
                   .live_label = [&form](const Desk&) -> Phrase {
                       return {translatable("{operator}: {meaning}"),
                               {{"operator", std::string(form.name)}, {"meaning", Phrase(form.meaning)}}};
                   }});
    }
    table.add({.id = "operator.draw",
               .menu = operator_menu,
               .label = translatable("Draw lines, and be told their operators"),
               .shortcuts = {{Key::L, {}}},
               .run = [](Desk& desk) { desk.session.draw_or_look(); },
               .is_on = [](const Desk& desk) { return desk.session.is_drawing(); }});
    table.add({.id = "operator.accept",
               .menu = operator_menu,
               .label = translatable("Apply the operator"),
               .shortcuts = {{Key::Enter, {}}},
               .run = [](Desk& desk) { desk.session.accept(); },
               .why_not = why_not_accept});
    table.add({.id = "operator.take_back",
               .menu = operator_menu,
               .label = translatable("Take back the last argument"),
               .shortcuts = {{Key::Backspace, {}}},
               .run = [](Desk& desk) { desk.session.take_back_choice(); },
               .why_not = needs_draft});
    table.add({.id = "operator.cancel",
               .menu = operator_menu,
               .label = translatable("Give up the operator"),
               .shortcuts = {{Key::Escape, {}}},
               .run =
                   [](Desk& desk) {
                       if (desk.session.edited_text) return desk.session.give_up_text();
                       if (desk.session.is_drawing()) desk.session.draw_or_look();
                       desk.session.give_up();
                   },
               .why_not = [](const Desk& desk) -> Reason {
                   return desk.session.is_drawing() || desk.session.edited_text ? std::nullopt : needs_draft(desk);
               },
               .live_label = [](const Desk& desk) -> Phrase {
                   return desk.session.edited_text ? translatable("Give up the text")
                                                   : translatable("Give up the operator");
               }});
}

} // namespace euler
