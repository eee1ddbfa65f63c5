#include "femoop/methods/unit_load_case.h"

#include <utility>

#include "femoop/geometry/member_geometry.h"
#include "femoop/load/place_along.h"

namespace femoop {

namespace {

Dof axis_of(MemberComponent displacement)
{
    switch (displacement) {
    case MemberComponent::u: return Dof::ux;
    case MemberComponent::v: return Dof::uy;
    default: return Dof::uz;
    }
}

bool is_bar(const Model& model, MemberId member) { return model[member].bar || is_truss(model.analysis); }

/// A bar keeps its chord, so that its ends bear what stands between them, each the more the nearer it is.
EndLoads shared_by_ends(Dof axis, double part)
{
    return {
        .start = {{.dof = axis, .value = 1.0 - part}}, .end = {{.dof = axis, .value = part}}, .axes = LoadAxes::Local};
}

} // namespace

Model without_loads(Model model)
{
    model.load_cases.clear();
    model.combinations.clear();
    model.moving_loads = {};
    model.expected.clear();
    model.extra.clear();
    return model;
}

LoadCase unit_load_case(const Model& model, const MovingEffect& displacement, std::string id)
{
    LoadCase unit{.id = std::move(id)};
    if (displacement.node) {
        unit.nodes.push_back({.node = *displacement.node, .components = {{.dof = *displacement.dof, .value = 1.0}}});
        return unit;
    }
    const MemberId member = *displacement.member;
    const double L = geometry_of(model, model[member]).length, x = along(*displacement.at, L);
    const Dof axis = axis_of(*displacement.component);
    if (is_bar(model, member)) unit.members.push_back({member, shared_by_ends(axis, x / L)});
    else
        unit.members.push_back(
            {member,
             PointLoad{.at = Quantity(x), .components = {{.dof = axis, .value = 1.0}}, .axes = LoadAxes::Local}});
    return unit;
}

} // namespace femoop
