#include "apps/frame/window/context_menu.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/frame/session/load_commands.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using ui::translatable;

namespace {

using Ids = std::span<const std::string_view>;

constexpr std::array<std::string_view, 2> why{"view.why", "view.release"};
constexpr std::array<std::string_view, 6> beginnings{"edit.paste",  "edit.template", "case.new",
                                                     "draw.member", "draw.load",     "edit.select_all"};
constexpr std::array<std::string_view, 4> changes{"edit.move", "edit.copy", "edit.rotate", "edit.mirror"};
constexpr std::array<std::string_view, 3> methods{"edit.section", "methods.distribution", "methods.circle"};
constexpr std::array<std::string_view, 5> ends{"edit.keep_under_name", "edit.select_similar", "edit.cut", "edit.clip",
                                               "edit.delete"};

template <class Id> bool is_any(const Selection& selection)
{
    return std::ranges::any_of(selection.parts(), [](const Part& part) { return std::holds_alternative<Id>(part); });
}

void show(Workspace& workspace, const CommandTable& commands, Ids ids)
{
    const ui::Catalogue tr = workspace.session.view.tr; // a command may change the language
    for (const std::string_view id : ids) ui::show_command(*commands.find(id), workspace, tr);
}

bool has_members(const Selection& selection)
{
    return is_any<femoop::MemberId>(selection) || is_any<MemberLoadPlace>(selection);
}

std::vector<std::string_view> loads_for(const Session& session)
{
    const Selection& selection = session.selection;
    if (has_members(selection)) return loads_for_members(session.model().analysis);
    const bool has_nodes = is_any<femoop::NodeId>(selection) || is_any<NodeLoadPlace>(selection) ||
                           is_any<SettlementPlace>(selection);
    return has_nodes ? loads_for_nodes(session.model().analysis) : std::vector<std::string_view>{};
}

// It opens in the frame after the click.
bool is_asked_for(const Workspace& workspace)
{
    return std::ranges::find(workspace.requests, Request::ContextMenu) != workspace.requests.end();
}

void forget_place(Workspace& workspace)
{
    workspace.menu_cut.reset();
    workspace.menu_number.reset();
}

} // namespace

void ContextMenu::show(Workspace& workspace, const CommandTable& commands)
{
    if (std::exchange(opens_, false)) ImGui::OpenPopup("###context");
    if (!ImGui::BeginPopup("###context")) {
        if (!is_asked_for(workspace)) forget_place(workspace);
        return;
    }
    if (workspace.menu_number) {
        const bool is_released = is_force(workspace.menu_number->effect);
        frame::show(workspace, commands, is_released ? Ids(why) : Ids(why).first(1));
        ImGui::Separator();
    }
    const Selection selection = workspace.session.selection; // a command may change it
    if (selection.is_empty()) {
        frame::show(workspace, commands, beginnings);
        return ImGui::EndPopup();
    }
    if (const auto loads = loads_for(workspace.session); !loads.empty()) {
        frame::show(workspace, commands, loads);
        ImGui::Separator();
    }
    if (is_any<femoop::NodeId>(selection) || is_any<femoop::MemberId>(selection)) {
        frame::show(workspace, commands, changes);
        ImGui::Separator();
    }
    if (is_any<femoop::MemberId>(selection)) {
        frame::show(workspace, commands, methods);
        ImGui::Separator();
    }
    frame::show(workspace, commands, ends);
    ImGui::EndPopup();
}

void add_load_button(Workspace& workspace, const CommandTable& commands)
{
    const std::vector<std::string_view> loads = loads_for(workspace.session);
    if (loads.empty()) return;
    const std::string_view label = has_members(workspace.session.selection)
                                       ? translatable("Add a load or temperature…")
                                       : translatable("Add a load, settlement or spring…");
    if (ui::wrapped_button(workspace.session.view.tr(label), "add load")) ImGui::OpenPopup("###loads");
    if (!ImGui::BeginPopup("###loads")) return;
    show(workspace, commands, loads);
    ImGui::EndPopup();
}

} // namespace frame
