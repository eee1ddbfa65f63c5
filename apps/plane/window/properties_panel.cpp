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

template <class Has> bool all_supports(const Session& session, const std::vector<Part>& parts, Has has)
{
    return std::ranges::all_of(parts, [&](const Part& part) {
        const PlaneSupport* const support = support_of(session, part);
        return support != nullptr && has(*support);
    });
}

void hold_box(Workspace& workspace, const std::vector<Part>& parts, Dof dof)
{
    bool is_held = all_supports(workspace.session, parts,
                                [dof](const PlaneSupport& support) { return support.fixed.contains(dof); });
    const std::string name(femoop::name(dof));
    if (!ImGui::Checkbox((name + "###hold " + name).c_str(), &is_held)) return;
    change_supports(workspace, parts, translatable("Change the support"), [dof, is_held](PlaneSupport& changed) {
        set_hold(changed, dof, is_held ? Hold::Blocked : Hold::Free);
    });
}

void axes_box(Workspace& workspace, const std::vector<Part>& parts)
{
    bool is_local = all_supports(workspace.session, parts,
                                 [](const PlaneSupport& support) { return support.is_local; });
    const std::string label = workspace.tr()("Axes along the curve");
    if (!ImGui::Checkbox(ui::label_beside_box(label, "local").c_str(), &is_local)) return;
    change_supports(workspace, parts, translatable("Change the support"), [is_local](PlaneSupport& changed) {
        changed.is_local = is_local;
        if (is_local) changed.angle = femoop::Quantity(0.0);
    });
}

void tie_box(Workspace& workspace, const CommandTable& commands, std::string_view id)
{
    const auto& command = *commands.find(id);
    bool is_tied = command.is_on(workspace);
    const std::string label = ui::label_beside_box(workspace.tr()(command.label), id);
    if (ImGui::Checkbox(label.c_str(), &is_tied)) run(command, workspace);
}

void support_rows(Workspace& workspace, const CommandTable& commands, const std::vector<Part>& parts)
{
    const bool are_curves = !all_of_kind<CurveId>(parts).empty();
    const ui::Catalogue tr = workspace.tr();
    ImGui::Spacing();
    ImGui::TextUnformatted(tr("Support").c_str());
    const std::array ids{"support.none", "support.fixed", "support.roller", "support.symmetry", "support.own"};
    for (const std::string_view id : ids) {
        if (id == "support.symmetry" && !are_curves) continue;
        const auto& command = *commands.find(id);
        if (ImGui::RadioButton(ui::item_label(tr(command.label), id).c_str(), command.is_on(workspace)))
            run(command, workspace);
    }
    if (are_curves) {
        tie_box(workspace, commands, "support.tie_ux");
        tie_box(workspace, commands, "support.tie_uy");
    }
    const auto has_own_axes = [](const PlaneSupport& support) { return support.kind == PlaneSupportKind::Custom; };
    if (!all_supports(workspace.session, parts, has_own_axes)) return;
    hold_box(workspace, parts, Dof::ux);
    ImGui::SameLine();
    hold_box(workspace, parts, Dof::uy);
    if (are_curves) axes_box(workspace, parts);
}

// ---- loads

void axes_row(Workspace& workspace, const std::vector<CurveId>& curves, const LoadPlaces& places)
{
    const Session& session = workspace.session;
    const std::size_t load_case = session.load_case;
    bool is_local = true;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto& load = load_on(session.model(), load_case, places[i], curves[i]);
        if (load.kind == CurveLoadKind::Pressure) return;
        is_local = is_local && load.axes == femoop::LoadAxes::Local;
    }
    const std::string label = workspace.tr()("Axes along the curve");
    if (!ImGui::Checkbox(ui::label_beside_box(label, "load axes").c_str(), &is_local)) return;
    const auto axes = is_local ? femoop::LoadAxes::Local : femoop::LoadAxes::Global;
    workspace.change({translatable("Turn the axes of a load"), [=](Document& document) {
                          for (std::size_t i = 0; i < curves.size(); ++i)
                              own_load(document, load_case, places[i], curves[i]).axes = axes;
                      }});
}

void axes_row(Workspace& /*workspace*/, const std::vector<RegionId>& /*regions*/, const LoadPlaces& /*places*/) {}

template <class Id>
void load_rows(Workspace& workspace, ui::NumberFields& fields, const std::vector<Id>& holders, const LoadPlaces& places)
{
    const Session& session = workspace.session;
    const std::size_t load_case = session.load_case;
    ImGui::Separator();
    const auto& shown = load_on(session.model(), load_case, places.front(), holders.front());
    ImGui::TextUnformatted(session.tr()(word_of(shown)).c_str());
    number_rows(workspace, fields, title(session, session.selection()), numbers_of_load(session, holders, places));
    axes_row(workspace, holders, places);
    if (ui::wrapped_button(workspace.tr()("Take the load away"), "take load"))
        workspace.change({translatable("Take a load away"), [=](Document& document) {
                              for (std::size_t i = 0; i < holders.size(); ++i)
                                  erase_load(document, load_case, places[i], holders[i]);
                          }});
}

template <class Id>
void all_load_rows(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields,
                   const std::vector<Id>& holders, const std::array<const char*, 3>& adding)
{
    const Session& session = workspace.session;
    const auto loads = [&] { return loads_of_all(session.model(), session.load_case, holders); };
    ImGui::Spacing();
    for (std::size_t i = 0; i < loads().size(); ++i) { // one may be taken away in this frame
        ImGui::PushID(static_cast<int>(i));
        load_rows(workspace, fields, holders, loads()[i]);
        ImGui::PopID();
    }
    ImGui::Spacing();
    for (const char* id : adding) ui::command_button(workspace, commands, id);
}

// ---- faces

void region_rows(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields,
                 const std::vector<RegionId>& regions)
{
    const Session& session = workspace.session;
    number_rows(workspace, fields, title(session, session.selection()), numbers_of(session, session.selection()));
    material_rows(workspace, fields, regions);
    mesh_rows(workspace, regions);
    ImGui::Separator();
    case_number_rows(workspace, fields);
    all_load_rows(workspace, commands, fields, regions, {"load.body", "load.temperature", "load.rotation"});
}

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
    if (!is_hole) region_rows(workspace, commands, fields, {*region});
}

/// Of several: what regions of material can be given.
void faces_rows(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields)
{
    const std::vector<RegionId> regions = workspace.session.selected_regions();
    const auto is_hole = [&](RegionId region) { return workspace.session.model()[region].is_hole; };
    if (!regions.empty() && std::ranges::none_of(regions, is_hole)) region_rows(workspace, commands, fields, regions);
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
    if (number.differs) row.text = tr("several values");
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
    const std::vector<Part> parts = session.selection();
    ui::wrapped_text(tr(title(session, parts)));
    ImGui::Separator();
    if (parts.size() == 1) {
        if (const auto* const place = std::get_if<FacePlace>(&parts.front()))
            return face_rows(workspace, commands, fields, *place);
        if (const auto* const point = std::get_if<NodeId>(&parts.front())) name_row(workspace, fields, *point);
        if (const auto* const curve = std::get_if<CurveId>(&parts.front())) name_row(workspace, fields, *curve);
    }
    if (!all_of_kind<FacePlace>(parts).empty()) return faces_rows(workspace, commands, fields);
    number_rows(workspace, fields, title(session, parts), numbers_of(session, parts));
    support_rows(workspace, commands, parts);
    const std::vector<CurveId> curves = all_of_kind<CurveId>(parts);
    if (!curves.empty() && session.selection() == parts)
        all_load_rows(workspace, commands, fields, curves, {"load.traction", "load.pressure", "load.line"});
}

} // namespace plane
