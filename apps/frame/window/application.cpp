#include "apps/frame/window/application.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "apps/frame/session/property_commands.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/session/view_commands.h"
#include "apps/frame/session/work.h"
#include "apps/frame/window/banner.h"
#include "apps/frame/window/description_window.h"
#include "apps/frame/window/document_tabs.h"
#include "apps/frame/window/properties_panel.h"
#include "apps/frame/window/results_panel.h"
#include "apps/frame/window/show_panel.h"
#include "apps/frame/window/status_bar.h"
#include "apps/frame/window/tool_bar.h"
#include "apps/frame/window/transform_bar.h"
#include "ui/files/link.h"
#include "ui/widgets/panel.h"

namespace frame {

using ui::translatable;

namespace {

constexpr double seconds_per_swing = 2.4;
constexpr double full_swing = 0.25 * seconds_per_swing; // a still picture shows the full displacement

} // namespace

Application::Application(ui::Context& context, const ui::Fonts& fonts, Session session)
    : workspace_(std::move(session)),
      commands_(command_table()),
      gui_(context, fonts, ui::Theme(workspace_.session.view.theme)),
      context_(context),
      fonts_(fonts),
      canvas_(fonts),
      typical_window_(fonts),
      section_window_(fonts),
      theme_(workspace_.session.view.theme),
      time_(full_swing)
{}

bool Application::is_moving() const
{
    const Session& session = workspace_.session;
    const bool has_passing_notice = session.notice && session.notice->seconds_left;
    const bool is_walking = workspace_.bottom.shows(BottomContent::Solver) && workspace_.solver.is_playing();
    return is_swinging() || is_walking || has_passing_notice;
}

bool Application::is_swinging() const
{
    return workspace_.session.is_animated || !workspace_.session.shown_mechanisms().empty();
}

std::string Application::window_title() const
{
    const Session& session = workspace_.session;
    return (session.is_dirty() ? "*" : "") + tab_name(workspace_, workspace_.tab) + " – " +
           session.view.tr("Cremona: frames");
}

void Application::ask_to_quit() { questions_.ask_to_quit(); }

void Application::remember_in(const ui::DraftFolder& folder) { session_store_ = ui::SessionStore(folder); }

void Application::animate(double seconds)
{
    time_ = is_swinging() ? time_ + seconds : full_swing;
    workspace_.session.draw_state.phase = std::sin(2.0 * std::numbers::pi * time_ / seconds_per_swing);
}

void Application::frame(const ui::Input& input)
{
    if (theme_ != workspace_.session.view.theme) {
        theme_ = workspace_.session.view.theme;
        gui_.set_theme(ui::Theme(theme_));
    }
    handle_files(input.dropped_files);
    gui_.begin_frame(input);
    handle_keys(input);
    linked_.tick(input.seconds, workspace_);
    workspace_.offer = linked_.offering(workspace_);
    animate(input.seconds);
    if (workspace_.bottom.shows(BottomContent::Solver)) workspace_.solver.advance(input.seconds);
    ui::tick(workspace_.session.notice, input.seconds);
    show_menu_bar();
    show_body();
    show_dialogs();
    handle_requests();
    if (workspace_.transform && !workspace_.session.history().is_dragging())
        workspace_.transform.reset(); // something else ended it
    session_store_.tick(workspace_, ui::logical_size(context_), input.seconds);
    had_popup_ = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    gui_.end_frame();
}

// Files that were dropped on the window.
void Application::handle_files(const std::vector<std::string>& files)
{
    const bool is_choosing = workspace_.typical.is_open() || workspace_.section.is_open() || questions_.is_open();
    if (is_choosing && !files.empty()) return explain(translatable("finish what is being made in the window first"));
    for (const std::string& file : files) open_file(workspace_, file);
}

void Application::explain(const ui::Message& reason) { workspace_.session.notify(reason); }

// What Escape is for first: to put away what lies over the picture.
bool Application::close_topmost_window() { return dialogs_.close_topmost() || view_list_.close(); }

namespace {

// A key that writes a letter, which a place that is being typed takes.
bool writes(ui::Key key)
{
    return key <= ui::Key::Digit9 || key == ui::Key::Space || key == ui::Key::Plus || key == ui::Key::Minus;
}

} // namespace

void Application::handle_keys(const ui::Input& all)
{
    const bool is_popup_open = had_popup_ || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    const bool is_blocked = dialogs_.wants_keys() || questions_.is_open() || session_store_.is_open() ||
                            tables_.is_asking() || is_popup_open;
    if (is_blocked) return TablesPanel::lend_keyboard();
    const ui::Input input = tables_.take(workspace_, all);
    const bool types = ImGui::GetIO().WantTextInput || fields_.is_typing();
    const bool types_place = !types && !input.modifiers.ctrl && workspace_.tool_controller.type(input.text);
    for (const ui::KeyEvent& event : input.keys) {
        if (!event.is_down || (types && !event.modifiers.ctrl && !ui::is_function_key(event.key))) continue;
        if (!types && kind_question_.take(workspace_, commands_, event.key)) continue;
        if (!types && handle_typing(event.key)) continue;
        if (types_place && writes(event.key) && !event.modifiers.ctrl) continue;
        if (event.key == ui::Key::Escape && close_topmost_window()) continue;
        if (event.key == ui::Key::Escape && workspace_.session.history().is_dragging()) {
            workspace_.tool_controller.tool().escape(); // else it would go on with what is taken back
            workspace_.session.cancel();
            continue;
        }
        const auto* const command = commands_.find(event.chord());
        const bool is_edit_of_text = types && command != nullptr && command->id.starts_with("edit.");
        if (command == nullptr || is_edit_of_text) continue;
        const auto reason = run(*command, workspace_);
        if (reason && !command->menu.empty()) explain(*reason);
    }
}

// The keys that end or mend a place that is typed while drawing.
bool Application::handle_typing(ui::Key key)
{
    if (workspace_.tool_controller.typed().empty()) return false;
    if (key == ui::Key::Backspace) workspace_.tool_controller.backspace();
    if (key == ui::Key::Enter) {
        // Where no model can have a node, what was begun is given up with it.
        const auto change = workspace_.tool_controller.enter(work_of(workspace_.session));
        if (change && !workspace_.session.change_soundly(*change)) workspace_.tool_controller.tool().escape();
        if (!workspace_.tool_controller.typed().empty())
            explain(workspace_.tool_controller.why_not_enter(work_of(workspace_.session)));
    }
    return key == ui::Key::Backspace || key == ui::Key::Enter;
}

void Application::handle_requests()
{
    for (const ui::Request request : std::exchange(workspace_.asked, {})) take(request);
    for (const Request request : std::exchange(workspace_.requests, {})) take(request);
    for (ui::ExportToApp& exported : std::exchange(workspace_.handed, {})) hand_over(std::move(exported));
}

void Application::take(ui::Request request)
{
    using enum ui::Request;
    Session& session = workspace_.session;
    if (dialogs_.take(request, session.path(), session.tr()) || session_store_.take(request)) return;
    if (request == CopyPicture) explain(copy_picture().value_or(ui::Message(translatable("the picture was copied"))));
    if (request == Fit) canvas_.fit(session);
    if (request == ZoomIn) canvas_.zoom(session, 1.25);
    if (request == ZoomOut) canvas_.zoom(session, 0.8);
    if (request == Quit) ask_to_quit();
    const bool has_offer = !linked_.offering(workspace_).empty();
    if (request == TakeOver && has_offer) linked_.adopt(workspace_);
    if (request == KeepAsItIs && has_offer) linked_.keep(workspace_);
}

void Application::take(Request request)
{
    Session& session = workspace_.session;
    switch (request) {
    case Request::ImportDialog:
        import_dialog_.open(ui::PathDialog::Purpose::Open, session.path().value_or(""), ".json", ".view.json");
        break;
    case Request::CloseTab: questions_.ask_to_close(); break;
    case Request::ExportTable: tables_.ask_for_file(workspace_); break;
    case Request::KeepView: keep_view(session, canvas_.region(session)); break;
    case Request::ViewList: view_list_.toggle(); break;
    case Request::AskKind: kind_question_.open(); break;
    case Request::EditTitle:
        workspace_.has_panels = true;
        title_rows_.begin();
        break;
    case Request::RenameCase:
        workspace_.has_panels = true;
        case_list_.rename_shown();
        break;
    case Request::ContextMenu: context_menu_.open(); break;
    }
}

void Application::take(const ui::ChosenFile& file)
{
    using enum ui::ChosenFile::Purpose;
    switch (file.purpose) {
    case Open: open_file(workspace_, file.path); break;
    case Save:
        if (!save_as(workspace_, file.path)) dialogs_.refuse(workspace_.session.notice->sentence);
        break;
    case Export:
        if (const auto reason = export_as(file.path)) dialogs_.refuse(*reason);
        break;
    }
}

// The other program speaks and looks as this one does, and hears of what changes here.
void Application::hand_over(ui::ExportToApp exported)
{
    const DrawOptions& view = workspace_.session.view;
    exported.options = {"--lang", std::string(code(view.tr.language())), "--theme", std::string(text(view.theme))};
    handed_ = std::move(exported);
    if (!start_program_) return;
    auto link = ui::Link::made();
    ui::ExportToApp linked = *handed_;
    if (link) linked.options.insert(linked.options.end(), {"--link", link->folder().string()});
    const auto reason = start_program_(linked);
    if (reason) workspace_.session.notice = Notice{ui::lasting(*reason)};
    else if (link) linked_.add(*std::move(link), workspace_.session, *handed_);
}

void Application::show_menu_bar()
{
    if (!ImGui::BeginMainMenuBar()) return;
    ui::show_menus(commands_, workspace_, workspace_.session.view.tr);
    const std::string name = (workspace_.session.is_dirty() ? "* " : "") + tab_name(workspace_, workspace_.tab);
    ui::menu_bar_title(name);
    ImGui::EndMainMenuBar();
}

void Application::show_body()
{
    const auto told = banner(workspace_);
    ui::begin_body(told ? ui::height(*told) : ui::status_height());
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float below = tables_.height(workspace_, room.y);
    if (below > 0.0F) ui::show_below(below, [this] { tables_.show(workspace_, gui_, fonts_); });
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U); // the picture is drawn on the theme's own background
    ImGui::BeginChild("###above", {0.0F, room.y - below});
    ImGui::PopStyleColor();
    const auto left = [this](float width) { show_left(width); };
    const auto right = [this](float width) { show_right(width); };
    const auto picture = [this] { show_canvas(); };
    if (workspace_.has_panels) sides_.show(left, right, picture);
    else {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U);
        picture();
        ImGui::PopStyleColor();
    }
    ImGui::EndChild();
    ui::end_body();
    if (told) show_banner(workspace_, *told);
    else status_bar(workspace_);
}

void Application::show_left(float width)
{
    ui::begin_panel("###left", width);
    show_panel(workspace_, commands_, case_list_, fields_);
    ui::end_panel();
}

void Application::show_right(float width)
{
    ui::begin_panel("###right", width);
    const bool begins = canvas_.takes_number();
    if (begins) workspace_.topic = Topic::Properties;
    show_tabs();
    ImGui::Separator();
    switch (workspace_.topic) {
    case Topic::Properties:
        properties_panel(workspace_, commands_, {fields_, property_sets_, title_rows_, begins});
        break;
    case Topic::Results: results_panel(workspace_); break;
    case Topic::Problems: problems_panel(workspace_); break;
    case Topic::History: history_panel(workspace_); break;
    }
    ui::end_panel();
}

void Application::show_tabs()
{
    ui::TabRow row;
    for (const TopicEntry& entry : topics()) {
        std::string title = workspace_.session.view.tr(entry.label);
        const std::size_t n_faults = workspace_.session.solution().faults.size();
        if (entry.value == Topic::Problems && n_faults > 0) title += " (" + std::to_string(n_faults) + ")";
        if (row.show(title + "###" + std::string(entry.id), entry.value == workspace_.topic))
            workspace_.topic = entry.value;
    }
}

void Application::show_canvas()
{
    const float em = ImGui::GetFontSize();
    const float height = 1.25F * ImGui::GetFrameHeight() + 0.6F * em;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.4F * em, 0.3F * em});
    ImGui::BeginChild("###tools", {0.0F, height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    tool_bar(workspace_, commands_, gui_, fonts_, fields_);
    ImGui::EndChild();
    if (workspace_.transform) {
        ImGui::BeginChild("###transform", {0.0F, ImGui::GetFrameHeight() + 0.6F * em}, false,
                          ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
        transform_bar(workspace_, fields_);
        ImGui::EndChild();
    }
    ImGui::PopStyleVar();
    document_tabs(workspace_);
    ImGui::BeginChild("###picture", {}, false, ImGuiWindowFlags_NoNav); // its keys are the tools'
    canvas_.show(workspace_, gui_);
    ImGui::EndChild();
}

void Application::show_dialogs()
{
    Session& session = workspace_.session;
    const ui::Catalogue tr = session.view.tr; // a command may change the language
    if (const auto file = dialogs_.show_dialog(tr)) take(*file);
    if (const auto path = import_dialog_.show(tr)) import_properties(session, *path);
    dialogs_.show_palette_and_keys(commands_, workspace_);
    typical_window_.show(workspace_, gui_, fields_);
    section_window_.show(workspace_, gui_, fields_);
    view_list_.show(workspace_);
    context_menu_.show(workspace_, commands_);
    kind_question_.show(workspace_, commands_);
    tables_.show_dialog(workspace_);
    if (dialogs_.shows_description()) description_window(workspace_, dialogs_.shows_description());
    session_store_.show(workspace_);
    if (!questions_.show(workspace_, dialogs_)) return;
    session_store_.end();
    wants_to_quit_ = true;
}

std::optional<ui::Message> Application::export_as(const std::filesystem::path& path)
{
    std::optional<ui::Message> reason = export_to(path, workspace_.session, fonts_, canvas_.picture_of(workspace_),
                                                  workspace_.export_scale);
    context_.make_current(); // a PNG is drawn in a context of its own
    if (reason) return reason;
    const std::string_view done = workspace_.session.hidden
                                      ? translatable(
                                            "{file} was written without the results, which are hidden; H reveals them")
                                      : translatable("{file} was written");
    explain({done, {{"file", path.filename().string()}}});
    return reason;
}

std::optional<ui::Message> Application::copy_picture()
{
    const ui::Picture picture = canvas_.picture_of(workspace_);
    const std::optional<ui::Message> reason = copy_to_clipboard(picture, workspace_.session, fonts_,
                                                                workspace_.export_scale);
    context_.make_current(); // it is drawn in a context of its own
    return reason;
}

} // namespace frame
