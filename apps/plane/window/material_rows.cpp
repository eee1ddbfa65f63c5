#include "apps/plane/window/material_rows.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apps/plane/document/erase.h"
#include "apps/plane/document/fresh_id.h"
#include "apps/plane/document/number.h"
#include "apps/plane/window/properties_panel.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace plane {

using ui::translatable;

namespace {

void give(Document& document, const std::vector<RegionId>& regions, MaterialId material)
{
    for (const RegionId region : regions) document.model.regions[region.index].material = material;
}

void choose(Workspace& workspace, const std::vector<RegionId>& regions, MaterialId material)
{
    workspace.change(
        {translatable("Change the material"), [=](Document& document) { give(document, regions, material); }});
}

void add_material(Workspace& workspace, const std::vector<RegionId>& regions)
{
    workspace.change({translatable("Add a material"), [regions](Document& document) {
                          auto& materials = document.model.materials;
                          femoop::Material another = materials[document.model[regions.front()].material.index];
                          another.id = fresh_id(materials, another.id);
                          materials.push_back(std::move(another));
                          give(document, regions, MaterialId(materials.size() - 1));
                      }});
}

std::vector<bool> unused_materials(const PlaneModel& model)
{
    std::vector<bool> is_unused(model.materials.size(), true);
    for (const auto& region : model.regions)
        if (region.material.index < is_unused.size()) is_unused[region.material.index] = false;
    return is_unused;
}

void unused_row(Workspace& workspace)
{
    const std::vector<bool> unused = unused_materials(workspace.session.model());
    if (std::ranges::find(unused, true) == unused.end()) return;
    if (ui::wrapped_button(workspace.tr()("Delete unused materials"), "delete materials"))
        workspace.change({translatable("Delete unused materials"), [](Document& document) {
                              Erased erased;
                              erased.materials = unused_materials(document.model);
                              erase_entries(document.model, erased);
                          }});
}

} // namespace

void material_rows(Workspace& workspace, ui::NumberFields& fields, const std::vector<RegionId>& regions)
{
    const PlaneModel& model = workspace.session.model();
    const ui::Catalogue tr = workspace.tr();
    const MaterialId material = model[regions.front()].material;
    if (material.index >= model.materials.size()) return;
    const bool are_alike = std::ranges::all_of(regions,
                                               [&](RegionId region) { return model[region].material == material; });
    ImGui::Spacing();
    ImGui::TextUnformatted(tr("Material").c_str());
    std::vector<std::string> names;
    for (const auto& one : model.materials) names.push_back(one.id);
    if (ui::begin_wrapped_combo(are_alike ? model[material].id : tr("several values"), names, "###material")) {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (ImGui::Selectable(ui::item_label(names[i], std::to_string(i)).c_str(),
                                  are_alike && i == material.index))
                choose(workspace, regions, MaterialId(i));
        ImGui::EndCombo();
    }
    if (!are_alike) return;
    if (ui::wrapped_button(tr("Add a material like it"), "add material")) add_material(workspace, regions);
    unused_row(workspace);
    const MaterialId now = workspace.session.model()[regions.front()].material;
    name_row(workspace, fields, now);
    const PlaneModel& renamed = workspace.session.model();
    const MaterialId kept = renamed[regions.front()].material;
    const ui::Message whose(translatable("Material {id}"), {{"id", renamed[kept].id}});
    number_rows(workspace, fields, whose, numbers(renamed, kept));
}

} // namespace plane
