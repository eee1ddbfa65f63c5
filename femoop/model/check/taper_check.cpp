#include <algorithm>
#include <string>
#include <string_view>

#include "femoop/model/check/checker.h"
#include "femoop/section/shape.h"
#include "femoop/section/tapered_section.h"

namespace femoop {

namespace {

constexpr double most_different = 50.0; // beyond, the member's power series are too many

/// What a tapered member cannot be besides, as its key in a file; nothing if there is no such thing.
std::string_view obstacle_of(const Member& member)
{
    if (member.rigid) return "rigid";
    if (member.bar) return "bar";
    return member.foundation ? "foundation" : "";
}

} // namespace

void Checker::check_depths(const Member& member, const Entry& place)
{
    if (model_.analysis != AnalysisKind::Frame2d) return add(FaultKind::DepthsOutsidePlaneFrame, place, {analysis()});
    if (member.depths.size() != 2) return add(FaultKind::DepthCount, place, {std::to_string(member.depths.size())});
    for (const Quantity& depth : member.depths) require_positive(place, "depths", depth, dimension::length);
    if (const std::string_view other = obstacle_of(member); !other.empty())
        return add(FaultKind::DepthsBeside, place, {std::string(other)});
    if (!member.section || !is_readable(*member.section)) return;
    const Section& section = model_[*member.section];
    if (!can_taper(section)) return add(FaultKind::DepthsOfSection, place, {section.id});
    const bool has_depths = std::ranges::all_of(member.depths, [](double depth) { return depth > 0.0; });
    if (!has_depths || why_not(*section.shape)) return;
    const auto [smaller, larger] = std::minmax(
        member.depths[0], member.depths[1], [](const Quantity& a, const Quantity& b) { return a.value() < b.value(); });
    if (why_not(*at_depth(section, smaller).shape)) {
        const double flanges = 2.0 * (section.shape->tf ? *section.shape->tf : *section.shape->t);
        return add(FaultKind::DepthTooSmall, place,
                   {shown(smaller, dimension::length), section.id, shown(Quantity(flanges), dimension::length)});
    }
    if (larger > most_different * smaller)
        add(FaultKind::DepthsTooDifferent, place,
            {shown(member.depths[0], dimension::length), shown(member.depths[1], dimension::length),
             std::to_string(static_cast<int>(most_different))});
}

} // namespace femoop
