#include "apps/mohr/window/application.h"

#include <imgui.h>

#include <utility>

#include "apps/mohr/session/export.h"
#include "apps/mohr/session/report.h"
#include "apps/mohr/window/construction_panel.h"
#include "apps/mohr/window/results_panel.h"
#include "ui/widgets/wrapped_text.h"
#include "ui/widgets/yes_or_no.h"

template class ui::DocumentApp<mohr::Workspace>;

namespace mohr {

using ui::translatable;

Application::Application(ui::Context& context, const ui::Fonts& fonts, Session session)
    : DocumentApp(context, fonts, std::move(session), command_table(),
                  {.name = translatable("Cremona: Mohr's circle"),
                   .description = translatable("State in words"),
                   .files = {.extension = ".mohr", .exports = {".svg", ".png", ".pdf", ".csv", ".json", ".md", ".tex"}},
                   .sides = {{17.0F, 20.0F}, {0.25F, 0.3F}}}),
      canvas_(fonts)
{}

void Application::show_left()
{
    ui::show_topics(workspace(), topics());
    switch (workspace().topic) {
    case Topic::State: state_panel_.show(workspace(), commands()); break;
    case Topic::Construction: construction_panel(workspace(), commands(), gui()); break;
    case Topic::Exercises: exercises_panel_.show(workspace(), commands()); break;
    }
}

void Application::show_right()
{
    if (session().is_concealing()) ui::wrapped_text(session().tr()("The results are shown when the exercise is done."));
    else results_panel(session(), gui());
}

void Application::show_own_dialogs()
{
    ui::ask_to_end_exercise(workspace(), translatable("The exercise is not done yet. Its answers are not kept."));
}

void Application::show_canvas()
{
    ui::picture_area(0.0F, [this] { canvas_.show(workspace().session, gui()); });
}

void Application::show_status() const
{
    ui::status_bar(session().is_concealing() ? session().tr()("Exercise") : status_text(session()));
}

std::string Application::words() const { return description(session()); }

std::optional<ui::Message> Application::write(const std::filesystem::path& path)
{
    const auto results = export_results(session(), path);
    return results ? results->reason : DocumentApp::write(path);
}

} // namespace mohr
