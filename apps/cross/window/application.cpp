#include "apps/cross/window/application.h"

#include <imgui.h>

#include <exception>
#include <utility>

#include "apps/cross/report/calculation.h"
#include "apps/cross/session/report.h"
#include "apps/cross/window/player_bar.h"
#include "apps/cross/window/results_panel.h"
#include "femoop/files/whole_file.h"
#include "femoop/tabular/latex.h"
#include "femoop/tabular/markdown.h"
#include "ui/files/ending.h"
#include "ui/report/html.h"
#include "ui/report/pages.h"
#include "ui/widgets/yes_or_no.h"
#include "ui/workbench/file_sentences.h"

template class ui::DocumentApp<cross::Workspace>;

namespace cross {

using ui::translatable;

Application::Application(ui::Context& context, const ui::Fonts& fonts, Session session)
    : DocumentApp(context, fonts, std::move(session), command_table(),
                  {.name = translatable("Cremona: moment distribution"),
                   .description = translatable("Sheet in words"),
                   .files = {.extension = ".json",
                             .exports = {".svg", ".png", ".pdf", ".report.pdf", ".html", ".csv", ".md", ".tex"}},
                   .sides = {{17.0F, 24.0F}, {0.22F, 0.28F}}}),
      canvas_(fonts)
{}

void Application::show_left()
{
    if (session().worksheet() != nullptr) exercise_panel_.show_beginning(workspace(), commands());
    else method_panel_.show(workspace(), commands());
}

void Application::show_right()
{
    if (!session().hides_results()) results_panel(workspace(), commands());
    const bool is_asked = workspace().topic == Topic::Exercises;
    if (session().worksheet() != nullptr && (session().hides_results() || is_asked))
        exercise_panel_.show_worksheet(workspace(), commands(), canvas_.cell_field(),
                                       is_drawn(session(), canvas_.drawn()));
    else if (is_asked) exercise_panel_.show_beginning(workspace(), commands());
}

void Application::show_own_dialogs()
{
    ui::ask_to_end_exercise(workspace(),
                            translatable("The exercise is not done yet. Its end shows what belongs in every cell."));
}

void Application::show_canvas()
{
    const bool has_bar = session().worksheet() == nullptr; // a pupil has nothing to play
    const float bar = has_bar ? ImGui::GetFrameHeight() + 0.8F * ImGui::GetFontSize() : 0.0F;
    ui::picture_area(bar, [this] { canvas_.show(workspace().session, gui(), workspace().has_panels); });
    if (has_bar) ui::button_bar("###player", bar, [this] { player_bar(workspace(), commands()); });
}

void Application::show_status() const { ui::status_bar(status_text(session())); }

std::string Application::words() const { return description(session()); }

std::optional<ui::Message> Application::write(const std::filesystem::path& path)
{
    const auto is_a = [&](std::string_view ending) { return ui::has_ending(path, ending); };
    if (is_a(".html") || is_a(".report.pdf")) {
        if (session().hides_results()) return ui::Message(translatable("the exercise is not solved yet"));
        return write_report(path);
    }
    if (!is_a(".csv") && !is_a(".md") && !is_a(".tex")) return DocumentApp::write(path);
    if (!session().solution().task) return ui::Message(translatable("this structure cannot be distributed"));
    const tabular::Table table = table_of(session(), workspace().topic);
    std::string text;
    if (is_a(".csv")) text = separated(table, separators(session().tr().language()));
    else text = is_a(".md") ? markdown(table) : latex(table);
    const std::error_code error = files::write_whole_file(path, text);
    if (!error) return std::nullopt;
    return ui::not_written(path, error.message());
}

std::optional<ui::Message> Application::write_report(const std::filesystem::path& path) const
{
    try {
        const ui::Report report = calculation(session().document(), session().look, fonts());
        if (ui::has_ending(path, ".html")) {
            const std::error_code error = files::write_whole_file(path, ui::report_html(report, fonts()));
            return error ? std::optional(ui::not_written(path, error.message())) : std::nullopt;
        }
        ui::write_pdf(path, ui::report_pages(report, fonts()), fonts(),
                      {.background = ui::rgb(0xFFFFFF), .title = report.title});
        return std::nullopt;
    } catch (const std::exception& error) {
        return ui::not_written(path, error);
    }
}

} // namespace cross
