#include "femoop/edit/reverse.h"

#include <algorithm>
#include <utility>

#include "femoop/edit/load_change.h"
#include "femoop/edit/member_line.h"

namespace femoop {

namespace {

/// Is this component along an axis that turns with the member? A plane member turns about z', others about y'.
bool turns(Dof dof, AnalysisKind kind)
{
    if (is_plane(kind)) return dof == Dof::ux || dof == Dof::uy;
    return dof != Dof::uy && dof != Dof::ry;
}

Position mirrored(const Position& position, double length)
{
    if (const auto* const percent = std::get_if<Percent>(&position)) return Percent{100.0 - percent->value};
    return Quantity(length - along(position, length));
}

void reverse(MemberLoad& load, AnalysisKind kind, double length)
{
    swap_ends(load);
    change_places(load, [&](Position& place) { place = mirrored(place, length); });
    change_values(load, [&](Dof dof, Quantity& value, LoadAxes axes) {
        if (axes == LoadAxes::Local && turns(dof, kind)) value = -value.value();
    });
    if (turns(Dof::uy, kind)) swap_faces(load);
}

} // namespace

void reverse_member(Model& model, MemberId id)
{
    const double length = line_of(model, model[id]).length;
    Member& member = model.members[id.index];
    std::swap(member.nodes[0], member.nodes[1]);
    std::swap(member.start, member.end);
    std::ranges::reverse(member.depths);
    for (LoadCase& load_case : model.load_cases)
        for (MemberLoad& load : load_case.members)
            if (load.member == id) reverse(load, model.analysis, length);
    std::erase_if(model.expected, [&](const Expected& check) { return check.member == id; });
    std::erase_if(model.moving_loads.influence_lines,
                  [&](const InfluenceLineDefinition& line) { return line.effect.member == id; });
}

} // namespace femoop
