#include "apps/euler/session/step_commands.h"

#include <algorithm>
#include <string>

namespace euler {

using ui::Key;
using ui::Phrase;
using ui::Reason;
using ui::translatable;

namespace {

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

void play(Desk& desk, bool is_on)
{
    Session& session = desk.session;
    if (is_on && session.place() == session.n_steps()) session.go_to(0);
    session.is_playing = is_on;
}

Reason why_not_play(const Desk& desk)
{
    if (desk.session.n_steps() > 0) return std::nullopt;
    return translatable("the script has no step");
}

void go(Desk& desk, std::size_t place)
{
    desk.session.is_playing = false;
    desk.session.go_to(place);
}

void go_back(Desk& desk)
{
    desk.session.is_playing = false;
    desk.session.step_back();
}

void go_forward(Desk& desk)
{
    desk.session.is_playing = false;
    desk.session.step_forward();
}

void change_speed(Desk& desk, double factor)
{
    desk.session.speed = std::clamp(desk.session.speed * factor, Session::slowest, Session::fastest);
}

Reason why_not_open_sweep(const Desk& desk)
{
    const Session& session = desk.session;
    if (session.place() > 0 && session.stepper().is_sweep(session.place())) return std::nullopt;
    return translatable("the step that was done last is no sweep");
}

// What a scenario gives: a step's number.
Reason go_to(Desk& desk, const ui::Argument& argument)
{
    const auto place = argument.number();
    const std::size_t most = desk.session.n_steps();
    if (!place || *place < 0.0 || *place > static_cast<double>(most))
        return argument.wanted("a step from 0 to " + std::to_string(most));
    desk.session.go_to(static_cast<std::size_t>(*place));
    return std::nullopt;
}

} // namespace

void add_step_commands(CommandTable& table)
{
    ui::MenuBuilder<Desk> menu(table, translatable("Step"));
    menu.step(
        {"step.first", translatable("To the beginning"), {{Key::Home, {}}}}, [](Desk& desk) { go(desk, 0); },
        why_not_back);
    menu.step({"step.back", translatable("Back"), {{Key::PageUp, {}}, {Key::Left, {}}, {Key::Z, ui::ctrl}}}, go_back,
              why_not_back)
        .live_label = back_label;
    menu.step({"step.forward",
               translatable("Forward"),
               {{Key::PageDown, {}}, {Key::Right, {}}, {Key::Y, ui::ctrl}, {Key::Z, ui::ctrl_shift}}},
              go_forward, why_not_forward)
        .live_label = forward_label;
    menu.step(
        {"step.last", translatable("To the end"), {{Key::End, {}}}},
        [](Desk& desk) { go(desk, desk.session.n_steps()); }, why_not_forward);
    menu.step(
        {"step.open_sweep", translatable("Open the sweep into MEV and MEF"), {{Key::O, {}}}},
        [](Desk& desk) { desk.session.open_sweep(); }, why_not_open_sweep);
    menu.toggle(
        {"step.play", translatable("Play"), {{Key::Space, {}}}},
        [](const Desk& desk) { return desk.session.is_playing; }, play, why_not_play);
    menu.step({"step.slower", translatable("Slower"), {{Key::Down, {}}}}, [](Desk& desk) { change_speed(desk, 0.5); });
    menu.step({"step.faster", translatable("Faster"), {{Key::Up, {}}}}, [](Desk& desk) { change_speed(desk, 2.0); });
    table.with_argument("step.go_to", go_to);
    table.with_argument("step.apply",
                        [](Desk& desk, const ui::Argument& line) { return desk.session.apply(line.text); });
}

} // namespace euler
