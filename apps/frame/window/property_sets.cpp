#include "apps/frame/window/property_sets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>

#include "apps/frame/document/drawing.h"
#include "apps/frame/document/section_command.h"
#include "apps/frame/session/property_commands.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using ui::translatable;

namespace {

bool is_property(const Part& part)
{
    return std::holds_alternative<femoop::MaterialId>(part) || std::holds_alternative<femoop::SectionId>(part);
}

bool is_case(const Part& part)
{
    return std::holds_alternative<LoadCasePlace>(part) || std::holds_alternative<CombinationPlace>(part);
}

std::size_t n_users(const femoop::Model& model, const Part& part)
{
    const auto* const material = std::get_if<femoop::MaterialId>(&part);
    return material != nullptr ? members_with(model, *material).size()
                               : members_with(model, std::get<femoop::SectionId>(part)).size();
}

/// A small button beside the one before it, in a new line where it has no room.
bool button(const Workspace& workspace, std::string_view words, bool is_first = false)
{
    const std::string label = workspace.session.view.tr(words);
    if (!is_first) ui::beside_if_room(ui::width_of_button(label), 0.4F * ImGui::GetFontSize());
    return ImGui::Button((label + "###" + std::string(words)).c_str());
}

} // namespace

void PropertySets::show_case(Workspace& workspace, const Part& part)
{
    show_name(workspace, part);
    const bool duplicates = button(workspace, translatable("Duplicate"), true);
    const bool deletes = button(workspace, translatable("Delete"));
    ImGui::Spacing();
    Session& session = workspace.session;
    if (duplicates) duplicate(session, part);
    if (deletes)
        session.change({{translatable("Delete: {part}"), {{"part", title(session.model(), part)}}},
                        [&](Document& document) { remove(document, std::array{part}); }});
}

void PropertySets::show(Workspace& workspace, const Part& part)
{
    if (is_case(part)) return show_case(workspace, part);
    if (!is_property(part)) return;
    show_name(workspace, part);
    Session& session = workspace.session;
    const std::size_t n = n_users(session.model(), part);
    ImGui::TextUnformatted(session.view.tr("Members: {count}", {{"count", std::to_string(n)}}).c_str());
    ImGui::BeginDisabled(n == 0);
    const bool selects = button(workspace, translatable("Select its members"), true);
    ImGui::EndDisabled();
    const bool duplicates = button(workspace, translatable("Duplicate"));
    const bool is_section = std::holds_alternative<femoop::SectionId>(part);
    if (is_section && button(workspace, translatable("Shape or profile…"))) workspace.section.open(session);
    ImGui::Spacing();
    if (selects) select_members_with(session, part);
    if (duplicates) duplicate(session, part);
}

void PropertySets::show_name(Workspace& workspace, const Part& part)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("Name").c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    const bool is_confirmed = ImGui::InputText("###property name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool is_left = ImGui::IsItemDeactivatedAfterEdit();
    if (is_confirmed || is_left) reason_ = rename(workspace.session, part, name_);
    if (ImGui::IsItemActivated()) reason_.reset();
    if (!ImGui::IsItemActive() && !is_confirmed) name_ = name_of(workspace.session.model(), part);
    if (reason_) ui::wrapped_text(tr(*reason_));
}

void property_buttons(Workspace& workspace)
{
    const bool adds_material = button(workspace, translatable("New material"), true);
    const bool adds_section = button(workspace, translatable("New section…"));
    const bool imports = button(workspace, translatable("Import…"));
    const bool condenses = button(workspace, translatable("Condense"));
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", workspace.session.view.tr("Equal ones become one, unused ones go").c_str());
    if (adds_material) new_material(workspace.session);
    if (adds_section) workspace.section.open_new(workspace.session);
    if (imports) workspace.requests.push_back(Request::ImportDialog);
    if (condenses) condense_properties(workspace.session);
}

} // namespace frame
