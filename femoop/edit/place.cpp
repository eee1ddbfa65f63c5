#include "femoop/edit/place.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "femoop/edit/load_change.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/naming.h"
#include "femoop/edit/short_number.h"
#include "femoop/geometry/member_geometry.h"

namespace femoop {

namespace {

bool mirrors(const Placement& placement) { return placement.linear().determinant() < 0.0; }

double scale_of(const Placement& placement) { return std::cbrt(std::abs(placement.linear().determinant())); }

/// [degrees], of a turn about z; for a mirror, of the image of the x axis.
double turn_of(const Placement& placement)
{
    const Eigen::Vector3d x = placement.linear().col(0);
    return std::atan2(x.y(), x.x()) * 180.0 / std::numbers::pi;
}

/// The largest number that placing calculates with.
double extent_of(const Placement& placement, const Eigen::Vector3d& place)
{
    return std::max(placement.translation().cwiseAbs().maxCoeff(),
                    (placement.linear().cwiseAbs() * place.cwiseAbs()).maxCoeff());
}

void place_node(const Model& model, Node& node, const Eigen::Vector3d& was, const Placement& placement)
{
    const std::size_t n = n_coordinates(model.analysis);
    const Eigen::Vector3d now = placement * was;
    const std::array<Quantity, 3> numbers = coordinates(now, extent_of(placement, was));
    for (std::size_t i = 0; i < n; ++i)
        if (node.at[i].value() != now[static_cast<Eigen::Index>(i)]) node.at[i] = numbers[i];
}

void place_vector(std::vector<Quantity>& vector, const Placement& placement)
{
    const Eigen::Vector3d placed = placement.linear() * vector_of(vector);
    const double extent = placed.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < vector.size(); ++i)
        vector[i] = short_number(placed[static_cast<Eigen::Index>(i)], extent);
}

/// The support's axes turn: angle 0 is +x, so a turn adds to it, a mirror takes it from the image of +x.
void place_support(Support& support, const Placement& placement)
{
    const bool has_no_direction = support.kind == SupportKind::Fixed || support.kind == SupportKind::Pin;
    const double turn = turn_of(placement);
    if (has_no_direction || (turn == 0.0 && !mirrors(placement))) return;
    double angle = mirrors(placement) ? turn - support.angle : support.angle + turn;
    if (mirrors(placement) && std::abs(std::remainder(turn, 360.0)) > 90.0) angle += 180.0; // keeps it upright
    support.angle = short_number(std::remainder(angle, 360.0), 360.0);
    if (support.kind == SupportKind::Roller && support.angle.value() != 0.0) {
        support.kind = SupportKind::Custom;
        support.fixed = {Dof::uy};
    }
}

/// Of each global axis the one that it comes to lie on; nothing where one lies between them.
std::optional<std::array<Eigen::Index, 3>> images_of_axes(const Placement& placement)
{
    std::array<Eigen::Index, 3> images{};
    const Eigen::Matrix3d shares = placement.linear().cwiseAbs() / scale_of(placement);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Eigen::Index& image = images.at(static_cast<std::size_t>(axis));
        if (shares.col(axis).maxCoeff(&image) < 1.0 - 1e-9) return std::nullopt;
    }
    return images;
}

Dof along_image(Dof dof, const std::array<Eigen::Index, 3>& images)
{
    const auto place = index(dof);
    return all_dofs.at(place - place % 3 + static_cast<std::size_t>(images.at(place % 3)));
}

/// One that holds along the global axes alone stays as it is where these come to lie between them.
void place_support_along_axes(Support& support, const Placement& placement)
{
    const auto images = images_of_axes(placement);
    if (!images) return;
    DofSet fixed;
    for (const Dof dof : all_dofs)
        if (support.fixed.contains(dof)) fixed.insert(along_image(dof, *images));
    support.fixed = fixed;
    for (Spring& spring : support.springs) spring.dof = along_image(spring.dof, *images);
}

/// Keeps a place on a member that has been stretched to a length.
void keep_on(Position& place, double stretch, double length)
{
    auto* const at = std::get_if<Quantity>(&place);
    if (!at) return;
    const double x = short_number(std::min(at->value() * stretch, length), length);
    if (x != at->value()) *at = x;
}

/// In a plane model the mirror turns the member's y' and z' over; else it keeps x' and y' and turns z', and with it
/// moments about the other two.
void mirror(MemberLoad& load, AnalysisKind analysis)
{
    const bool is_turned_over = is_plane(analysis);
    const DofSet turned = is_turned_over ? DofSet{Dof::uy, Dof::rz} : DofSet{Dof::uz, Dof::rx, Dof::ry};
    change_values(load, [&](Dof dof, Quantity& value, LoadAxes axes) {
        if (turned.contains(dof) && axes == LoadAxes::Local) value = -value.value();
    });
    if (is_turned_over) swap_faces(load);
}

/// Which nodes are placed, and which members go with them as a whole.
class Placing {
public:
    Placing(Model& model, std::span<const NodeId> nodes, const Placement& placement)
        : model_(model), placement_(placement), is_placed_(model.nodes.size(), false)
    {
        for (const NodeId node : nodes) is_placed_.at(node.index) = true;
    }

    void run()
    {
        std::vector<MemberGeometry> before;
        for (const Member& member : model_.members) before.push_back(geometry_of(model_, member));
        place_supports();
        for (std::size_t i = 0; i < model_.nodes.size(); ++i)
            if (is_placed_[i]) place_node(model_, model_.nodes[i], position_of(model_, NodeId(i)), placement_);
        for (Member& member : model_.members) {
            if (!goes_along(member)) continue;
            place_vector(member.start.offset, placement_);
            place_vector(member.end.offset, placement_);
        }
        if (is_3d(model_.analysis))
            for (std::size_t i = 0; i < before.size(); ++i) place_up(model_.members[i], before[i]);
        for (LoadCase& load_case : model_.load_cases)
            for (MemberLoad& load : load_case.members) fit(load, before[load.member.index].length);
    }

private:
    bool is_placed(NodeId node) const { return is_placed_[node.index]; }
    bool goes_along(const Member& member) const { return is_placed(member.nodes[0]) && is_placed(member.nodes[1]); }
    bool is_touched(const Member& member) const { return is_placed(member.nodes[0]) || is_placed(member.nodes[1]); }

    void place_supports()
    {
        std::vector<bool> goes_along_whole(model_.nodes.size(), true);
        for (const Member& member : model_.members)
            for (const NodeId node : member.nodes)
                if (!goes_along(member)) goes_along_whole[node.index] = false;
        const auto place = is_plane(model_.analysis) ? place_support : place_support_along_axes;
        for (std::size_t i = 0; i < model_.nodes.size(); ++i)
            if (is_placed_[i] && goes_along_whole[i] && model_.nodes[i].support)
                place(*model_.nodes[i].support, placement_);
    }

    /// Its y' goes along, where it does not do so by itself.
    void place_up(Member& member, const MemberGeometry& before) const
    {
        if (!goes_along(member)) return;
        const Eigen::Vector3d wanted = (placement_.linear() * before.axes.row(1).transpose()).normalized();
        const auto now = [&] { return Eigen::Vector3d(geometry_of(model_, member).axes.row(1).transpose()); };
        if (now().isApprox(wanted, 1e-9)) return;
        if (member.up.empty()) member.up = {wanted.x(), wanted.y(), wanted.z()};
        else place_vector(member.up, placement_);
    }

    void fit(MemberLoad& load, double old_length) const
    {
        const Member& member = model_[load.member];
        if (!is_touched(member)) return;
        const double length = line_of(model_, member).length;
        const bool is_scaled = goes_along(member) && std::abs(scale_of(placement_) - 1.0) > 1e-12;
        const double stretch = is_scaled && old_length > 0.0 ? length / old_length : 1.0;
        change_places(load, [&](Position& place) { keep_on(place, stretch, length); });
        if (goes_along(member) && mirrors(placement_)) mirror(load, model_.analysis);
    }

    Model& model_;
    Placement placement_;
    std::vector<bool> is_placed_;
};

/// Copies at the same place.
class Copying {
public:
    explicit Copying(Model& model)
        : model_(model), twin_of_node_(model.nodes.size()), twin_of_member_(model.members.size())
    {}

    Parts run(const Parts& parts)
    {
        for (const NodeId node : parts.nodes) copy(node);
        for (const MemberId member : parts.members) copy(member);
        for (LoadCase& load_case : model_.load_cases) {
            copy_loads(load_case.nodes, &NodeLoad::node, twin_of_node_);
            copy_loads(load_case.settlements, &Settlement::node, twin_of_node_);
            copy_loads(load_case.members, &MemberLoad::member, twin_of_member_);
        }
        return copies_;
    }

private:
    NodeId copy(NodeId id)
    {
        std::optional<NodeId>& twin = twin_of_node_.at(id.index);
        if (twin) return *twin;
        Node node = model_[id];
        node.id = fresh_node_id(model_);
        copies_.nodes.push_back(model_.add(std::move(node)));
        twin = copies_.nodes.back();
        return *twin;
    }

    void copy(MemberId id)
    {
        Member member = model_.members.at(id.index);
        for (NodeId& node : member.nodes) node = copy(node);
        member.id = fresh_member_id(model_, member.nodes[0], member.nodes[1]);
        copies_.members.push_back(model_.add(std::move(member)));
        twin_of_member_[id.index] = copies_.members.back();
    }

    /// A load on what was copied acts on its twin too.
    template <class Load, class Id>
    static void copy_loads(std::vector<Load>& loads, Id Load::*place, const std::vector<std::optional<Id>>& twins)
    {
        const std::size_t n = loads.size();
        for (std::size_t i = 0; i < n; ++i) {
            const std::optional<Id>& twin = twins[(loads[i].*place).index];
            if (!twin) continue;
            Load load = loads[i];
            load.*place = *twin;
            loads.push_back(std::move(load));
        }
    }

    Model& model_;
    Parts copies_;
    std::vector<std::optional<NodeId>> twin_of_node_;
    std::vector<std::optional<MemberId>> twin_of_member_;
};

} // namespace

Placement moved_by(const Eigen::Vector3d& shift) { return Placement(Eigen::Translation3d(shift)); }

Placement turned(const Eigen::Vector3d& about, double angle, const Eigen::Vector3d& axis)
{
    // Quarters are exact: what stood upright lies level.
    const double quarters = angle / (0.5 * std::numbers::pi);
    const bool is_quarter = std::abs(quarters - std::round(quarters)) < 1e-12;
    Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    if (is_quarter) turn = turn.array().round();
    return Eigen::Translation3d(about) * Eigen::Affine3d(turn) * Eigen::Translation3d(-about);
}

Placement mirrored(const Eigen::Vector3d& on_line, const Eigen::Vector3d& and_on_line)
{
    const Eigen::Vector3d along = and_on_line - on_line;
    if (along.norm() == 0.0) throw std::invalid_argument("mirrored: the two points of the line are one");
    return mirrored_at(on_line, Eigen::Vector3d(-along.y(), along.x(), 0.0).normalized());
}

Placement mirrored_at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal)
{
    Placement mirror = Placement::Identity();
    mirror.linear() = Eigen::Matrix3d::Identity() - 2.0 * normal * normal.transpose();
    return Eigen::Translation3d(place) * mirror * Eigen::Translation3d(-place);
}

Placement scaled(const Eigen::Vector3d& about, double factor)
{
    if (!(factor > 0.0)) throw std::invalid_argument("scaled: the factor is not positive");
    return Eigen::Translation3d(about) * Eigen::Scaling(factor) * Eigen::Translation3d(-about);
}

void place_nodes(Model& model, std::span<const NodeId> nodes, const Placement& placement)
{
    Placing(model, nodes, placement).run();
}

Parts copy_parts(Model& model, const Parts& parts, const Placement& placement)
{
    Parts copies = Copying(model).run(parts);
    place_nodes(model, copies.nodes, placement);
    return copies;
}

} // namespace femoop
