#include "apps/euler/session/step_commands.h"

#include <algorithm>
#include <string>

namespace euler {

using ui::Key;
using ui::Phrase;
using ui::translatable;

namespace {

using Reason = std::optional<Phrase>;

constexpr std::string_view step_menu = translatable("Step");

Reason why_not_forward(const Desk& desk)
{
    if (desk.session.place() < desk.session.n_steps()) return std::nullopt;
    return translatable("this is the last step");
}

Reason why_not_back(const Desk& desk)
{
    if (desk.session.place() > 0 || desk.session.has_just_opened_sweep()) return std::nullopt;
    return translatable("nothing is done yet");
}

// "Back by KEV", "Forward by MEV": what the next key press would do.
Phrase back_label(const Desk& desk)
{
    const Session& session = desk.session;
    if (session.has_just_opened_sweep()) return translatable("Back to the sweep as one step");
    if (session.place() == 0) return translatable("Back");
    return {translatable("Back by {operator}"), {{"operator", session.stepper().report(session.place()).inverse_name}}};
}

Phrase forward_label(const Desk& desk)
{
    const Session& session = desk.session;
    if (session.place() == session.n_steps()) return translatable("Forward");
    return {translatable("Forward by {operator}"), {{"operator", session.stepper().summary(session.place() + 1).name}}};
}

void play_or_rest(Desk& desk)
{
    Session& session = desk.session;
    if (!session.is_playing && session.place() == session.n_steps()) session.go_to(0);
    session.is_playing = !session.is_playing;
}

void go(Desk& desk, std::size_t place)
{
    desk.session.is_playing = false;
    desk.session.go_to(place);
}

void change_speed(Desk& desk, double factor)
{
    desk.session.speed = std::clamp(desk.session.speed * factor, Session::slowest, Session::fastest);
}

void add_walk(CommandTable& table)
{
    table.add({.id = "step.first",
               .menu = step_menu,
               .label = translatable("To the beginning"),
               .shortcuts = {{Key::Home, {}}},
               .run = [](Desk& desk) { go(desk, 0); },
               .why_not = why_not_back});
    table.add({.id = "step.back",
               .menu = step_menu,
               .label = translatable("Back"),
               .shortcuts = {{Key::PageUp, {}}, {Key::Left, {}}, {Key::Z, ui::ctrl}},
               .run =
                   [](Desk& desk) {
                       desk.session.is_playing = false;
                       desk.session.step_back();
                   },
               .why_not = why_not_back,
               .live_label = back_label});
    table.add({.id = "step.forward",
               .menu = step_menu,
               .label = translatable("Forward"),
               .shortcuts = {{Key::PageDown, {}}, {Key::Right, {}}, {Key::Y, ui::ctrl}, {Key::Z, ui::ctrl_shift}},
               .run =
                   [](Desk& desk) {
                       desk.session.is_playing = false;
                       desk.session.step_forward();
                   },
               .why_not = why_not_forward,
               .live_label = forward_label});
    table.add({.id = "step.last",
               .menu = step_menu,
               .label = translatable("To the end"),
               .shortcuts = {{Key::End, {}}},
               .run = [](Desk& desk) { go(desk, desk.session.n_steps()); },
               .why_not = why_not_forward});
}

Reason why_not_open_sweep(const Desk& desk)
{
    const Session& session = desk.session;
    if (session.place() > 0 && session.stepper().is_sweep(session.place())) return std::nullopt;
    return translatable("the step that was done last is no sweep");
}

void add_opening(CommandTable& table)
{
    table.add({.id = "step.open_sweep",
               .menu = step_menu,
               .label = translatable("Open the sweep into MEV and MEF"),
               .shortcuts = {{Key::O, {}}},
               .run = [](Desk& desk) { desk.session.open_sweep(); },
               .why_not = why_not_open_sweep});
}

void add_player(CommandTable& table)
{
    table.add({.id = "step.play",
               .menu = step_menu,
               .label = translatable("Play"),
               .shortcuts = {{Key::Space, {}}},
               .run = play_or_rest,
               .why_not = [](const Desk& desk) -> Reason {
                   if (desk.session.n_steps() > 0) return std::nullopt;
                   return translatable("the script has no step");
               },
               .is_on = [](const Desk& desk) { return desk.session.is_playing; }});
    table.add({.id = "step.slower",
               .menu = step_menu,
               .label = translatable("Slower"),
               .shortcuts = {{Key::Down, {}}},
               .run = [](Desk& desk) { change_speed(desk, 0.5); }});
    table.add({.id = "step.faster",
               .menu = step_menu,
               .label = translatable("Faster"),
               .shortcuts = {{Key::Up, {}}},
               .run = [](Desk& desk) { change_speed(desk, 2.0); }});
}

} // namespace

void add_step_commands(CommandTable& table)
{
    add_walk(table);
    add_opening(table);
    add_player(table);
}

} // namespace euler
