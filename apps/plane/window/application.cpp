#include "apps/plane/window/application.h"

#include <imgui.h>

#include <utility>

#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/window/foot.h"
#include "apps/plane/window/properties_panel.h"
#include "apps/plane/window/side_panels.h"
#include "apps/plane/window/tool_bar.h"
#include "ui/widgets/player_bar.h"

template class ui::DocumentApp<plane::Workspace>;

namespace plane {

using ui::translatable;

Application::Application(ui::Context& context, const ui::Fonts& fonts, Session session)
    : DocumentApp(context, fonts, std::move(session), command_table(),
                  {.name = translatable("Cremona: plates"),
                   .description = translatable("Drawing in words"),
                   .files = {.extension = ".json", .exports = {".svg", ".png", ".pdf"}},
                   .sides = {{12.0F, 20.0F}, {0.2F, 0.32F}}}),
      canvas_(fonts)
{}

// ---- keys

namespace {

/// A key that writes a letter, which a place that is being typed takes.
bool writes_letter(ui::Key key)
{
    return key <= ui::Key::Digit9 || key == ui::Key::Space || key == ui::Key::Plus || key == ui::Key::Minus;
}

} // namespace

// Those of a place that is typed; what is left are commands.
std::vector<ui::KeyEvent> Application::take_keys(const ui::Input& input)
{
    const bool types = ImGui::GetIO().WantTextInput || is_typing();
    Hand& hand = workspace().hand;
    const bool types_place = !types && hand.draws() && !input.modifiers.ctrl && hand.type(input.text);
    std::vector<ui::KeyEvent> left;
    for (const ui::KeyEvent& event : input.keys) {
        if (!event.is_down || (!event.modifiers.ctrl && unit_window_.wants(event.key))) continue;
        const bool takes_back = event.key == ui::Key::Z && event.modifiers.ctrl && !event.modifiers.shift;
        if (takes_back && canvas_.cancel(workspace())) continue; // a drag is taken back as a whole
        if (!types && (handle_typing(event.key) || handle_presenter(event.key))) continue;
        if (!types_place || !writes_letter(event.key) || event.modifiers.ctrl) left.push_back(event);
    }
    return left;
}

// Page down, as a presenter sends it, takes the next step of a mesh that is watched, and the next of modes that are
// shown; else the next load case.
bool Application::handle_presenter(ui::Key key)
{
    std::string_view command;
    if (session().player() != nullptr) command = key == ui::Key::PageDown ? "mesher.forward" : "";
    else if (session().modes() != nullptr)
        command = key == ui::Key::PageDown ? "results.next_mode"
                  : key == ui::Key::PageUp ? "results.previous_mode"
                                           : "";
    if (command.empty()) return false;
    run(*commands().find(command), workspace());
    return true;
}

// The keys that end or mend a place that is typed while drawing.
bool Application::handle_typing(ui::Key key)
{
    Hand& hand = workspace().hand;
    if (hand.typed().empty() || (key != ui::Key::Backspace && key != ui::Key::Enter)) return false;
    if (key == ui::Key::Backspace) {
        hand.backspace();
        return true;
    }
    const auto place = hand.typed_place(session().model().units, session().units());
    if (!place) {
        workspace().notify(
            hand.has_begun() ? translatable("wanted a place: 60, 20 or @30, 10 from the last one or 40<30 or a length")
                             : translatable("wanted a place, such as 60, 20"));
        return true;
    }
    if (is_out_of_reach(session().model(), *place)) {
        workspace().notify(translatable("the place lies a million times as far off as the drawing is wide"));
        return true;
    }
    type_place(workspace(), *place);
    hand.forget_typed();
    return true;
}

bool Application::close_topmost()
{
    if (DocumentApp::close_topmost() || unit_window_.close()) return true;
    if (ImGui::GetIO().WantTextInput || is_typing()) return true; // the field gives up what is typed
    if (session().is_refining()) workspace().session.stop_refining();
    else if (session().run() != nullptr) workspace().session.give_up_analysis();
    else return canvas_.cancel(workspace());
    return true;
}

void Application::handle_own_requests()
{
    if (std::exchange(workspace().asks_for_outline, false))
        insert_dialog_.open_any(session().path().value_or(""), {".dxf", ".svg"});
    if (std::exchange(workspace().asks_for_backdrop, false))
        backdrop_dialog_.open_any(session().path().value_or(""), {".png", ".jpg", ".jpeg"});
    if (std::exchange(workspace().asks_for_units, false)) unit_window_.toggle();
}

void Application::show_own_dialogs()
{
    if (const auto path = insert_dialog_.show(session().tr())) workspace().insert_outline(*path);
    if (const auto path = backdrop_dialog_.show(session().tr())) workspace().insert_backdrop(*path);
    unit_window_.show(workspace().session.look.unit_choices, session().units(), session().tr(), fields_.stops());
}

// ---- what is shown

std::optional<ui::FootMessage> Application::foot_message() const
{
    auto told = DocumentApp::foot_message();
    const auto own = foot_of(workspace());
    if (!told || !own || !session().notice) return told ? told : own;
    // what the app asks is not hidden by a notice, whose button comes last
    told->lines.insert(told->lines.end(), own->lines.begin(), own->lines.end());
    told->buttons.insert(told->buttons.begin(), own->buttons.begin(), own->buttons.end());
    return told;
}

void Application::answer(const ui::FootMessage& message, std::size_t pressed)
{
    const bool is_of_notice = session().notice && pressed + 1 == message.buttons.size();
    const bool is_of_offer = !session().notice && !workspace().offer.empty();
    if (is_of_notice || is_of_offer) DocumentApp::answer(message, pressed);
    else answer_foot(workspace(), commands(), pressed);
}

void Application::show_body()
{
    const float below = tables_.height(workspace(), ImGui::GetContentRegionAvail().y);
    show_panels_and_canvas_above(below, [this] { tables_.show(workspace(), commands()); });
}

void Application::show_left() { show_panel(workspace(), commands(), fields_); }

void Application::show_right()
{
    ui::show_topics(workspace(), topics());
    switch (workspace().topic) {
    case Topic::Properties: properties_panel(workspace(), commands(), fields_); break;
    case Topic::Model: model_panel(workspace(), commands(), fields_); break;
    case Topic::Problems: problems_panel(workspace(), commands()); break;
    }
}

void Application::show_canvas()
{
    const float row = ImGui::GetFrameHeight(), gap = 0.6F * ImGui::GetFontSize();
    if (has_tools())
        ui::button_bar("###tools", 1.25F * row + gap, [this] { tool_bar(workspace(), commands(), gui(), fonts()); });
    const float bar = session().player() != nullptr ? 1.25F * row + gap : 0.0F;
    ui::picture_area(bar, [this] { canvas_.show(workspace(), gui()); });
    if (bar > 0.0F) ui::button_bar("###player", bar, [this] { show_player(); });
}

/// The steps of the mesh that is watched.
void Application::show_player()
{
    Session& watching = workspace().session;
    const discretize::MeshPlayer* const player = watching.player();
    if (player == nullptr) return; // a drag has changed the drawing
    const ui::PlayerCommands names{"mesher.first", "mesher.back", "mesher.play", "mesher.forward", "mesher.last"};
    const ui::PlayerSteps steps{.place = player->place(), .n = player->n_steps(), .speed = watching.watch.speed};
    const ui::PlayerChange change = ui::player_bar(workspace(), commands(), names, watching.watch.is_playing(), steps,
                                                   ui::Theme(watching.look.theme), gui(), fonts());
    if (change.speed) watching.watch.speed = *change.speed;
    if (change.place && watching.player() != nullptr) watching.watch.go_to(*change.place);
}

void Application::show_status() const { ui::status_bar(status_text(session())); }

std::string Application::words() const { return description(session()); }

} // namespace plane
