#include "apps/euler/window/application.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "apps/euler/window/challenges_panel.h"
#include "apps/euler/window/describe.h"
#include "apps/euler/window/entity_panel.h"
#include "apps/euler/window/gallery_panel.h"
#include "apps/euler/window/player_bar.h"
#include "apps/euler/window/script_panel.h"
#include "apps/euler/window/step_panel.h"
#include "ui/context/image_clipboard.h"
#include "ui/context/write_picture.h"
#include "ui/text/shortened.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/shortcut_sheet.h"
#include "ui/widgets/unsaved_question.h"

namespace euler {

using ui::translatable;

Application::Application(ui::Context& context, const ui::Fonts& fonts, Session session)
    : desk_{.session = std::move(session)},
      commands_(command_table()),
      gui_(context, fonts, ui::Theme(desk_.session.look.theme)),
      context_(context),
      fonts_(fonts),
      canvas_(fonts),
      theme_(desk_.session.look.theme)
{}

bool Application::is_moving() const
{
    return session().is_moving() || (session().notice && session().notice->seconds_left);
}

std::string Application::window_title() const
{
    return (session().is_dirty() ? "*" : "") + session().file_name() + " – " +
           session().tr()("Cremona: Euler operators");
}

void Application::ask_to_quit() { leave_lesson(desk_, asks(Request::Quit)); }

void Application::explain(const ui::Phrase& reason) { desk_.session.notice = passing_notice(reason); }

void Application::frame(const ui::Input& input)
{
    if (theme_ != session().look.theme) {
        theme_ = session().look.theme;
        gui_.set_theme(ui::Theme(theme_));
    }
    take_files(input.dropped_files);
    gui_.begin_frame(input);
    take_keys(input);
    desk_.session.tick(input.seconds);
    desk_.session.hover.reset();
    show_menu_bar();
    show_body();
    show_dialogs();
    take_requests();
    gui_.end_frame();
}

// Files that were dropped on the window.
void Application::take_files(const std::vector<std::string>& files)
{
    if (files.empty()) return;
    leave_lesson(desk_, [path = files.front()](Desk& desk) { desk.session.open(path); });
}

void Application::take_keys(const ui::Input& input)
{
    const bool is_popup_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    if (palette_.is_open() || path_dialog_.is_open() || desk_.after_question || is_popup_open) return;
    const bool types = ImGui::GetIO().WantTextInput || operators_.is_typing();
    for (const ui::KeyEvent& event : input.keys) {
        const bool is_for_field = types && event.key != ui::Key::Escape && !event.modifiers.ctrl;
        if (!event.is_down || is_for_field) continue;
        const bool is_escape = event.key == ui::Key::Escape;
        if (is_escape && (std::exchange(shows_shortcuts_, false) || std::exchange(shows_description_, false))) continue;
        const auto* const command = commands_.find(event.chord());
        if (command == nullptr) continue;
        const auto reason = run(*command, desk_);
        if (reason && !is_escape) explain(*reason);
    }
}

namespace {

// Beside the script's own file, under its name.
std::filesystem::path export_name(const Session& session)
{
    std::filesystem::path path = session.path().value_or("picture.eul");
    return path.replace_extension(".svg");
}

} // namespace

// An export that was given up before is forgotten.
void Application::ask_for_path(ui::PathDialog::Purpose purpose, const std::filesystem::path& start)
{
    is_exporting_ = false;
    path_dialog_.open(purpose, start, ".eul");
}

void Application::take_requests()
{
    for (const Request request : std::exchange(desk_.requests, {})) take(request);
}

void Application::take(Request request)
{
    using enum ui::StandardView;
    Session& session = desk_.session;
    const std::filesystem::path start = session.path().value_or("");
    switch (request) {
    case Request::OpenDialog: ask_for_path(ui::PathDialog::Purpose::Open, start); break;
    case Request::SaveDialog: ask_for_path(ui::PathDialog::Purpose::Save, start); break;
    case Request::ExportDialog:
        is_exporting_ = true;
        path_dialog_.open(ui::PathDialog::Purpose::Save, export_name(session), ".svg");
        break;
    case Request::CopyPicture: copy_picture(); break;
    case Request::Palette: palette_.open(); break;
    case Request::ShortcutList: shows_shortcuts_ = !shows_shortcuts_; break;
    case Request::Description: shows_description_ = !shows_description_; break;
    case Request::Fit: session.is_fitted = true; break;
    case Request::ZoomIn: canvas_.zoom(session, 1.25); break;
    case Request::ZoomOut: canvas_.zoom(session, 0.8); break;
    case Request::LookIsometric: Canvas::look(session, Isometric); break;
    case Request::LookFront: Canvas::look(session, Front); break;
    case Request::LookSide: Canvas::look(session, Side); break;
    case Request::LookTop: Canvas::look(session, Top); break;
    case Request::Quit: wants_to_quit_ = true; break;
    }
}

void Application::show_menu_bar()
{
    if (!ImGui::BeginMainMenuBar()) return;
    ui::show_menus(commands_, desk_, session().tr());
    const std::string name = (session().is_dirty() ? "* " : "") + session().file_name();
    ui::menu_bar_title(name);
    ImGui::EndMainMenuBar();
}

void Application::show_body()
{
    ui::begin_body();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float below = desk_.has_tables ? std::min(tables_height_ * ImGui::GetFontSize(), 0.4F * room.y) : 0.0F;
    if (below > 0.0F) ui::show_below(below, [this] { tables_.show(desk_); });
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U); // the picture is drawn on the theme's own background
    ImGui::BeginChild("###above", {0.0F, room.y - below});
    ImGui::PopStyleColor();
    const auto left = [this](float width) { show_left(width); };
    const auto right = [this](float width) { show_right(width); };
    const auto picture = [this] { show_canvas(); };
    if (desk_.has_panels) sides_.show(left, right, picture);
    else picture();
    ImGui::EndChild();
    ui::end_body();
    show_status_bar();
}

void Application::show_left(float width)
{
    ui::begin_panel("###left", width);
    ui::TabRow row;
    for (const TopicEntry& entry : topics()) {
        const std::string title = session().tr()(entry.label) + "###" + std::string(entry.id);
        if (row.show(title, entry.topic == desk_.topic)) desk_.topic = entry.topic;
    }
    ImGui::Separator();
    switch (desk_.topic) {
    case Topic::Script: script_panel(desk_); break;
    case Topic::Operators: operators_.show(desk_, commands_); break;
    case Topic::Gallery: gallery_panel(desk_, commands_); break;
    case Topic::Challenges: challenges_panel(desk_, commands_); break;
    }
    ui::end_panel();
}

void Application::show_right(float width)
{
    ui::begin_panel("###right", width);
    step_panel(session(), gui_);
    entity_panel(desk_.session, gui_, fonts_);
    ui::end_panel();
}

void Application::show_canvas()
{
    const float em = ImGui::GetFontSize();
    const float bar = 1.25F * ImGui::GetFrameHeight() + 0.6F * em;
    if (!desk_.has_panels) step_caption(session(), gui_);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U);
    ImGui::BeginChild("###picture", {room.x, room.y - bar}, false, ImGuiWindowFlags_NoNav); // its keys are commands
    ImGui::PopStyleColor();
    canvas_.show(desk_.session, gui_);
    show_notice();
    ImGui::EndChild();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.4F * em, 0.3F * em});
    ImGui::BeginChild("###player", {0.0F, bar}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    player_bar(desk_, commands_, gui_, fonts_);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void Application::show_notice()
{
    if (!session().notice) return;
    const ui::Catalogue& tr = session().tr();
    ui::begin_message_box({tr(session().notice->sentence)});
    const bool is_closed = ImGui::Button((tr("Close") + "###close notice").c_str());
    ui::end_message_box();
    if (is_closed) desk_.session.notice.reset();
}

// How many there are of everything now, and whether the solid is sound.
void Application::show_status_bar()
{
    ui::begin_status_bar();
    ImGui::TextUnformatted(ui::shortened(status_text(session()), 400).c_str());
    ui::end_status_bar();
}

void Application::show_dialogs()
{
    const ui::Catalogue tr = session().tr(); // a command may change the language
    if (const auto path = path_dialog_.show(tr)) {
        if (std::exchange(is_exporting_, false)) export_as(*path);
        else if (path_dialog_.purpose() == ui::PathDialog::Purpose::Open) desk_.session.open(*path);
        else desk_.session.save(*path);
    }
    palette_.show(commands_, desk_, tr);
    if (shows_shortcuts_) ui::shortcut_sheet(ui::key_lines(commands_, desk_, tr), tr, shows_shortcuts_);
    if (shows_description_) description_window(session(), shows_description_);
    if (desk_.after_question) ask_about_unsaved();
}

// What was asked for goes on once the steps are saved or given up.
void Application::ask_about_unsaved()
{
    using enum ui::UnsavedAnswer;
    const auto answer = ui::ask_about_unsaved(session().file_name(), session().tr());
    if (!answer) return;
    const auto then = std::exchange(desk_.after_question, {});
    const auto& path = session().path();
    if (*answer == Save && !path) desk_.requests.push_back(Request::SaveDialog);
    const bool goes_on = *answer == GiveUp || (*answer == Save && path && desk_.session.save(*path));
    if (goes_on) then(desk_);
}

std::optional<ui::Phrase> Application::export_as(const std::filesystem::path& path)
{
    const ui::PictureLook look{.background = ui::Theme(session().look.theme).background(),
                               .title = session().file_name(),
                               .png_scale = desk_.export_scale};
    const auto reason = ui::write_picture(path, canvas_.picture_of(session()), fonts_, look);
    context_.make_current(); // a PNG is drawn in a context of its own
    explain(reason.value_or(ui::Phrase(translatable("{file} was written"), {{"file", path.filename().string()}})));
    return reason;
}

void Application::copy_picture()
{
    const ui::PictureLook look{
        .background = ui::Theme(session().look.theme).background(), .title = "", .png_scale = desk_.export_scale};
    const auto reason = ui::copy_picture(canvas_.picture_of(session()), fonts_, look);
    context_.make_current(); // it is drawn in a context of its own
    explain(reason.value_or(ui::Phrase(translatable("the picture was copied"))));
}

} // namespace euler
