#include "apps/plane/window/material_rows.h"

#include <imgui.h>

#include <string>
#include <vector>

#include "apps/plane/document/fresh_id.h"
#include "apps/plane/document/number.h"
#include "apps/plane/window/properties_panel.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace plane {

using ui::translatable;

namespace {

void choose(Workspace& workspace, RegionId region, MaterialId material)
{
    workspace.change({translatable("Change the material"),
                      [=](Document& document) { document.model.regions[region.index].material = material; }});
}

void add_material(Workspace& workspace, RegionId region)
{
    workspace.change({translatable("Add a material"), [region](Document& document) {
                          auto& materials = document.model.materials;
                          femoop::Material another = materials[document.model[region].material.index];
                          another.id = fresh_id(materials, another.id);
                          materials.push_back(std::move(another));
                          document.model.regions[region.index].material = MaterialId(materials.size() - 1);
                      }});
}

} // namespace

void material_rows(Workspace& workspace, ui::NumberFields& fields, RegionId region)
{
    const PlaneModel& model = workspace.session.model();
    const ui::Catalogue tr = workspace.tr();
    const MaterialId material = model[region].material;
    if (material.index >= model.materials.size()) return;
    ImGui::Spacing();
    ImGui::TextUnformatted(tr("Material").c_str());
    std::vector<std::string> names;
    for (const auto& one : model.materials) names.push_back(one.id);
    if (ui::begin_wrapped_combo(model[material].id, names, "###material")) {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (ImGui::Selectable(ui::item_label(names[i], std::to_string(i)).c_str(), i == material.index))
                choose(workspace, region, MaterialId(i));
        ImGui::EndCombo();
    }
    if (ui::wrapped_button(tr("Add a material like it"), "add material")) add_material(workspace, region);
    const MaterialId now = workspace.session.model()[region].material;
    name_row(workspace, fields, now);
    const PlaneModel& renamed = workspace.session.model();
    const ui::Message whose(translatable("Material {id}"), {{"id", renamed[renamed[region].material].id}});
    number_rows(workspace, fields, whose, numbers(renamed, renamed[region].material));
}

} // namespace plane
