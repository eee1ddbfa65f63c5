#include "femoop/section/tapered_section.h"

#include <algorithm>
#include <array>

namespace femoop {

bool can_taper(const Section& section)
{
    if (!section.shape || section.profile || section.turned) return false;
    const bool has_numbers = section.A || section.Iz || section.Iy || section.J || section.Asy || section.Asz ||
                             section.h || section.yc;
    constexpr std::array kinds{SectionShapeKind::Rectangle, SectionShapeKind::Box, SectionShapeKind::I,
                               SectionShapeKind::C};
    return !has_numbers && std::ranges::find(kinds, section.shape->kind) != kinds.end();
}

Section at_depth(const Section& section, double h)
{
    Section other = section;
    other.shape->h = h;
    return other;
}

double depth_at(const Member& member, double share)
{
    return (1.0 - share) * member.depths[0] + share * member.depths[1];
}

} // namespace femoop
