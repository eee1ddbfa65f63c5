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
#include "femoop/files/whole_file.h"
#include "ui/files/link.h"
#include "ui/widgets/offer.h"
#include "ui/widgets/panel.h"

namespace frame {

using ui::translatable;

namespace {

constexpr double seconds_per_swing = 2.4;
constexpr double full_swing = 0.25 * seconds_per_swing; // a still picture shows the full displacement

} // namespace

Application::Application(ui::Context& context, const ui::Fonts& fonts, Session session)
    : desk_(std::move(session)),
      commands_(command_table()),
      gui_(context, fonts, ui::Theme(desk_.session.view.theme)),
      context_(context),
      fonts_(fonts),
      canvas_(fonts),
      typical_window_(fonts),
      section_window_(fonts),
      theme_(desk_.session.view.theme),
      time_(full_swing)
{}

bool Application::is_moving() const
{
    const Session& session = desk_.session;
    const bool has_passing_notice = session.notice && session.notice->seconds_left;
    const bool is_walking = desk_.bottom.shows(BottomContent::Solver) && desk_.solver.is_playing();
    return is_swinging() || is_walking || has_passing_notice;
}

bool Application::is_swinging() const { return desk_.session.is_animated || !desk_.session.shown_mechanisms().empty(); }

std::string Application::window_title() const
{
    const Session& session = desk_.session;
    return (session.is_dirty() ? "*" : "") + session.file_name() + " – " + session.view.tr("Cremona: frames");
}

void Application::ask_to_quit() { questions_.ask_to_quit(); }

void Application::remember_in(const ui::DraftFolder& folder) { kept_files_ = ui::KeptFiles(folder); }

void Application::animate(double seconds)
{
    time_ = is_swinging() ? time_ + seconds : full_swing;
    desk_.session.draw_state.phase = std::sin(2.0 * std::numbers::pi * time_ / seconds_per_swing);
}

void Application::pass_notice(double seconds)
{
    std::optional<Notice>& notice = desk_.session.notice;
    if (!notice || !notice->seconds_left) return;
    *notice->seconds_left -= seconds;
    if (*notice->seconds_left < 0.0) notice.reset();
}

void Application::frame(const ui::Input& input)
{
    if (theme_ != desk_.session.view.theme) {
        theme_ = desk_.session.view.theme;
        gui_.set_theme(ui::Theme(theme_));
    }
    take_files(input.dropped_files);
    gui_.begin_frame(input);
    take_keys(input);
    linked_.tick(input.seconds, desk_);
    animate(input.seconds);
    if (desk_.bottom.shows(BottomContent::Solver)) desk_.solver.advance(input.seconds);
    pass_notice(input.seconds);
    show_menu_bar();
    show_body();
    show_dialogs();
    take_requests();
    if (desk_.transform && !desk_.session.history().is_dragging()) desk_.transform.reset(); // something else ended it
    kept_files_.tick(desk_, ui::logical_size(context_), input.seconds);
    had_popup_ = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    gui_.end_frame();
}

// Files that were dropped on the window.
void Application::take_files(const std::vector<std::string>& files)
{
    const bool is_choosing = desk_.typical.is_open() || desk_.section.is_open() || questions_.is_open();
    if (is_choosing && !files.empty()) return explain(translatable("finish what is being made in the window first"));
    for (const std::string& file : files) open_file(desk_, file);
}

void Application::explain(const ui::Phrase& reason) { desk_.session.notice = passing_notice(reason); }

// What Escape is for first: to put away what lies over the picture.
bool Application::put_away_a_window() { return overlays_.put_away() || view_list_.close(); }

namespace {

// A key that writes a letter, which a place that is being typed takes.
bool writes(ui::Key key)
{
    return key <= ui::Key::Digit9 || key == ui::Key::Space || key == ui::Key::Plus || key == ui::Key::Minus;
}

} // namespace

void Application::take_keys(const ui::Input& all)
{
    const bool is_popup_open = had_popup_ || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    const bool is_blocked = overlays_.takes_keys() || questions_.is_open() || kept_files_.is_open() ||
                            tables_.is_asking() || is_popup_open;
    if (is_blocked) return TablesPanel::lend_keyboard();
    const ui::Input input = tables_.take(desk_, all);
    const bool types = ImGui::GetIO().WantTextInput || fields_.is_typing();
    const bool types_place = !types && !input.modifiers.ctrl && desk_.hand.type(input.text);
    for (const ui::KeyEvent& event : input.keys) {
        if (!event.is_down || (types && !event.modifiers.ctrl)) continue;
        if (!types && kind_question_.take(desk_, commands_, event.key)) continue;
        if (!types && take_typing(event.key)) continue;
        if (types_place && writes(event.key) && !event.modifiers.ctrl) continue;
        if (event.key == ui::Key::Escape && put_away_a_window()) continue;
        if (event.key == ui::Key::Escape && desk_.session.history().is_dragging()) {
            desk_.hand.tool().escape(); // else it would go on with what is taken back
            desk_.session.cancel();
            continue;
        }
        const auto* const command = commands_.find(event.chord());
        const bool is_edit_of_text = types && command != nullptr && command->id.starts_with("edit.");
        if (command == nullptr || is_edit_of_text) continue;
        const auto reason = run(*command, desk_);
        if (reason && !command->menu.empty()) explain(*reason);
    }
}

// The keys that end or mend a place that is typed while drawing.
bool Application::take_typing(ui::Key key)
{
    if (desk_.hand.typed().empty()) return false;
    if (key == ui::Key::Backspace) desk_.hand.rub_out();
    if (key == ui::Key::Enter) {
        // Where no model can have a node, what was begun is given up with it.
        const auto change = desk_.hand.enter(work_of(desk_.session));
        if (change && !desk_.session.change_soundly(*change)) desk_.hand.tool().escape();
        if (!desk_.hand.typed().empty()) explain(desk_.hand.why_not_enter(work_of(desk_.session)));
    }
    return key == ui::Key::Backspace || key == ui::Key::Enter;
}

void Application::take_requests()
{
    for (const ui::Request request : std::exchange(desk_.asked, {})) take(request);
    for (const Request request : std::exchange(desk_.requests, {})) take(request);
    for (ui::Handover& handover : std::exchange(desk_.handed, {})) hand_over(std::move(handover));
}

void Application::take(ui::Request request)
{
    using enum ui::Request;
    Session& session = desk_.session;
    if (overlays_.take(request, session.path()) || kept_files_.take(request)) return;
    if (request == CopyPicture) explain(copy_picture().value_or(ui::Phrase(translatable("the picture was copied"))));
    if (request == Fit) canvas_.fit(session);
    if (request == ZoomIn) canvas_.zoom(session, 1.25);
    if (request == ZoomOut) canvas_.zoom(session, 0.8);
    if (request == Quit) ask_to_quit();
}

void Application::take(Request request)
{
    Session& session = desk_.session;
    switch (request) {
    case Request::ImportDialog:
        import_dialog_.open(ui::PathDialog::Purpose::Open, session.path().value_or(""), ".json", ".view.json");
        break;
    case Request::CloseTab: questions_.ask_to_close(); break;
    case Request::ExportTable: tables_.ask_for_file(desk_); break;
    case Request::KeepView: keep_view(session, canvas_.region(session)); break;
    case Request::ViewList: view_list_.toggle(); break;
    case Request::AskKind: kind_question_.open(); break;
    case Request::EditTitle:
        desk_.has_panels = true;
        title_rows_.begin();
        break;
    case Request::RenameCase:
        desk_.has_panels = true;
        case_list_.rename_shown();
        break;
    case Request::ContextMenu: context_menu_.open(); break;
    }
}

void Application::take(const ui::ChosenFile& file)
{
    using enum ui::ChosenFile::Purpose;
    switch (file.purpose) {
    case Open: open_file(desk_, file.path); break;
    case Save:
        if (!save_as(desk_, file.path)) overlays_.refuse(desk_.session.notice->sentence);
        break;
    case Export:
        if (const auto reason = export_as(file.path)) overlays_.refuse(*reason);
        break;
    }
}

// The other program speaks and looks as this one does, and hears of what changes here.
void Application::hand_over(ui::Handover handover)
{
    const DrawOptions& view = desk_.session.view;
    handover.options = {"--lang", std::string(code(view.tr.language())), "--theme", std::string(text(view.theme))};
    handed_ = std::move(handover);
    if (!start_program_) return;
    auto link = ui::Link::made(files::write_whole_file);
    ui::Handover linked = *handed_;
    if (link) linked.options.insert(linked.options.end(), {"--link", link->folder().string()});
    const auto reason = start_program_(linked);
    if (reason) desk_.session.notice = Notice{*reason, {}};
    else if (link) linked_.add(*std::move(link), desk_.session, *handed_);
}

void Application::show_menu_bar()
{
    if (!ImGui::BeginMainMenuBar()) return;
    ui::show_menus(commands_, desk_, desk_.session.view.tr);
    show_offer_of_program();
    const std::string name = (desk_.session.is_dirty() ? "* " : "") + desk_.session.file_name();
    ui::menu_bar_title(name);
    ImGui::EndMainMenuBar();
}

void Application::show_offer_of_program()
{
    const auto sentence = linked_.offering(desk_);
    if (!sentence) return;
    const ui::Catalogue& tr = desk_.session.view.tr;
    const auto answer = ui::show_offer(tr(*sentence), tr);
    if (answer == ui::OfferAnswer::TakeOver) linked_.take_over(desk_);
    if (answer == ui::OfferAnswer::Keep) linked_.keep(desk_);
}

void Application::show_body()
{
    const auto told = banner(desk_);
    ui::begin_body(told ? ui::height(*told) : ui::status_height());
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float below = tables_.height(desk_, room.y);
    if (below > 0.0F) ui::show_below(below, [this] { tables_.show(desk_, gui_, fonts_); });
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U); // the picture is drawn on the theme's own background
    ImGui::BeginChild("###above", {0.0F, room.y - below});
    ImGui::PopStyleColor();
    const auto left = [this](float width) { show_left(width); };
    const auto right = [this](float width) { show_right(width); };
    const auto picture = [this] { show_canvas(); };
    if (desk_.has_panels) sides_.show(left, right, picture);
    else {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U);
        picture();
        ImGui::PopStyleColor();
    }
    ImGui::EndChild();
    ui::end_body();
    if (told) show_banner(desk_, *told);
    else status_bar(desk_.session);
}

void Application::show_left(float width)
{
    ui::begin_panel("###left", width);
    show_panel(desk_, commands_, case_list_, fields_);
    ui::end_panel();
}

void Application::show_right(float width)
{
    ui::begin_panel("###right", width);
    show_tabs();
    ImGui::Separator();
    switch (desk_.topic) {
    case Topic::Properties: properties_panel(desk_, commands_, {fields_, property_sets_, title_rows_}); break;
    case Topic::Results: results_panel(desk_); break;
    case Topic::Problems: problems_panel(desk_); break;
    case Topic::History: history_panel(desk_); break;
    }
    ui::end_panel();
}

void Application::show_tabs()
{
    ui::TabRow row;
    for (const TopicEntry& entry : topics()) {
        std::string title = desk_.session.view.tr(entry.label);
        const std::size_t n_faults = desk_.session.solution().faults.size();
        if (entry.value == Topic::Problems && n_faults > 0) title += " (" + std::to_string(n_faults) + ")";
        if (row.show(title + "###" + std::string(entry.id), entry.value == desk_.topic)) desk_.topic = entry.value;
    }
}

void Application::show_canvas()
{
    const float em = ImGui::GetFontSize();
    const float height = 1.25F * ImGui::GetFrameHeight() + 0.6F * em;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.4F * em, 0.3F * em});
    ImGui::BeginChild("###tools", {0.0F, height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    tool_bar(desk_, commands_, gui_, fonts_, fields_);
    ImGui::EndChild();
    if (desk_.transform) {
        ImGui::BeginChild("###transform", {0.0F, ImGui::GetFrameHeight() + 0.6F * em}, false,
                          ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
        transform_bar(desk_, fields_);
        ImGui::EndChild();
    }
    ImGui::PopStyleVar();
    document_tabs(desk_);
    ImGui::BeginChild("###picture", {}, false, ImGuiWindowFlags_NoNav); // its keys are the tools'
    canvas_.show(desk_, gui_);
    ImGui::EndChild();
}

void Application::show_dialogs()
{
    Session& session = desk_.session;
    const ui::Catalogue tr = session.view.tr; // a command may change the language
    if (const auto file = overlays_.show_dialog(tr)) take(*file);
    if (const auto path = import_dialog_.show(tr)) import_properties(session, *path);
    overlays_.show_palette_and_keys(commands_, desk_);
    typical_window_.show(desk_, gui_, fields_);
    section_window_.show(desk_, gui_, fields_);
    view_list_.show(desk_);
    context_menu_.show(desk_, commands_);
    kind_question_.show(desk_, commands_);
    tables_.show_dialog(desk_);
    if (overlays_.shows_description()) description_window(desk_, overlays_.shows_description());
    kept_files_.show(desk_);
    if (!questions_.show(desk_, overlays_)) return;
    kept_files_.end();
    wants_to_quit_ = true;
}

std::optional<ui::Phrase> Application::export_as(const std::filesystem::path& path)
{
    std::optional<ui::Phrase> reason = export_to(path, desk_.session, fonts_, canvas_.picture_of(desk_),
                                                 desk_.export_scale);
    context_.make_current(); // a PNG is drawn in a context of its own
    if (reason) return reason;
    const std::string_view done =
        desk_.session.hidden ? translatable("{file} was written without the results, which are hidden; H reveals them")
                             : translatable("{file} was written");
    explain({done, {{"file", path.filename().string()}}});
    return reason;
}

std::optional<ui::Phrase> Application::copy_picture()
{
    const ui::Picture picture = canvas_.picture_of(desk_);
    const std::optional<ui::Phrase> reason = copy_to_clipboard(picture, desk_.session, fonts_, desk_.export_scale);
    context_.make_current(); // it is drawn in a context of its own
    return reason;
}

} // namespace frame
