#include "apps/frame/session/plane_commands.h"

#include <array>

namespace frame {

using ui::translatable;
using Normal = WorkingPlane::Normal;

namespace {

constexpr std::array plane_entries{
    PlaneEntry{Normal::Z, "draw.plane_xy", translatable("Draw in the plane xy"), "xy"},
    PlaneEntry{Normal::Y, "draw.plane_xz", translatable("Draw in the plane xz"), "xz"},
    PlaneEntry{Normal::X, "draw.plane_yz", translatable("Draw in the plane yz"), "yz"},
};

std::optional<ui::Message> why_not_in_space(const Workspace& workspace)
{
    if (femoop::is_3d(workspace.session.model().analysis)) return std::nullopt;
    return translatable("the structure is plane; a working plane is for structures in space");
}

void work_in(Workspace& workspace, Normal normal)
{
    WorkingPlane& plane = workspace.tool_controller.settings().plane;
    plane.normal = normal;
    const auto part = workspace.session.selection.only();
    const auto* const node = part ? std::get_if<femoop::NodeId>(&*part) : nullptr;
    if (node != nullptr) plane.level = workspace.session.model()[*node].at[static_cast<std::size_t>(plane.index())];
}

} // namespace

std::span<const PlaneEntry> working_planes() { return plane_entries; }

void add_plane_commands(CommandTable& table)
{
    const auto plane_now = [](const Workspace& workspace) -> std::optional<Normal> {
        return why_not_in_space(workspace) ? std::nullopt
                                           : std::optional(workspace.tool_controller.settings().plane.normal);
    };
    Menu menu(table, translatable("Draw"));
    for (const PlaneEntry& entry : plane_entries)
        menu.choice(ui::Choice<Normal>{entry.normal, entry.id, entry.label}, plane_now, work_in, why_not_in_space);
}

} // namespace frame
