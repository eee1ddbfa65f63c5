#include "apps/cross/window/method_panel.h"

#include <imgui.h>

#include <string>

#include "apps/cross/session/own_order.h"
#include "apps/cross/view/numbers.h"
#include "ui/text/number_format.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace cross {

namespace fc = femoop::cross;
using ui::translatable;

namespace {

void heading(const std::string& words)
{
    ImGui::Spacing();
    ImGui::Separator();
    ui::wrapped_text(words);
}

/// A command that is on or off, as a box to tick; greyed where it cannot run, its tip says why.
void tick(Workspace& workspace, const CommandTable& commands, std::string_view id)
{
    const auto& command = *commands.find(id);
    const ui::Catalogue tr = workspace.tr();
    const auto reason = why_not(command, workspace);
    bool is_on = command.is_on(workspace);
    ImGui::BeginDisabled(reason.has_value());
    if (ImGui::Checkbox(ui::label_beside_box(label(command, workspace, tr), id).c_str(), &is_on))
        run(command, workspace);
    ImGui::EndDisabled();
    if (!reason || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(24.0F * ImGui::GetFontSize());
    ImGui::TextUnformatted(tr(*reason).c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// One of several commands, as a round button.
void choice(Workspace& workspace, const CommandTable& commands, std::string_view id)
{
    const auto& command = *commands.find(id);
    const std::string name = ui::label_beside_box(label(command, workspace, ui::Catalogue(workspace.tr())), id);
    if (ImGui::RadioButton(name.c_str(), command.is_on(workspace))) run(command, workspace);
}

void show_cases(Session& session)
{
    const femoop::Model& model = session.document().model;
    Method method = session.document().method;
    if (method.load_case.index >= model.n_cases()) return;
    heading(session.tr()("Load case"));
    ImGui::SetNextItemWidth(-1.0F);
    if (!ImGui::BeginCombo("###case", ui::shown_whole(model.case_name(method.load_case)).c_str())) return;
    const std::size_t n = model.n_cases();
    std::optional<femoop::CaseId> chosen;
    for (std::size_t i = 0; i < n; ++i) {
        const std::string label = ui::item_label(model.case_name(femoop::CaseId(i)), std::to_string(i));
        if (ImGui::Selectable(label.c_str(), method.load_case.index == i)) chosen = femoop::CaseId(i);
    }
    ImGui::EndCombo();
    if (!chosen) return;
    method.load_case = *chosen;
    session.set_method(method, translatable("Choose a load case"));
}

void show_digits(Session& session)
{
    Method method = session.document().method;
    heading(session.tr()("Digits of every number (0: exact)"));
    ImGui::SetNextItemWidth(-1.0F);
    if (!ImGui::SliderInt("###digits", &method.digits, 0, 8)) return;
    session.set_method(method, translatable("Change the digits"));
}

std::string stage_name(const Session& session, std::size_t stage)
{
    const auto& sways = session.solution().task->problem.sways;
    if (stage == 0) return session.tr()("Loads, sways propped");
    if (stage > sways.size()) return session.tr()("All together");
    const std::string& name = session.document().model[sways[stage - 1].prop].id;
    return session.tr()("Sway at {node}", {{"node", name}});
}

void show_stages(Session& session)
{
    if (session.n_stages() < 2) return;
    heading(session.tr()("Sheet"));
    const std::size_t n = session.n_stages();
    for (std::size_t stage = 0; stage < n; ++stage) {
        const std::string name = ui::label_beside_box(stage_name(session, stage), "stage" + std::to_string(stage));
        if (ImGui::RadioButton(name.c_str(), session.document().stage == stage)) session.set_stage(stage);
    }
}

std::string turns_description(const Session& session, const std::vector<TurnTree::Turn>& turns)
{
    constexpr std::size_t most = 12;
    std::string words = turns.size() > most ? "… " : "";
    for (std::size_t i = turns.size() > most ? turns.size() - most : 0; i < turns.size(); ++i) {
        const auto& joints = session.solution().task->problem.joints;
        words += turns[i] ? session.document().model[joints[turns[i]->index].node].id : session.tr()("all");
        words += " ";
    }
    return words;
}

void show_branches(Session& session)
{
    if (session.turn_tree() == nullptr || session.turn_tree()->branches().size() < 2) return;
    heading(session.tr()("Ways gone so far"));
    const TurnTree turn_tree = *session.turn_tree();
    for (const std::size_t end : turn_tree.branches()) {
        const std::string name = ui::item_label(turns_description(session, turn_tree.turns_to(end)),
                                                "branch" + std::to_string(end));
        if (ImGui::Selectable(name.c_str(), end == turn_tree.place())) session.go_to_branch(end);
    }
}

} // namespace

void MethodPanel::show(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    if (session.solution().task) show_stages(session);
    show_cases(session);
    heading(session.tr()("Whose turn it is"));
    for (const char* const id : {"method.largest", "method.left_to_right", "method.all_at_once", "method.listed"})
        choice(workspace, commands, id);
    if (session.document().method.order == fc::Order::Listed) show_own_order(workspace);
    show_digits(session);
    if (session.sheet() != nullptr) show_tolerance(workspace);
    ImGui::Spacing();
    ImGui::Separator();
    for (const char* const id :
         {"method.modified", "method.symmetry", "show.tension_side", "show.fractions", "show.shears"})
        tick(workspace, commands, id);
    if (session.solution().task) show_branches(session);
}

void MethodPanel::show_own_order(Workspace& workspace)
{
    const std::string order = own_order(workspace.session.document().method);
    const ui::NumberFieldEvent event = fields_.show(
        "###order", {.text = order, .exact_text = order, .value = std::nullopt, .is_typed_only = true});
    if (event.kind != ui::NumberFieldEvent::Kind::Typed) return;
    if (const auto reason = take_own_order(workspace.session, event.text))
        fields_.reject(event, workspace.tr()(*reason));
}

void MethodPanel::show_tolerance(Workspace& workspace)
{
    Session& session = workspace.session;
    const ui::DisplayUnits units = units_of(session.document().model, session.tr());
    heading(units.label(session.tr()("Tolerance"), ui::Measure::Moment));
    const double shown = units.shown(session.sheet()->tolerance, ui::Measure::Moment);
    const std::string text = ui::number_text(shown, units.format());
    const ui::NumberFieldEvent event = fields_.show(
        "###tolerance", {.text = text, .exact_text = text, .value = std::nullopt, .is_typed_only = true});
    if (event.kind != ui::NumberFieldEvent::Kind::Typed) return;
    const auto typed = ui::number_typed(event.text);
    if (!typed || *typed <= 0.0) return fields_.reject(event, session.tr()("wanted a number above 0"));
    Method method = session.document().method;
    method.tolerance = units.stored(*typed, ui::Measure::Moment);
    session.set_method(method, translatable("Change the tolerance"));
}

} // namespace cross
