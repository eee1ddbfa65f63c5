#include "apps/plane/window/mesh_rows.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "apps/plane/view/mesh_words.h"
#include "femoop/element/continuum/continuum_formulation.h"
#include "femoop/shape/shape.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace plane {

using femoop::ShapeKind;
using femoop::plane::Formulation;
using femoop::plane::MeshOptions;
using ui::translatable;

namespace {

/// A choice out of a list; the first stands for the file's.
struct Combo {
    std::string_view label; ///< translatable
    std::vector<std::string> names;
    std::optional<std::size_t> chosen; ///< nothing: regions that differ
};

std::optional<std::size_t> show(const Combo& combo, const ui::Catalogue& tr)
{
    std::optional<std::size_t> chosen;
    ImGui::TextUnformatted(tr(combo.label).c_str());
    const std::string shown = combo.chosen ? combo.names[*combo.chosen] : tr("several values");
    if (!ui::begin_wrapped_combo(shown, combo.names, ("###" + std::string(combo.label)).c_str())) return chosen;
    for (std::size_t i = 0; i < combo.names.size(); ++i)
        if (ImGui::Selectable(ui::item_label(combo.names[i], std::to_string(i)).c_str(), i == combo.chosen)) chosen = i;
    ImGui::EndCombo();
    return chosen;
}

template <class Change>
void change_meshes(Workspace& workspace, const std::vector<RegionId>& regions, const Change& change)
{
    workspace.change({translatable("Change the mesh of a region"), [=](Document& document) {
                          for (const RegionId region : regions) change(document.model.regions[region.index].mesh);
                      }});
}

constexpr std::array<std::string_view, 8> methods{"auto",     "mapped", "trilateral", "sweep",
                                                  "delaunay", "front",  "quadtree",   "quads"};
constexpr std::array elements{ShapeKind::T3, ShapeKind::T6, ShapeKind::Q4, ShapeKind::Q8, ShapeKind::Q9};
constexpr std::array formulations{Formulation::Standard, Formulation::Reduced, Formulation::BBar,
                                  Formulation::Incompatible};

template <class List, class Value> std::size_t place_in(const List& list, const Value& value)
{
    for (std::size_t i = 0; i < list.size(); ++i)
        if (value == list[i]) return i + 1;
    return 0;
}

/// Of a choice that all meshes have made.
template <class List, class Value>
std::optional<std::size_t> common_place(const List& list, const std::vector<MeshOptions>& meshes,
                                        Value MeshOptions::*value)
{
    const Value& first = meshes.front().*value;
    const bool are_alike = std::ranges::all_of(meshes, [&](const MeshOptions& m) { return m.*value == first; });
    return are_alike ? std::optional(place_in(list, first)) : std::nullopt;
}

} // namespace

void mesh_rows(Workspace& workspace, const std::vector<RegionId>& regions)
{
    const ui::Catalogue tr = workspace.tr();
    std::vector<MeshOptions> meshes;
    for (const RegionId region : regions) meshes.push_back(workspace.session.model()[region].mesh);
    const std::string usual = tr("as the whole drawing");
    ImGui::Spacing();
    ImGui::Separator();
    Combo method{translatable("Method of the mesh"), {usual}, common_place(methods, meshes, &MeshOptions::method)};
    for (const std::string_view name : methods) method.names.push_back(tr(method_word(name)));
    if (const auto i = show(method, tr))
        change_meshes(workspace, regions,
                      [i](MeshOptions& m) { m.method = *i == 0 ? "" : std::string(methods[*i - 1]); });
    Combo element{translatable("Element"), {usual}, common_place(elements, meshes, &MeshOptions::element)};
    for (const ShapeKind kind : elements) element.names.emplace_back(femoop::name(kind));
    if (const auto i = show(element, tr))
        change_meshes(workspace, regions,
                      [i](MeshOptions& m) { m.element = *i == 0 ? std::nullopt : std::optional(elements[*i - 1]); });
    Combo formulation{
        translatable("Formulation"), {usual}, common_place(formulations, meshes, &MeshOptions::formulation)};
    for (const Formulation one : formulations) formulation.names.push_back(tr(formulation_word(one)));
    if (const auto i = show(formulation, tr))
        change_meshes(workspace, regions, [i](MeshOptions& m) {
            m.formulation = *i == 0 ? std::nullopt : std::optional(formulations[*i - 1]);
        });
}

} // namespace plane
