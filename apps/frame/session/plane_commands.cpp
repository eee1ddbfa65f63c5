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

std::optional<ui::Phrase> why_not_in_space(const Desk& desk)
{
    if (femoop::is_3d(desk.session.model().analysis)) return std::nullopt;
    return translatable("the structure is plane; a working plane is for structures in space");
}

void work_in(Desk& desk, Normal normal)
{
    WorkingPlane& plane = desk.hand.settings().plane;
    plane.normal = normal;
    const auto part = desk.session.selection.only();
    const auto* const node = part ? std::get_if<femoop::NodeId>(&*part) : nullptr;
    if (node != nullptr) plane.level = desk.session.model()[*node].at[static_cast<std::size_t>(plane.index())];
}

} // namespace

std::span<const PlaneEntry> working_planes() { return plane_entries; }

void add_plane_commands(CommandTable& table)
{
    const auto plane_now = [](const Desk& desk) -> std::optional<Normal> {
        return why_not_in_space(desk) ? std::nullopt : std::optional(desk.hand.settings().plane.normal);
    };
    Menu menu(table, translatable("Draw"));
    for (const PlaneEntry& entry : plane_entries)
        menu.choice(ui::Choice<Normal>{entry.normal, entry.id, entry.label}, plane_now, work_in, why_not_in_space);
}

} // namespace frame
