#include "apps/frame/window/properties_panel.h"

#include <imgui.h>

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/document/dimensioning.h"
#include "apps/frame/session/load_commands.h"
#include "apps/frame/window/choices.h"
#include "apps/frame/window/context_menu.h"
#include "apps/frame/window/number_row.h"
#include "apps/frame/window/parts_list.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using namespace femoop;
using ui::translatable;

namespace {

// Of a dimension line, which is no part of the model: its distance from its first node.
void show_offset(Workspace& workspace, ui::NumberFields& fields, std::span<const Part> parts, bool begins)
{
    const auto* const place = parts.size() == 1 ? std::get_if<DimensionPlace>(&parts.front()) : nullptr;
    if (place == nullptr) return;
    const Rows rows("offset");
    if (!rows.is_open()) return;
    Session& session = workspace.session;
    Quantity offset = session.document().companion.dimensions[place->dimension].offset;
    rows.name(session.units().label(session.view.tr("Distance"), ui::Measure::Length));
    if (edit_quantity(workspace, fields, {.id = "offset", .measure = ui::Measure::Length, .begins = begins}, offset))
        session.change({{translatable("Move: {part}"), {{"part", title(session.document(), *place)}}},
                        [place = *place, offset](Document& document) { set_offset(document, place, offset); }});
}

void show_parts(Workspace& workspace, ui::NumberFields& fields, std::span<const Part> parts, bool begins = false)
{
    show_numbers(workspace, fields, parts, begins);
    show_offset(workspace, fields, parts, begins);
    show_choices(workspace, fields, parts);
    named_set_rows(workspace.session, parts);
}

// Which case a load belongs to, so that equal loads of two cases are told apart.
std::string case_of(const Model& model, const Part& load) { return model.load_cases[load_case_of(load)].id; }

void show_loads_on(Workspace& workspace, ui::NumberFields& fields, const Part& part)
{
    int i = 0;
    for (const Part& load : loads_on(workspace.session.model(), part)) {
        if (!has(workspace.session.model(), load)) return;
        ImGui::PushID(++i);
        const std::string heading = workspace.session.view.tr(title(workspace.session.model(), load)) + " · " +
                                    case_of(workspace.session.model(), load);
        const float arrow = ImGui::GetFontSize() + 4.0F * ImGui::GetStyle().FramePadding.x;
        const std::string lines = ui::in_lines(heading, ImGui::GetContentRegionAvail().x - arrow);
        if (ImGui::CollapsingHeader(ui::item_label(lines, "load").c_str(), ImGuiTreeNodeFlags_DefaultOpen))
            show_parts(workspace, fields, std::array{load});
        ImGui::PopID();
    }
}

// From a member to its material and section and from a load to what bears it, so that their numbers are one click away.
void show_ways_on(Session& session, const Part& part)
{
    if (has(session.model(), part) && is_load(part)) {
        const Part bearer = bearer_of(session.model(), part);
        ImGui::Spacing();
        if (ui::wrapped_button(session.view.tr(title(session.model(), bearer)), "bearer")) session.selection = bearer;
    }
    const auto* const id = std::get_if<MemberId>(&part);
    if (id == nullptr) return;
    const Member member = session.model()[*id];
    const ui::Catalogue& tr = session.view.tr;
    ImGui::Spacing();
    if (member.section && ui::wrapped_button(tr("Edit the section"), "edit section"))
        session.selection = Part(*member.section);
    const std::string material = tr("Edit the material");
    ui::beside_if_room(ui::width_of_button(material), ImGui::GetStyle().ItemSpacing.x);
    if (member.material && ui::wrapped_button(material, "edit material")) session.selection = Part(*member.material);
}

void show_one(Workspace& workspace, const CommandTable& commands, const PropertyFields& fields, const Part& part)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    ui::wrapped_text(tr(title(session.document(), part)));
    ImGui::Separator();
    fields.sets.show(workspace, part);
    if (session.selection.only() != part || !has(session.document(), part))
        return; // the panel shows what it was before
    show_parts(workspace, fields.numbers, std::array{part}, fields.begins);
    show_ways_on(session, part);
    if (std::holds_alternative<MemberId>(part))
        for (const std::string_view id : {"methods.distribution", "methods.circle"})
            ui::command_button(workspace, commands, id);
    if (session.selection.only() == part && has(session.model(), part)) show_loads_on(workspace, fields.numbers, part);
    add_load_button(workspace, commands);
}

std::string_view heading_of(const Part& part)
{
    if (std::holds_alternative<NodeId>(part)) return translatable("Nodes: {count}");
    if (std::holds_alternative<MemberId>(part)) return translatable("Members: {count}");
    return translatable("Loads: {count}");
}

// Parts of one kind are shown and changed together.
void show_many(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    ImGui::TextUnformatted(
        tr("Selected: {count}", {{"count", std::to_string(workspace.session.selection.size())}}).c_str());
    ImGui::Separator();
    std::map<std::size_t, std::vector<Part>> kinds;
    for (const Part& part : workspace.session.selection.parts()) kinds[part.index()].push_back(part);
    for (const auto& [kind, parts] : kinds) {
        const std::string heading = tr(heading_of(parts.front()), {{"count", std::to_string(parts.size())}});
        ImGui::PushID(static_cast<int>(kind));
        if (ImGui::CollapsingHeader((heading + "###kind").c_str(), ImGuiTreeNodeFlags_DefaultOpen))
            show_parts(workspace, fields, parts);
        ImGui::PopID();
    }
    add_load_button(workspace, commands);
}

} // namespace

void properties_panel(Workspace& workspace, const CommandTable& commands, const PropertyFields& fields)
{
    Selection& selection = workspace.session.selection;
    if (selection.is_empty()) {
        parts_list(workspace, fields.sets, fields.title);
        return;
    }
    if (ImGui::SmallButton((workspace.session.view.tr("All parts") + "###all").c_str())) {
        selection.clear();
        return;
    }
    const std::optional<Part> chosen = selection.only();
    const std::string heading = chosen ? workspace.session.view.tr(title(workspace.session.document(), *chosen)) : "";
    ui::beside_if_room(ImGui::CalcTextSize(heading.c_str()).x, ImGui::GetStyle().ItemSpacing.x);
    if (const std::optional<Part> only = selection.only()) show_one(workspace, commands, fields, *only);
    else show_many(workspace, commands, fields.numbers);
}

} // namespace frame
