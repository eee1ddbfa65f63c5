#include "apps/frame/window/application.h"

#include <imgui.h>

#include <utility>

#include "apps/frame/session/property_commands.h"
#include "apps/frame/session/view_commands.h"
#include "apps/frame/session/work.h"
#include "apps/frame/window/banner.h"
#include "apps/frame/window/document_tabs.h"
#include "apps/frame/window/export.h"
#include "apps/frame/window/no_results.h"
#include "apps/frame/window/properties_panel.h"
#include "apps/frame/window/results_panel.h"
#include "apps/frame/window/show_panel.h"
#include "apps/frame/window/status_bar.h"
#include "apps/frame/window/tool_bar.h"
#include "apps/frame/window/transform_bar.h"
#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/results/results_json.h"
#include "femoop/methods/influence/effect_name.h"
#include "ui/files/ending.h"
#include "ui/files/link.h"
#include "ui/widgets/panel.h"

template class ui::DocumentApp<frame::Workspace>;

namespace frame {

using ui::translatable;

Application::Application(ui::Context& context, const ui::Fonts& fonts, Session session)
    : DocumentApp(context, fonts, std::move(session), command_table(),
                  {.name = translatable("Cremona: frames"),
                   .description = translatable("Model and results in words"),
                   .files = {.extension = ".json", .left_out = ".view.json", .exports = export_endings()},
                   .sides = {{16.5F, 24.0F}, {0.25F, 0.30F}}}),
      canvas_(fonts),
      typical_window_(fonts),
      section_window_(fonts),
      train_window_(fonts)
{}

// ---- keys

namespace {

// A key that writes a letter, which a place that is being typed takes.
bool writes(ui::Key key)
{
    return key <= ui::Key::Digit9 || key == ui::Key::Space || key == ui::Key::Plus || key == ui::Key::Minus;
}

} // namespace

// The question after the kind of a new document has the keys first, and the window of units its own.
ui::Input Application::without_answer(const ui::Input& all)
{
    ui::Input input = all;
    std::erase_if(input.keys, [this](const ui::KeyEvent& event) {
        return event.is_down && !event.modifiers.ctrl && unit_window_.wants(event.key);
    });
    if (!kind_question_.is_open() || ImGui::GetIO().WantTextInput || fields_.is_typing()) return input;
    const auto n = std::erase_if(input.keys, [this](const ui::KeyEvent& event) {
        return event.is_down && kind_question_.handle_key(workspace(), commands(), event.key);
    });
    if (n > 0) input.text.clear();
    return input;
}

// Those of the table and of what is typed; what is left are commands.
std::vector<ui::KeyEvent> Application::take_keys(const ui::Input& all)
{
    const ui::Input input = tables_.handle_input(workspace(), without_answer(all));
    const bool types = ImGui::GetIO().WantTextInput || fields_.is_typing();
    const bool types_place = !types && !input.modifiers.ctrl && workspace().tool_controller.type(input.text);
    std::vector<ui::KeyEvent> left;
    for (const ui::KeyEvent& event : input.keys) {
        if (!event.is_down || (types && is_for_field(event))) continue;
        if (!types && handle_typing(event.key)) continue;
        if (!types_place || !writes(event.key) || event.modifiers.ctrl) left.push_back(event);
    }
    return left;
}

void Application::settle_fields()
{
    DocumentApp::settle_fields();
    tables_.settle(workspace());
}

// Of the keys that write no letter: what is typed is edited or given up, not the model.
bool Application::is_for_field(const ui::KeyEvent& event) const
{
    const auto* const command = commands().find(event.chord());
    return event.key == ui::Key::Escape || (command != nullptr && command->id.starts_with("edit."));
}

// The keys that end or mend a place that is typed while drawing.
bool Application::handle_typing(ui::Key key)
{
    if (workspace().tool_controller.typed().empty()) return false;
    if (key == ui::Key::Backspace) workspace().tool_controller.backspace();
    if (key == ui::Key::Enter) {
        // Where no model can have a node, what was begun is given up with it.
        Session& session = workspace().session;
        const auto change = workspace().tool_controller.enter(work_of(session));
        if (change && !session.change_soundly(*change)) workspace().tool_controller.tool().escape();
        if (!workspace().tool_controller.typed().empty())
            session.notify(workspace().tool_controller.why_not_enter(work_of(session)));
    }
    return key == ui::Key::Backspace || key == ui::Key::Enter;
}

bool Application::close_topmost()
{
    return DocumentApp::close_topmost() || view_list_.close() || unit_window_.close() || cancel_gesture();
}

bool Application::cancel_gesture()
{
    if (!session().history().is_dragging()) return false;
    workspace().tool_controller.tool().escape(); // else it would go on with what is taken back
    workspace().session.cancel();
    return true;
}

// ---- requests

void Application::handle_own_requests()
{
    for (const Request request : std::exchange(workspace().requests, {})) handle_own_request(request);
    if (workspace().transform && !session().history().is_dragging())
        workspace().transform.reset(); // something else ended it
}

void Application::handle_own_request(Request request)
{
    Session& session = workspace().session;
    switch (request) {
    case Request::ImportDialog:
        import_dialog_.open(ui::PathDialog::Purpose::Open, session.path().value_or(""), ".json", ".view.json");
        break;
    case Request::ExportTable: tables_.ask_for_file(workspace()); break;
    case Request::KeepView: keep_view(session, canvas_.region(session)); break;
    case Request::ViewList: view_list_.toggle(); break;
    case Request::UnitWindow:
        unit_window_.toggle();
        tables_.settle(workspace());
        tables_.leave();
        break;
    case Request::AskKind: kind_question_.open(); break;
    case Request::EditTitle:
        workspace().has_panels = true;
        title_rows_.begin();
        break;
    case Request::RenameCase:
        workspace().has_panels = true;
        case_list_.rename_shown();
        break;
    case Request::ContextMenu: context_menu_.open(); break;
    case Request::CopyDerivation: copy_derivation(femoop::derivation::derivation_text); break;
    case Request::CopyDerivationAsLatex: copy_derivation(femoop::derivation::derivation_latex); break;
    }
}

void Application::copy_derivation(DerivationWriter* writer)
{
    const femoop::derivation::Derivation* const derivation = workspace().derivation.derivation();
    if (derivation == nullptr) return;
    const femoop::Model& model = workspace().derivation.model(session());
    ImGui::SetClipboardText(writer(*derivation, model, session().tr()).c_str());
    if (workspace().derivation.force_method() != nullptr)
        return workspace().notify(translatable("the steps of the force method were copied"));
    const std::string effect = femoop::influence::effect_name(model, derivation->effect, session().tr());
    workspace().notify({translatable("the steps of {number} were copied"),
                        {{"number", femoop::derivation::number_name(*derivation, effect)}}});
}

// ---- other programs

// It hears of what changes here.
void Application::start(const ui::ExportToApp& exported)
{
    auto link = ui::Link::made();
    ui::ExportToApp linked = exported;
    if (link) linked.options.insert(linked.options.end(), {"--link", link->folder().string()});
    const auto reason = start_program(linked);
    if (reason) workspace().session.notice = Notice{ui::lasting(*reason)};
    else if (link) linked_.add(*std::move(link), session(), exported);
}

void Application::follow_links(double seconds)
{
    linked_.tick(seconds, workspace());
    workspace().offer = linked_.offering(workspace());
}

void Application::answer_offer(ui::Request request)
{
    if (linked_.offering(workspace()).empty()) return;
    if (request == ui::Request::TakeOver) linked_.adopt(workspace());
    else linked_.keep(workspace());
}

// ---- what is shown

std::optional<ui::FootMessage> Application::foot_message() const { return banner(workspace()); }

void Application::answer(const ui::FootMessage& message, std::size_t pressed)
{
    answer_banner(workspace(), message, pressed);
}

void Application::show_status() const { status_bar(workspace()); }

void Application::show_body()
{
    workspace().pointed_number.reset(); // who shows the one under the pointer says so
    if (ImGui::GetIO().MouseDelta.x != 0.0F || ImGui::GetIO().MouseDelta.y != 0.0F) workspace().asked_number.reset();
    const float below = tables_.height(workspace(), ImGui::GetContentRegionAvail().y);
    show_panels_and_canvas_above(below, [this] { tables_.show(workspace(), commands(), gui(), fonts()); });
}

void Application::show_left() { show_panel(workspace(), commands(), case_list_, fields_); }

void Application::show_right()
{
    const bool begins = canvas_.takes_number();
    if (begins) workspace().topic = Topic::Properties;
    show_tabs();
    ImGui::Separator();
    switch (workspace().topic) {
    case Topic::Properties:
        properties_panel(workspace(), commands(), {fields_, property_sets_, title_rows_, begins});
        break;
    case Topic::Results: results_panel(workspace(), fields_); break;
    case Topic::Problems: problems_panel(workspace()); break;
    case Topic::History: history_panel(workspace()); break;
    }
}

void Application::show_tabs()
{
    ui::TabRow row;
    for (const TopicEntry& entry : topics()) {
        std::string title = session().tr()(entry.label);
        const std::size_t n_faults = session().solution().faults.size();
        if (entry.value == Topic::Problems && n_faults > 0) title += " (" + std::to_string(n_faults) + ")";
        if (row.show(title + "###" + std::string(entry.id), entry.value == workspace().topic))
            workspace().topic = entry.value;
    }
}

float Application::covered_width() const { return workspace().has_open_draft() ? ui::SideWindow::width() : 0.0F; }

void Application::show_canvas()
{
    const float row = ImGui::GetFrameHeight(), gap = 0.6F * ImGui::GetFontSize();
    if (has_tools())
        ui::button_bar("###tools", 1.25F * row + gap,
                       [this] { tool_bar(workspace(), commands(), gui(), fonts(), fields_); });
    if (workspace().transform)
        ui::button_bar("###transform", row + gap, [this] { transform_bar(workspace(), fields_); });
    document_tabs(workspace(), [this] {
        settle_fields();
        return !refuses_text();
    });
    ui::picture_area(0.0F, [this] { canvas_.show(workspace(), gui()); });
}

void Application::show_own_dialogs()
{
    if (const auto path = import_dialog_.show(session().tr())) import_properties(workspace().session, *path);
    typical_window_.show(workspace(), gui(), fields_);
    section_window_.show(workspace(), gui(), fields_);
    design_window_.show(workspace(), fields_);
    train_window_.show(workspace(), gui(), fields_);
    view_list_.show(workspace());
    auto& view = workspace().session.view;
    unit_window_.show(view.unit_choices, session().units(), session().view.tr, fields_.stops());
    context_menu_.show(workspace(), commands());
    kind_question_.show(workspace(), commands());
    tables_.show_dialog(workspace());
}

const femoop::derivation::Derivation* Application::shown_derivation() const
{
    return workspace().bottom.shows(BottomContent::Derivation) ? workspace().derivation.derivation() : nullptr;
}

std::string Application::words() const
{
    const femoop::derivation::Derivation* const derivation = shown_derivation();
    if (derivation == nullptr) return description(session());
    return description(session()) + "\n" +
           femoop::derivation::derivation_text(*derivation, workspace().derivation.model(session()), session().tr());
}

std::string Application::results_text() const
{
    const Solution& solution = session().solution();
    if (!solution.results) return {};
    constexpr std::size_t n_stations = 11;
    return femoop::results_json(session().model(), *solution.results, solution.solved_cases(), n_stations);
}

void Application::show_beside_words()
{
    if (session().hidden) ImGui::SameLine();
    offer_to_reveal(workspace());
}

std::optional<ui::Message> Application::write(const std::filesystem::path& path)
{
    WindowContent content{.picture = picture(), .png_scale = workspace().export_scale};
    const femoop::derivation::Derivation* const derivation = shown_derivation();
    if (derivation != nullptr && ui::has_ending(path, ".tex"))
        content.derivation = derivation_latex(*derivation, workspace().derivation.model(session()), session().tr());
    return export_to(path, session(), fonts(), content);
}

std::string_view Application::written() const
{
    return session().hidden ? translatable("{file} was written without the results, which are hidden; H reveals them")
                            : DocumentApp::written();
}

std::vector<std::string> Application::own_look() const
{
    const DrawOptions& view = session().view;
    std::vector<std::string> look;
    if (const std::string shown = words_of(view.show); !shown.empty()) look = {"--show", shown};
    const femoop::Model& model = session().model();
    if (!view.is_envelope && view.load_case.index < model.n_cases()) {
        look.emplace_back("--case");
        look.push_back(model.case_name(view.load_case));
    }
    return look;
}

} // namespace frame
