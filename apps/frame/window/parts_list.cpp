#include "apps/frame/window/parts_list.h"

#include "apps/frame/document/load_cases.h"
#include "apps/frame/session/case_commands.h"
#include "ui/widgets/item_label.h"

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace frame {

using namespace femoop;
using ui::translatable;

namespace {

// A case that is chosen is shown too.
void select(Session& session, const Part& part)
{
    session.selection = part;
    if (const auto id = case_id_of(session.model(), part)) show_case(session, *id);
}

void show_list(Workspace& workspace, std::string_view heading, const std::vector<Part>& list)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    const std::string label = tr(heading) + "  (" + std::to_string(list.size()) + ")###" + std::string(heading);
    if (list.empty() || !ImGui::CollapsingHeader(label.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::PushID(heading.data());
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(list.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Part& part = list[static_cast<std::size_t>(i)];
            const std::string name = ui::item_label(tr(title(workspace.session.model(), part)), std::to_string(i));
            if (ImGui::Selectable(name.c_str())) select(workspace.session, part);
        }
    }
    ImGui::PopID();
}

template <class... Types> std::vector<Part> of_type(const std::vector<Part>& all)
{
    std::vector<Part> chosen;
    for (const Part& part : all) {
        if ((std::holds_alternative<Types>(part) || ...)) chosen.push_back(part);
    }
    return chosen;
}

} // namespace

void parts_list(Workspace& workspace, PropertySets& sets, TitleRows& title)
{
    title.show(workspace);
    const std::vector<Part> all = parts(workspace.session.model());
    ImGui::TextWrapped("%s",
                       workspace.session.view.tr("Click a part in the picture or in this list to change it.").c_str());
    ImGui::Spacing();
    show_list(workspace, translatable("Members"), of_type<MemberId>(all));
    show_list(workspace, translatable("Nodes"), of_type<NodeId>(all));
    show_list(workspace, translatable("Materials"), of_type<MaterialId>(all));
    show_list(workspace, translatable("Sections"), of_type<SectionId>(all));
    sets.show_named(workspace);
    property_buttons(workspace);
    show_list(workspace, translatable("Load cases"), of_type<LoadCasePlace>(all));
    show_list(workspace, translatable("Loads"), of_type<NodeLoadPlace, SettlementPlace, MemberLoadPlace>(all));
    show_list(workspace, translatable("Combinations"), of_type<CombinationPlace>(all));
}

} // namespace frame
