#include "femoop/edit/bend.h"

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <variant>
#include <vector>

#include "femoop/edit/load_change.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/split.h"
#include "femoop/geometry/member_geometry.h"

namespace femoop {

namespace {

/// Where the curve is: along the chord and off it.
struct OnCurve {
    double x, y;
};

OnCurve on_parabola(double share, double chord, double rise)
{
    return {share * chord, 4.0 * rise * share * (1.0 - share)};
}

/// By the angle from the crown; its half opening is 2 atan(2 f / L).
OnCurve on_arc(double share, double chord, double rise)
{
    const double opening = 2.0 * std::atan(2.0 * rise / chord);
    const double radius = chord / (2.0 * std::sin(opening)), angle = (2.0 * share - 1.0) * opening;
    return {0.5 * chord + radius * std::sin(angle), rise - radius * (1.0 - std::cos(angle))};
}

/// To the left in the plane, or to the side of y' in space.
Eigen::Vector3d sideways(const Model& model, const Member& member)
{
    const MemberGeometry line = geometry_of(model, member);
    if (is_3d(model.analysis)) return line.axes.row(1).transpose();
    return {-line.axes(0, 1), line.axes(0, 0), 0.0};
}

/// Loads keep their share of the length of parts that became longer.
void stretch_places(Model& model, MemberId member, double factor)
{
    for (LoadCase& load_case : model.load_cases)
        for (MemberLoad& load : load_case.members)
            if (load.member == member)
                change_places(load, [&](Position& place) {
                    if (const auto* length = std::get_if<Quantity>(&place)) place = Quantity(factor * length->value());
                });
}

} // namespace

double least_bend_rise(const Model& model, MemberId member) { return 1e-6 * line_of(model, model[member]).length; }

BentMember bend_member(Model& model, MemberId member, const Bend& bend)
{
    if (!(std::abs(bend.rise) >= least_bend_rise(model, member)) || !std::isfinite(bend.rise))
        throw std::invalid_argument("bend_member: no rise");
    if (bend.n_parts < least_bend_parts || bend.n_parts > most_bend_parts)
        throw std::invalid_argument("bend_member: not so many parts");
    const MemberLine chord = line_of(model, model[member]);
    const Eigen::Vector3d side = sideways(model, model[member]);
    const auto share = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(bend.n_parts); };
    BentMember bent;
    bent.members.push_back(member);
    for (std::size_t i = 1; i < bend.n_parts; ++i) { // what is left is cut again
        const SplitMember parts = split_member(model, bent.members.back(), (share(i) - share(i - 1)) * chord.length);
        bent.nodes.push_back(parts.node);
        bent.members.push_back(parts.second);
    }
    std::vector<double> lengths;
    for (const MemberId part : bent.members) lengths.push_back(geometry_of(model, model[part]).length);
    const auto place = bend.curve == BendCurve::Arc ? on_arc : on_parabola;
    for (std::size_t i = 0; i < bent.nodes.size(); ++i) {
        const OnCurve at = place(share(i + 1), chord.length, bend.rise);
        model.nodes[bent.nodes[i].index].at = coordinates(chord.at(at.x) + at.y * side,
                                                          chord.length + std::abs(bend.rise));
    }
    for (std::size_t i = 0; i < bent.members.size(); ++i)
        stretch_places(model, bent.members[i], geometry_of(model, model[bent.members[i]]).length / lengths[i]);
    return bent;
}

} // namespace femoop
