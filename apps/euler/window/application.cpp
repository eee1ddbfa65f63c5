#include "apps/euler/window/application.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "apps/euler/session/operator_commands.h"
#include "apps/euler/session/script_commands.h"
#include "apps/euler/window/challenges_panel.h"
#include "apps/euler/window/describe.h"
#include "apps/euler/window/entity_panel.h"
#include "apps/euler/window/gallery_panel.h"
#include "apps/euler/window/player_bar.h"
#include "apps/euler/window/step_panel.h"

template class ui::DocumentApp<euler::Workspace>;

namespace euler {

using ui::translatable;

Application::Application(ui::Context& context, const ui::Fonts& fonts, Session session)
    : DocumentApp(context, fonts, std::move(session), command_table(),
                  {.name = translatable("Cremona: Euler operators"),
                   .description = translatable("Script and solids in words"),
                   .files = {.extension = ".eul", .exports = {".svg", ".png", ".pdf"}},
                   .sides = {{17.0F, 23.0F}, {0.25F, 0.32F}}}),
      canvas_(fonts)
{}

void Application::handle_own_requests()
{
    using enum ui::StandardView;
    for (const Request request : std::exchange(workspace().requests, {})) {
        switch (request) {
        case Request::LookFront: Canvas::look(workspace().session, Front); break;
        case Request::LookSide: Canvas::look(workspace().session, Side); break;
        case Request::LookTop: Canvas::look(workspace().session, Top); break;
        case Request::WriteScript: script_.grab_keyboard(); break;
        }
    }
}

// While an operator is begun what is typed is its: letters bring its field back, Enter and Backspace end it where
// nothing is asked any more.
void Application::follow_draft()
{
    if (!session().draft() || ui::do_keys_go_elsewhere()) return;
    if (!session().draft()->is_complete()) {
        if (!ImGui::GetIO().InputQueueCharacters.empty()) show_operators(workspace());
        return;
    }
    const auto is_pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
    if (is_pressed(ImGuiKey_Enter)) run(*commands().find("operator.accept"), workspace());
    else if (is_pressed(ImGuiKey_Backspace)) run(*commands().find("operator.take_back"), workspace());
}

void Application::show_body()
{
    workspace().session.hover.reset(); // a row or the picture names it anew
    follow_draft();
    if (session().edited_text && std::exchange(workspace().session.is_fault_new, false)) {
        script_.go_to_line(*session().faulty_line);
        show_script(workspace());
    }
    const float most = 0.4F * ImGui::GetContentRegionAvail().y;
    const float below = workspace().has_tables ? std::min(tables_height_ * ImGui::GetFontSize(), most) : 0.0F;
    show_panels_and_canvas_above(below, [this] { tables_.show(workspace()); });
}

void Application::settle_fields()
{
    DocumentApp::settle_fields();
    if (shows_script()) script_.settle(workspace().session);
}

void Application::show_left()
{
    ui::show_topics(workspace(), topics());
    switch (workspace().topic) {
    case Topic::Script: script_.show(workspace(), commands()); break;
    case Topic::Operators: operators_.show(workspace(), commands()); break;
    case Topic::Gallery: gallery_panel(workspace(), commands()); break;
    case Topic::Challenges: challenges_panel(workspace(), commands()); break;
    }
}

void Application::show_right()
{
    step_panel(workspace(), commands(), gui());
    entity_panel(workspace().session, gui(), fonts());
}

void Application::show_canvas()
{
    const float bar = 1.25F * ImGui::GetFrameHeight() + 0.6F * ImGui::GetFontSize();
    if (!workspace().has_panels) step_caption(session(), gui());
    ui::picture_area(bar, [this] { canvas_.show(workspace().session, gui()); });
    ui::button_bar("###player", bar, [this] { player_bar(workspace(), commands(), gui(), fonts()); });
}

// How many there are of everything now, and whether the solid is sound.
void Application::show_status() const { ui::status_bar(status_text(session())); }

std::string Application::words() const { return description(session()); }

} // namespace euler
