#include "apps/plane/window/tool_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "apps/drawing/quantity_typed.h"
#include "apps/plane/session/backdrop_commands.h"
#include "apps/plane/session/part_commands.h"
#include "apps/plane/view/field_picture.h"
#include "apps/plane/window/tool_icon.h"
#include "ui/widgets/command_combo.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/tooltip.h"
#include "ui/widgets/wrapped_text.h"

namespace plane {

using ui::translatable;

namespace {

// One button of the row: the tool's icon, framed where the hand holds it.
void tool_button(Workspace& workspace, const CommandTable& commands, const ToolEntry& entry, ui::ImGuiSession& gui,
                 const ui::Fonts& fonts)
{
    const auto& command = *commands.find(entry.id);
    const ui::Catalogue& tr = workspace.session.tr();
    const float side = ImGui::GetFrameHeight() * 1.25F;
    const bool is_on = command.is_on(workspace);
    if (is_on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
    const bool is_clicked = ImGui::Button(("###" + std::string(entry.id)).c_str(), {side, side});
    if (is_on) ImGui::PopStyleColor();
    const ImVec2 corner = ImGui::GetItemRectMin();
    const double edge = 0.12 * static_cast<double>(side);
    const double size = (static_cast<double>(side) - 2.0 * edge) / gui.scale();
    ui::Painter painter({size, size}, fonts);
    draw_tool_icon(painter, entry.value, ui::Theme(workspace.session.look.theme));
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x) + edge, static_cast<double>(corner.y) + edge});
    if (ImGui::IsItemHovered()) ui::show_tooltip(tr(entry.label) + "  (" + text(command.shortcuts.front()) + ")");
    if (is_clicked) run(command, workspace);
}

void switch_box(Workspace& workspace, const CommandTable& commands, std::string_view id)
{
    const auto& command = *commands.find(id);
    bool is_on = command.is_on(workspace);
    const std::string label = ui::label_beside_box(workspace.tr()(command.label), id);
    if (ImGui::Checkbox(label.c_str(), &is_on)) run(command, workspace);
}

/// An end of the range of the bands, typed or dragged; without one of its own it is that of the values.
void range_row(Workspace& workspace, ui::NumberFields& number_fields, const KeptRange& range, double KeptRange::*end)
{
    Session& session = workspace.session;
    const bool is_low = end == &KeptRange::low;
    const ui::DisplayUnits units = session.units();
    const ui::Measure measure = measure_of(range.component);
    const double shown = units.shown(range.*end, measure);
    const std::string text = ui::number_text(shown, units.format());
    ui::begin_field_row(session.tr()(is_low ? translatable("Range from") : translatable("Range to")), text);
    const auto event = number_fields.show(is_low ? "range low" : "range high",
                                          {.text = text, .exact_text = text, .value = shown});
    using Kind = ui::NumberFieldEvent::Kind;
    KeptRange changed = range;
    if (event.kind == Kind::Dragged) changed.*end = units.stored(event.value, measure);
    else if (event.kind == Kind::Typed) {
        const auto typed = drawing::quantity_typed(event.text, measure, session.model().units, units);
        if (const auto* fault = std::get_if<femoop::Fault>(&typed))
            return number_fields.reject(event, reason_of(session, *fault));
        changed.*end = std::get<femoop::Quantity>(typed);
    } else return;
    if (changed.low < changed.high) session.look.range = changed;
    else if (event.kind == Kind::Typed)
        number_fields.reject(event,
                             session.tr()(translatable("the range goes from the smaller number to the larger one")));
}

void range_rows(Workspace& workspace, const CommandTable& commands, ui::NumberFields& number_fields)
{
    if (workspace.session.input().result == nullptr) return;
    switch_box(workspace, commands, "results.keep_range");
    if (!commands.find("results.keep_range")->is_on(workspace)) return;
    const KeptRange range = *workspace.session.look.range;
    range_row(workspace, number_fields, range, &KeptRange::low);
    range_row(workspace, number_fields, range, &KeptRange::high);
}

/// Where the error is shown: how many cycles, and the button that starts them, or stops them.
void refinement_rows(Workspace& workspace, const CommandTable& commands, ui::NumberFields& number_fields)
{
    Session& session = workspace.session;
    if (!session.look.error && session.cycle() == nullptr && !session.is_refining()) return;
    const std::string text = std::to_string(session.look.n_cycles);
    ui::begin_field_row(session.tr()(translatable("Cycles")), text);
    const auto event = number_fields.show(
        "cycles", {.text = text, .exact_text = text, .value = std::nullopt, .is_typed_only = true});
    if (event.kind == ui::NumberFieldEvent::Kind::Typed) {
        const auto typed = ui::number_typed(event.text);
        constexpr auto most = static_cast<double>(discretize::ErrorCycle::most_cycles);
        if (typed && *typed >= 1.0 && *typed <= most && *typed == std::floor(*typed))
            session.look.n_cycles = static_cast<std::size_t>(*typed);
        else number_fields.reject(event, session.tr()(translatable("a whole number from 1 to 8 is wanted here")));
    }
    ui::command_button(workspace, commands, session.is_refining() ? "results.stop_refining" : "results.refine");
}

/// How strong the image behind the drawing is, in percent.
void backdrop_rows(Workspace& workspace, const CommandTable& commands, ui::NumberFields& number_fields)
{
    Session& session = workspace.session;
    if (!session.document().backdrop) return;
    switch_box(workspace, commands, "view.show.background");
    if (!session.look.backdrop) return;
    using Kind = ui::NumberFieldEvent::Kind;
    const double percent = 100.0 * session.document().backdrop->opacity;
    const std::string text = ui::number_text(percent, session.units().format());
    ui::begin_field_row(session.tr()(translatable("Strength [%]")), text);
    const auto event = number_fields.show("opacity", {.text = text, .exact_text = text, .value = percent});
    if (event.kind == Kind::Settled) session.settle();
    if (event.kind == Kind::Dragged)
        session.change(opacity_change(std::clamp(event.value / 100.0, least_opacity, 1.0), Step::Drag));
    if (event.kind != Kind::Typed) return;
    const auto typed = ui::number_typed(event.text);
    if (typed && *typed >= 100.0 * least_opacity && *typed <= 100.0)
        workspace.change(opacity_change(*typed / 100.0, Step::Click));
    else number_fields.reject(event, session.tr()(translatable("a percentage from 5 to 100 is wanted here")));
}

} // namespace

void tool_bar(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    for (const ToolEntry& entry : tools()) {
        if (why_not(*commands.find(entry.id), workspace)) continue;
        tool_button(workspace, commands, entry, gui, fonts);
        ImGui::SameLine();
    }
}

void show_panel(Workspace& workspace, const CommandTable& commands, ui::NumberFields& number_fields)
{
    ImGui::TextUnformatted(workspace.tr()("Show").c_str());
    ImGui::Separator();
    for (const char* id : {"view.show.regions", "view.show.supports", "view.show.loads", "view.show.values",
                           "view.show.names", "view.show.legend"})
        switch_box(workspace, commands, id);
    backdrop_rows(workspace, commands, number_fields);
    ImGui::Spacing();
    ImGui::TextUnformatted(workspace.tr()("Results").c_str());
    ImGui::Separator();
    const Look& look = workspace.session.look;
    for (const char* id : {"results.mesh", "results.deformed"}) switch_box(workspace, commands, id);
    if (look.deformed || look.vectors) switch_box(workspace, commands, "results.vectors");
    for (const char* id :
         {"results.principal", "results.trajectories", "results.error", "results.reactions", "results.circle"})
        switch_box(workspace, commands, id);
    for (const char* id : {"results.animate", "results.modes"}) switch_box(workspace, commands, id);
    refinement_rows(workspace, commands, number_fields);
    const auto field = workspace.session.look.field;
    ui::command_combo(workspace, commands, "###field", fields(),
                      [&](const FieldEntry& entry) { return entry.value == field; });
    if (field) switch_box(workspace, commands, "results.lines");
    switch_box(workspace, commands, "results.element_values");
    if (field) range_rows(workspace, commands, number_fields);
    ImGui::Spacing();
    ImGui::TextUnformatted(workspace.tr()("Draw").c_str());
    ImGui::Separator();
    for (const char* id : {"draw.grid", "draw.parts"}) switch_box(workspace, commands, id);
}

} // namespace plane
