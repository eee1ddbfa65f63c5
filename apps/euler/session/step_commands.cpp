#include "apps/euler/session/step_commands.h"

#include <algorithm>
#include <string>

namespace euler {

using ui::Key;
using ui::Message;
using ui::Reason;
using ui::translatable;

namespace {

Reason why_not_forward(const Workspace& workspace)
{
    if (workspace.session.place() < workspace.session.n_steps()) return std::nullopt;
    return translatable("this is the last step");
}

Reason why_not_back(const Workspace& workspace)
{
    if (workspace.session.place() > 0 || workspace.session.has_just_opened_sweep()) return std::nullopt;
    return translatable("nothing is done yet");
}

// "Back by KEV", "Forward by MEV": what the next key press would do.
Message back_label(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (session.has_just_opened_sweep()) return translatable("Back to the sweep as one step");
    if (session.place() == 0) return translatable("Back");
    return {translatable("Back by {operator}"), {{"operator", session.stepper().report(session.place()).inverse_name}}};
}

Message forward_label(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (session.place() == session.n_steps()) return translatable("Forward");
    return {translatable("Forward by {operator}"), {{"operator", session.stepper().summary(session.place() + 1).name}}};
}

void play(Workspace& workspace, bool is_on)
{
    Session& session = workspace.session;
    if (is_on && session.place() == session.n_steps()) session.go_to(0);
    session.is_playing = is_on;
}

Reason why_not_play(const Workspace& workspace)
{
    if (workspace.session.n_steps() > 0) return std::nullopt;
    return translatable("the script has no step");
}

void go(Workspace& workspace, std::size_t place)
{
    workspace.session.is_playing = false;
    workspace.session.go_to(place);
}

void go_back(Workspace& workspace)
{
    workspace.session.is_playing = false;
    workspace.session.step_back();
}

void go_forward(Workspace& workspace)
{
    workspace.session.is_playing = false;
    workspace.session.step_forward();
}

void change_speed(Workspace& workspace, double factor)
{
    workspace.session.speed = std::clamp(workspace.session.speed * factor, Session::slowest, Session::fastest);
}

Reason why_not_open_sweep(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (session.place() > 0 && session.stepper().is_sweep(session.place())) return std::nullopt;
    return translatable("the step that was done last is no sweep");
}

// What a scenario gives: a step's number.
Reason go_to(Workspace& workspace, const ui::Argument& argument)
{
    const auto place = argument.number();
    const std::size_t most = workspace.session.n_steps();
    if (!place || *place < 0.0 || *place > static_cast<double>(most))
        return argument.wanted("a step from 0 to " + std::to_string(most));
    workspace.session.go_to(static_cast<std::size_t>(*place));
    return std::nullopt;
}

} // namespace

void add_step_commands(CommandTable& table)
{
    ui::MenuBuilder<Workspace> menu(table, translatable("Step"));
    menu.step(
        {"step.first", translatable("To the beginning"), {{Key::Home, {}}}},
        [](Workspace& workspace) { go(workspace, 0); }, why_not_back);
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
        [](Workspace& workspace) { go(workspace, workspace.session.n_steps()); }, why_not_forward);
    menu.step(
        {"step.open_sweep", translatable("Open the sweep into MEV and MEF"), {{Key::O, {}}}},
        [](Workspace& workspace) { workspace.session.open_sweep(); }, why_not_open_sweep);
    menu.toggle(
        {"step.play", translatable("Play"), {{Key::Space, {}}}},
        [](const Workspace& workspace) { return workspace.session.is_playing; }, play, why_not_play);
    menu.step({"step.slower", translatable("Slower"), {{Key::Down, {}}}},
              [](Workspace& workspace) { change_speed(workspace, 0.5); });
    menu.step({"step.faster", translatable("Faster"), {{Key::Up, {}}}},
              [](Workspace& workspace) { change_speed(workspace, 2.0); });
    table.with_argument("step.go_to", go_to);
    table.with_argument("step.apply", [](Workspace& workspace, const ui::Argument& line) {
        return workspace.session.apply(line.text);
    });
}

} // namespace euler
