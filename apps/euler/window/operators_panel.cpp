#include "apps/euler/window/operators_panel.h"

#include <imgui.h>

#include <string>

#include "apps/euler/session/operator_commands.h"
#include "topology/text/words.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/wrapped_text.h"

namespace euler {

using ui::translatable;

namespace {

std::string text_of(const Session& session, const Choice& choice)
{
    if (const auto* const name = std::get_if<std::string>(&choice)) return *name;
    if (const auto* const p = std::get_if<topology::Point>(&choice))
        return topology::written(p->x) + " " + topology::written(p->y) + " " + topology::written(p->z);
    const auto solid = session.draft()->solid(session.stepper().runner());
    const topology::NamedSolid& in = session.stepper().runner().solids()[*solid];
    return in.names.of(std::get<topology::Entity>(choice), in.solid);
}

// One button of the palette.
void operator_button(Workspace& workspace, const CommandTable& commands, const OperatorForm& form)
{
    const auto& command = *commands.find(command_id(form));
    const float width = 5.0F * ImGui::GetFontSize();
    const bool is_full = form.verb == Verb::Split; // it shares its name with the strut's
    const std::string name = std::string(form.name) + (is_full ? " *" : "") + "###" + std::string(command.id);
    if (ImGui::Button(name.c_str(), {width, 0.0F})) run(command, workspace);
    ImGui::SameLine();
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(workspace.session.tr()(form.meaning).c_str());
    ImGui::PopTextWrapPos();
}

} // namespace

void OperatorsPanel::show(Workspace& workspace, const CommandTable& commands)
{
    if (workspace.session.draft()) show_draft(workspace, commands);
    else list(workspace, commands);
}

void OperatorsPanel::list(Workspace& workspace, const CommandTable& commands)
{
    asked_.reset();
    reason_.reset();
    ImGui::BeginChild("###operators");
    for (const OperatorForm& form : operator_forms()) operator_button(workspace, commands, form);
    ImGui::EndChild();
}

// The line as far as it is known, then what is asked for.
void OperatorsPanel::show_draft(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.tr();
    const PendingOperator& draft = *session.draft();
    ImGui::TextUnformatted(std::string(draft.form().name).c_str());
    ImGui::SameLine();
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextDisabled("%s", tr(draft.form().meaning).c_str());
    ImGui::PopTextWrapPos();
    for (std::size_t i = 0; i < draft.chosen().size(); ++i)
        ui::wrapped_text(tr(draft.form().arguments()[i].prompt) + ": " + text_of(session, draft.chosen()[i]));
    ImGui::Separator();
    if (draft.is_complete()) {
        ui::wrapped_text(draft.line(session.stepper().runner()));
    } else {
        ask(session);
    }
    if (!session.draft()) return;
    ImGui::Spacing();
    ui::command_button(workspace, commands, "operator.accept");
    ui::command_button(workspace, commands, "operator.take_back");
    ui::command_button(workspace, commands, "operator.cancel");
}

// What is likely typed stands there already.
void OperatorsPanel::suggest(const Session& session)
{
    const PendingOperator& draft = *session.draft();
    if (asked_ == draft.chosen().size() && verb_ == draft.form().verb) return;
    asked_ = draft.chosen().size();
    verb_ = draft.form().verb;
    reason_.reset();
    const std::optional<Choice> likely = draft.suggestion(session.stepper().runner());
    field_.offer(likely ? text_of(session, *likely) : "");
}

void OperatorsPanel::ask(Session& session)
{
    const ui::Catalogue& tr = session.tr();
    suggest(session);
    const Argument& argument = session.draft()->next();
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(tr(argument.prompt).c_str());
    if (is_pointed_at(argument.kind))
        ImGui::TextDisabled("%s", tr("Click it in the picture, or type its name.").c_str());
    if (argument.kind == ArgumentKind::Point) ImGui::TextDisabled("%s", tr("Type x y z: 1 0 0").c_str());
    if (argument.kind == ArgumentKind::Vector) ImGui::TextDisabled("%s", tr("Type dx dy dz: 0 0 1").c_str());
    handle_typed(session);
    if (reason_) ui::wrapped_text(tr(*reason_));
    ImGui::PopTextWrapPos();
}

// Where nothing is typed, Backspace takes back what was chosen before. What is refused is typed anew.
void OperatorsPanel::handle_typed(Session& session)
{
    field_.grab_keyboard();
    const bool was_empty = field_.text().empty();
    if (field_.show("###argument")) {
        reason_ = session.choose_typed(field_.text());
        if (reason_) field_.offer(field_.text());
    } else if (was_empty && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Backspace), false)) {
        session.undo_choice();
    }
}

} // namespace euler
