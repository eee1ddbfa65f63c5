#include "apps/frame/session/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "apps/frame/document/drawing.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/short_number.h"
#include "ui/text/catalogue.h"

namespace frame {

using Eigen::Vector3d;
using ui::translatable;

namespace {

std::string_view label(Transform::Kind kind)
{
    switch (kind) {
    case Transform::Kind::Move: return translatable("Move the selection");
    case Transform::Kind::Copy: return translatable("Copy the selection");
    case Transform::Kind::Rotate: return translatable("Rotate the selection");
    case Transform::Kind::Mirror: return translatable("Mirror the selection");
    case Transform::Kind::Scale: return translatable("Scale the selection");
    case Transform::Kind::Bend: break;
    }
    return translatable("Bend the members");
}

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

} // namespace

femoop::Placement Transform::placement() const
{
    const Vector3d place(at[0], at[1], at[2]);
    const Vector3d axis = WorkingPlane{.normal = normal}.normal_axis();
    switch (kind) {
    case Kind::Move:
    case Kind::Copy:
    case Kind::Bend: break;
    case Kind::Rotate: return femoop::turned(place, radians(angle), axis);
    case Kind::Mirror:
        if (is_in_space) return femoop::mirrored_at(place, axis);
        return femoop::mirrored(place, femoop::turned(place, radians(angle)) * (place + Vector3d::UnitX()));
    case Kind::Scale: return femoop::scaled(place, factor);
    }
    return femoop::moved_by(place);
}

// What comes of the members is selected, their first parts too.
Change Transform::bending() const
{
    std::vector<femoop::MemberId> members;
    for (const Part& part : parts)
        if (const auto* const member = std::get_if<femoop::MemberId>(&part)) members.push_back(*member);
    const auto make = [members, bend = bend](Document& document) {
        for (const femoop::MemberId member : members) bend_member(document.model, member, bend);
    };
    const auto select = [members](Document&, Selection& added) {
        Selection chain;
        for (const femoop::MemberId member : members) chain.add(member);
        for (const Part& part : added.parts())
            if (std::holds_alternative<femoop::MemberId>(part)) chain.add(part);
        added = chain;
    };
    return {label(kind), make, Step::Drag, select};
}

Change Transform::change(const femoop::Model& before) const
{
    if (kind == Kind::Bend) return bending();
    const auto as_placed = placement();
    if (!copies())
        return {label(kind),
                [=, parts = parts](Document& document) {
                    place(document, parts, as_placed);
                    join(document, before);
                },
                Step::Drag};
    const auto make = [=, parts = parts, times = static_cast<int>(n_copies())](Document& document) {
        copy(document, parts, as_placed, times);
    };
    const auto finish = [=, n_copies = n_copies()](Document& document, Selection& copies) {
        join(document, copies, before, {.n_copies = n_copies});
        rename(document, before); // which moves nothing in the lists
    };
    return {label(kind), make, Step::Drag, finish};
}

namespace {

// Of the first member, a fifth of its length in round numbers: an arch that is seen to be one.
double usual_rise(const femoop::Model& model, const std::vector<Part>& parts)
{
    for (const Part& part : parts)
        if (const auto* const member = std::get_if<femoop::MemberId>(&part))
            return femoop::short_number(0.2 * femoop::line_of(model, model[*member]).length, 1.0);
    return 1.0;
}

double least_rise_of(const femoop::Model& model, const std::vector<Part>& parts)
{
    double least = 0.0;
    for (const Part& part : parts)
        if (const auto* const member = std::get_if<femoop::MemberId>(&part))
            least = std::max(least, least_bend_rise(model, *member));
    return least;
}

} // namespace

Transform transform_of(Transform::Kind kind, const femoop::Model& model, const Selection& selection)
{
    Transform transform{.kind = kind};
    transform.parts.assign(selection.parts().begin(), selection.parts().end());
    transform.bend.rise = usual_rise(model, transform.parts);
    transform.least_rise = least_rise_of(model, transform.parts);
    const std::vector<femoop::NodeId> nodes = nodes_of(model, selection.parts());
    if (nodes.empty()) return transform;
    Vector3d least = femoop::position_of(model, nodes.front()), most = least;
    for (const femoop::NodeId node : nodes) {
        least = least.cwiseMin(femoop::position_of(model, node));
        most = most.cwiseMax(femoop::position_of(model, node));
    }
    const Vector3d middle = 0.5 * (least + most), size = most - least;
    const auto begin_at = [&](const Vector3d& place) { transform.at = {place.x(), place.y(), place.z()}; };
    transform.is_in_space = femoop::is_3d(model.analysis);
    transform.keeps_original = kind == Transform::Kind::Mirror;
    if (kind == Transform::Kind::Copy) transform.at[0] = size.x() > 0.0 ? size.x() : 1.0;
    if (kind == Transform::Kind::Rotate || kind == Transform::Kind::Scale) begin_at(middle);
    if (kind != Transform::Kind::Mirror) return transform;
    if (transform.is_in_space) begin_at(most);
    transform.at[0] = most.x(); // a copy at the right hand
    if (transform.is_in_space) transform.normal = WorkingPlane::Normal::X;
    return transform;
}

Selection latest(const femoop::Model& model, std::size_t n_nodes, std::size_t n_members)
{
    Selection selection;
    for (std::size_t i = n_nodes; i < model.nodes.size(); ++i) selection.add(femoop::NodeId(i));
    for (std::size_t i = n_members; i < model.members.size(); ++i) selection.add(femoop::MemberId(i));
    return selection;
}

} // namespace frame
