#include "apps/plane/window/properties_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "apps/plane/document/attributes.h"
#include "apps/plane/document/load_cases.h"
#include "apps/plane/document/regions.h"
#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/session/part_commands.h"
#include "apps/plane/window/material_rows.h"
#include "apps/plane/window/mesh_rows.h"
#include "femoop/io/plane/field_text.h"
#include "ui/text/number_format.h"
#include "ui/widgets/command_combo.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace plane {

using femoop::Dof;
using femoop::plane::CurveLoadKind;
using ui::translatable;
using Kind = ui::NumberFieldEvent::Kind;

namespace {

constexpr int digits_to_edit = 15;

void number_row(Workspace& workspace, ui::NumberFields& fields, const ui::Message& whose, const Number& number)
{
    const ShownNumber row = shown(workspace.session, number);
    ui::begin_field_row(row.label, row.text);
    take_number(workspace, fields, whose, number,
                fields.show("number " + number.id, {.text = row.text, .exact_text = row.exact, .value = row.value}));
}

// ---- supports

void hold_box(Workspace& workspace, const Part& part, Dof dof)
{
    const PlaneSupport& support = *support_of(workspace.session, part);
    bool is_held = support.fixed.contains(dof);
    const std::string name(femoop::name(dof));
    if (!ImGui::Checkbox((name + "###hold " + name).c_str(), &is_held)) return;
    change_support(workspace, part, translatable("Change the support"), [dof, is_held](PlaneSupport& changed) {
        set_hold(changed, dof, is_held ? Hold::Blocked : Hold::Free);
    });
}

void tie_box(Workspace& workspace, const CommandTable& commands, std::string_view id)
{
    const auto& command = *commands.find(id);
    bool is_tied = command.is_on(workspace);
    const std::string label = ui::label_beside_box(workspace.tr()(command.label), id);
    if (ImGui::Checkbox(label.c_str(), &is_tied)) run(command, workspace);
}

void support_rows(Workspace& workspace, const CommandTable& commands, const Part& part)
{
    const ui::Catalogue tr = workspace.tr();
    ImGui::Spacing();
    ImGui::TextUnformatted(tr("Support").c_str());
    const std::array ids{"support.none", "support.fixed", "support.roller", "support.symmetry", "support.own"};
    for (const std::string_view id : ids) {
        if (id == "support.symmetry" && !std::holds_alternative<CurveId>(part)) continue;
        const auto& command = *commands.find(id);
        if (ImGui::RadioButton(ui::item_label(tr(command.label), id).c_str(), command.is_on(workspace)))
            run(command, workspace);
    }
    if (std::holds_alternative<CurveId>(part)) {
        tie_box(workspace, commands, "support.tie_ux");
        tie_box(workspace, commands, "support.tie_uy");
    }
    const PlaneSupport* const support = support_of(workspace.session, part);
    if (support == nullptr || support->kind != PlaneSupportKind::Custom) return;
    hold_box(workspace, part, Dof::ux);
    ImGui::SameLine();
    hold_box(workspace, part, Dof::uy);
    if (!std::holds_alternative<CurveId>(part)) return;
    bool is_local = support->is_local;
    if (ImGui::Checkbox(ui::label_beside_box(tr("Axes along the curve"), "local").c_str(), &is_local))
        change_support(workspace, part, translatable("Change the support"), [is_local](PlaneSupport& changed) {
            changed.is_local = is_local;
            if (is_local) changed.angle = femoop::Quantity(0.0);
        });
}

// ---- loads

std::string load_title(const Session& session, CurveId /*curve*/, std::size_t load)
{
    return session.tr()(word_of(session.model().load_cases[session.load_case].curves[load]));
}

std::string load_title(const Session& session, RegionId /*region*/, std::size_t load)
{
    return session.tr()(word_of(session.model().load_cases[session.load_case].regions[load]));
}

void axes_row(Workspace& workspace, CurveId curve, std::size_t load)
{
    const std::size_t load_case = workspace.session.load_case;
    const auto& shown = workspace.session.model().load_cases[load_case].curves[load];
    if (shown.kind == CurveLoadKind::Pressure) return;
    bool is_local = shown.axes == femoop::LoadAxes::Local;
    const std::string label = workspace.tr()("Axes along the curve");
    if (ImGui::Checkbox(ui::label_beside_box(label, "load axes").c_str(), &is_local))
        workspace.change({translatable("Turn the axes of a load"), [=](Document& document) {
                              own_load(document, load_case, load, curve).axes = is_local ? femoop::LoadAxes::Local
                                                                                         : femoop::LoadAxes::Global;
                          }});
}

void axes_row(Workspace& /*workspace*/, RegionId /*region*/, std::size_t /*load*/) {}

template <class Id>
void load_rows(Workspace& workspace, ui::NumberFields& fields, const Part& part, Id holder, std::size_t load)
{
    const Session& session = workspace.session;
    const std::size_t load_case = session.load_case;
    ImGui::Separator();
    ImGui::TextUnformatted(load_title(session, holder, load).c_str());
    number_rows(workspace, fields, title(session, part), numbers(session.model(), load_case, load, holder));
    axes_row(workspace, holder, load);
    if (ui::wrapped_button(workspace.tr()("Take the load away"), "take load"))
        workspace.change({translatable("Take a load away"),
                          [=](Document& document) { erase_load(document, load_case, load, holder); }});
}

template <class Id>
void all_load_rows(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields, const Part& part,
                   Id holder, const std::array<const char*, 3>& adding)
{
    ImGui::Spacing();
    for (const std::size_t load : loads_on(workspace.session.model(), workspace.session.load_case, holder)) {
        const auto& now = loads_on(workspace.session.model(), workspace.session.load_case, holder);
        if (std::ranges::find(now, load) == now.end()) break; // it was taken away in this frame
        ImGui::PushID(static_cast<int>(load));
        load_rows(workspace, fields, part, holder, load);
        ImGui::PopID();
    }
    ImGui::Spacing();
    for (const char* id : adding) ui::command_button(workspace, commands, id);
}

// ---- faces

void face_rows(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields, const FacePlace& place)
{
    const Session& session = workspace.session;
    const ui::Catalogue tr = workspace.tr();
    const auto face = session.face_of(place);
    if (!face) return;
    const double factor = session.units().unit(ui::Measure::Length).factor;
    const std::string area = ui::number_text(session.drawing()->faces()[*face].area * factor * factor,
                                             session.units().format());
    ui::wrapped_text(tr("area {area}", {{"area", area + " " + session.units().unit(ui::Measure::Length).name + "²"}}));
    const auto region = session.drawing()->faces()[*face].region;
    if (!region) {
        if (ui::wrapped_button(tr("Make a region"), "make region")) make_region_at(workspace, place);
        return;
    }
    const std::size_t n = faces_of_regions(*session.drawing())[region->index].size();
    if (n > 1) {
        ui::wrapped_text(tr("The region has {count} faces; what is given here is given to all of them.",
                            {{"count", std::to_string(n)}}));
        ui::command_button(workspace, commands, "region.own");
    }
    const auto& hole = *commands.find("region.hole");
    bool is_hole = hole.is_on(workspace);
    if (ImGui::Checkbox(ui::label_beside_box(tr("Hole"), "hole").c_str(), &is_hole)) {
        run(hole, workspace);
        return;
    }
    name_row(workspace, fields, *region);
    if (is_hole) return;
    number_rows(workspace, fields, title(session, place), numbers_of(session, place));
    material_rows(workspace, fields, *region);
    mesh_rows(workspace, *region);
    ImGui::Separator();
    case_number_rows(workspace, fields);
    all_load_rows(workspace, commands, fields, place, *region, {"load.body", "load.temperature", "load.rotation"});
}

void show_nothing_selected(Workspace& workspace)
{
    const ui::Catalogue& tr = workspace.tr();
    ui::wrapped_text(tr("Nothing is selected. Click a point, a curve or a face."));
}

} // namespace

void name_row(Workspace& workspace, ui::NumberFields& fields, const Named& entry)
{
    const Session& session = workspace.session;
    const std::string name = name_of(session.model(), entry);
    const ui::Catalogue tr = workspace.tr();
    ui::begin_field_row(tr("Name"), name);
    const std::string id = "name " + std::to_string(entry.index());
    const auto event = fields.show(id, {.text = name, .exact_text = name, .value = {}, .is_typed_only = true});
    if (event.kind != Kind::Typed) return;
    if (const auto reason = why_not_named(session.model(), entry, event.text)) fields.reject(event, tr(*reason));
    else
        workspace.change({translatable("Rename"),
                          [entry, text = event.text](Document& document) { rename(document, entry, text); }});
}

ShownNumber shown(const Session& session, const Number& number)
{
    const ui::Catalogue& tr = session.tr();
    const ui::DisplayUnits units = session.units();
    ShownNumber row;
    const std::string name = tr(number.label);
    row.label = units.label(name, number.measure);
    row.text = tr(number.is_optional ? translatable("not given") : "");
    if (number.field) {
        row.text = tr(form_of(*number.field));
        row.exact = femoop::plane::field_text(*number.field);
    }
    if (!number.value) return row;
    row.value = units.shown(*number.value, number.measure);
    row.text = ui::number_text(*row.value, units.format());
    row.exact = number.value->has_text() ? std::string(number.value->text())
                                         : ui::number_text(*row.value, {digits_to_edit, units.format().mark});
    return row;
}

void take_number(Workspace& workspace, ui::NumberFields& fields, const ui::Message& whose, const Number& number,
                 const ui::NumberFieldEvent& event)
{
    Session& session = workspace.session;
    if (event.kind == Kind::Settled) session.settle();
    if (event.kind == Kind::Dragged) {
        const double stored = session.units().stored(event.value, number.measure);
        session.change(change_of(whose, number, femoop::Quantity(stored), Step::Drag));
    }
    if (event.kind != Kind::Typed) return;
    if (const auto reason = set_typed(workspace, whose, number, event.text))
        fields.reject(event, session.tr()(*reason));
}

void number_rows(Workspace& workspace, ui::NumberFields& fields, const ui::Message& whose,
                 const std::vector<Number>& all)
{
    for (const Number& number : all) number_row(workspace, fields, whose, number);
}

void case_number_rows(Workspace& workspace, ui::NumberFields& fields)
{
    const Session& session = workspace.session;
    const femoop::CaseId shown(session.load_case);
    if (shown.index >= session.model().n_cases()) return;
    number_rows(workspace, fields, title(session, shown), numbers(session.model(), shown));
}

void properties_panel(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields)
{
    const Session& session = workspace.session;
    const ui::Catalogue tr = workspace.tr();
    if (session.selection().empty()) return show_nothing_selected(workspace);
    if (session.selection().size() > 1) {
        ui::wrapped_text(tr("Selected: {count}", {{"count", std::to_string(session.selection().size())}}));
        for (const char* id : {"support.none", "support.fixed", "support.roller"})
            ui::command_button(workspace, commands, id);
        return;
    }
    const Part part = session.selection().front();
    ui::wrapped_text(tr(title(session, part)));
    ImGui::Separator();
    if (const auto* const place = std::get_if<FacePlace>(&part)) return face_rows(workspace, commands, fields, *place);
    if (const auto* const point = std::get_if<NodeId>(&part)) name_row(workspace, fields, *point);
    if (const auto* const curve = std::get_if<CurveId>(&part)) name_row(workspace, fields, *curve);
    number_rows(workspace, fields, title(session, part), numbers_of(session, part));
    support_rows(workspace, commands, part);
    if (const auto* const curve = std::get_if<CurveId>(&part); curve != nullptr && session.is_selected(part))
        all_load_rows(workspace, commands, fields, part, *curve, {"load.traction", "load.pressure", "load.line"});
}

} // namespace plane
