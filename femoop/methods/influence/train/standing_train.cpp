#include "femoop/methods/influence/train/standing_train.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/load/place_along.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/result/magnitudes.h"

namespace femoop::influence {

namespace {

constexpr double off_path = 1e-12;  // of its length: so far beyond an end is the end
constexpr double hair = 1e-11;      // likewise: between a jump and what stands just beside it
constexpr double least_jump = 1e-9; // of the largest ordinate: less is no jump

using Forces = std::vector<StandingForce>;

/// The axles that stand on the path.
Forces axles_on_path(const MovingTrain& train, const Placing& placing, double length)
{
    Forces axles;
    if (!placing.position) return axles;
    const double near = off_path * length;
    double s = *placing.position;
    for (std::size_t i = 0; i < train.axles.size(); ++i) {
        if (i > 0) s += placing.reversed ? placing.spacings[i - 1] : -placing.spacings[i - 1];
        if (s >= -near && s <= length + near) axles.push_back({std::clamp(s, 0.0, length), train.axles[i]});
    }
    return axles;
}

Forces concentrated_on_path(const MovingTrain& train, const Placing& placing)
{
    Forces forces;
    for (std::size_t i = 0; i < placing.concentrated.size(); ++i)
        if (const auto s = placing.concentrated[i]) forces.push_back({*s, train.concentrated[i]});
    return forces;
}

double with_ordinates(Forces& forces, const PiecewiseLine& line, Side side)
{
    const double size = line.largest();
    double sum = 0.0;
    for (StandingForce& force : forces) {
        const double before = line.value(force.s, Side::Before), after = line.value(force.s, Side::After);
        force.ordinate = without_rounding(side == Side::Before ? before : after, size);
        force.beside.reset();
        if (std::abs(after - before) > least_jump * size) force.beside = side;
        sum += force.force * force.ordinate;
    }
    return sum;
}

/// At a jump of the line all stand just before their places, or all just after: whichever is worse.
void take_worse_side(Forces& forces, const PiecewiseLine& line, ExtremeKind kind)
{
    const double before = with_ordinates(forces, line, Side::Before), after = with_ordinates(forces, line, Side::After);
    if (kind == ExtremeKind::Max ? before > after : before < after) with_ordinates(forces, line, Side::Before);
}

/// Where the path is at the effect's own section.
std::vector<double> own_places(const PathLayout& path, const MovingEffect& effect)
{
    if (!effect.member || !effect.at) return {};
    const auto on = std::ranges::find(path.members, *effect.member, &PathMember::member);
    if (on == path.members.end()) return {};
    return path.places_of(on->member, femoop::along(*effect.at, on->length));
}

/// At the ends of the path there is but one side of a section.
Forces beside_ends(Forces forces, const PathLayout& path, const MovingEffect& effect)
{
    const double length = path.length(), near = off_path * length;
    for (const double own : own_places(path, effect))
        for (StandingForce& force : forces) {
            if (own <= near && force.s <= near) force.beside = Side::After;
            if (own >= length - near && force.s >= length - near) force.beside = Side::Before;
        }
    return forces;
}

double place_of(const StandingForce& force, double length)
{
    if (!force.beside) return force.s;
    return force.s + (*force.beside == Side::Before ? -hair : hair) * length;
}

void append(LoadCase& load_case, const PathLayout& path, const NodeVector& load, const Forces& forces)
{
    for (const StandingForce& force : forces) {
        const PathPlace place = path.place(place_of(force, path.length()));
        load_case.members.push_back(
            {place.member, PointLoad{.at = Quantity(place.x), .components = components_of(load, force.force)}});
    }
}

void append(LoadCase& load_case, const PathMember& on, const NodeVector& load, const Stretch& stretch, double uniform)
{
    const double from = std::max(stretch.from, on.begin), to = std::min(stretch.to, on.end());
    if (!(to > from)) return;
    DistributedLoad distributed;
    for (const Component& component : components_of(load, uniform))
        distributed.values.push_back({.dof = component.dof, .start = component.value, .end = {}});
    if (from > on.begin || to < on.end()) {
        distributed.from = Quantity(on.x_of(on.is_reversed ? to : from));
        distributed.to = Quantity(on.x_of(on.is_reversed ? from : to));
    }
    load_case.members.push_back({on.member, std::move(distributed)});
}

} // namespace

std::vector<StandingForce> standing_forces(const MovingTrain& train, const Placing& placing, const PiecewiseLine& line,
                                           ExtremeKind kind)
{
    Forces forces = axles_on_path(train, placing, line.length());
    take_worse_side(forces, line, kind);
    for (const StandingForce& force : concentrated_on_path(train, placing)) {
        Forces alone{force};
        take_worse_side(alone, line, kind);
        forces.push_back(alone.front());
    }
    return forces;
}

std::vector<double> covered_areas(const Placing& placing, const PiecewiseLine& line)
{
    const double size = line.largest() * line.length();
    std::vector<double> areas;
    for (const Stretch& stretch : placing.uniform) {
        double& area = areas.emplace_back(0.0);
        for (const LinePiece& piece : line.pieces) {
            const double from = std::max(stretch.from, piece.from), to = std::min(stretch.to, piece.to);
            if (to > from) area += piece.integral(from, to);
        }
        area = without_rounding(area, size);
    }
    return areas;
}

LoadCase standing_train(std::string id, const PathLayout& path, const NodeVector& load, const MovingTrain& train,
                        const Placing& placing, const InfluenceLine& line, ExtremeKind kind)
{
    LoadCase load_case{.id = std::move(id)};
    append(load_case, path, load,
           beside_ends(standing_forces(train, placing, line.ordinates, kind), path, line.effect));
    for (const PathMember& on : path.members)
        for (const Stretch& stretch : placing.uniform) append(load_case, on, load, stretch, train.uniform);
    return load_case;
}

} // namespace femoop::influence
