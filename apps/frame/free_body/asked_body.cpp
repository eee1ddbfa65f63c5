#include "apps/frame/free_body/asked_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "apps/drawing/sketch/counted_units.h"
#include "femoop/io/free_body/free_body_text.h"

namespace frame {

namespace {

using Eigen::Vector3d;
using namespace femoop::free_body;

constexpr double parallel = 1e-9; // the sine between directions that are one

// Of the structure's size, what is left free between it and a body.
constexpr double share_aside = 0.35, share_beside_cut = 0.22,
                 share_of_stubs = 0.6; ///< which a node has all around it

/// Where a line crosses members, and the nodes of these on its left.
struct Crossed {
    std::vector<Cut> cuts;
    std::vector<femoop::NodeId> left;
};

Crossed crossed(const femoop::Discretisation& structure, const AskedBody::CutLine& line)
{
    Crossed found;
    const Vector3d d = line.to - line.from, left = line.toward_eye.cross(d);
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const femoop::MemberGeometry member = structure.geometry(femoop::MemberId(i));
        const double off_start = left.dot(member.start - line.from), run = left.dot(member.end - member.start);
        if (std::abs(run) <= parallel * left.norm() * member.length) continue; // or seen end-on
        const double t = -off_start / run, s = d.dot(member.at(t * member.length) - line.from) / d.squaredNorm();
        if (t <= 0.0 || t >= 1.0 || s < 0.0 || s > 1.0) continue;
        found.cuts.push_back({femoop::MemberId(i), t * member.length});
        found.left.push_back(structure.members[i].nodes[off_start > 0.0 ? 0 : 1]);
    }
    return found;
}

Eigen::AlignedBox3d box_around(const femoop::Discretisation& structure, const Body& body)
{
    Eigen::AlignedBox3d box;
    for (const femoop::NodeId node : body.nodes) box.extend(structure.positions[node.index]);
    for (const Piece& piece : body.pieces)
        for (const double x : {piece.from, piece.to}) box.extend(structure.geometry(piece.member).at(x));
    return box;
}

/// Over the nearest side of the structure's box, of those in the plane that it lies in or is drawn upright in; over
/// another one where a sheet that is wide holds both much larger then.
/// \param toward_eye  no way that is seen end-on is taken
/// \param sheet  its width, of its height, for the structure and the body; none: it is not wide
Vector3d way_out(const Eigen::AlignedBox3d& structure, const Eigen::AlignedBox3d& body, int upright, double gap,
                 const Vector3d& toward_eye, std::optional<double> sheet)
{
    constexpr double clearly = 1.4; // larger
    constexpr double end_on = 0.85; // the cosine to the eye from which a way is seen too short
    std::vector<Vector3d> ways;
    for (const int axis : {upright, 0}) {
        if (std::abs(toward_eye[axis]) > end_on) continue;
        ways.emplace_back((structure.max()[axis] - body.min()[axis] + gap) * Vector3d::Unit(axis));
        ways.emplace_back((structure.min()[axis] - body.max()[axis] - gap) * Vector3d::Unit(axis));
    }
    const Vector3d nearest = *std::ranges::min_element(ways, {}, [](const Vector3d& way) { return way.norm(); });
    if (!sheet) return nearest;
    const auto room_for = [&](const Vector3d& way) {
        const Vector3d both = structure.merged(Eigen::AlignedBox3d(body).translate(way)).sizes();
        return std::max(both.x() / *sheet, both[upright]);
    };
    const Vector3d roomiest = *std::ranges::min_element(ways, {}, room_for);
    return room_for(nearest) > clearly * room_for(roomiest) ? roomiest : nearest;
}

/// The first of the points that lies there.
std::optional<std::size_t> at_place(const std::vector<RitterPoint>& points, const Vector3d& place)
{
    const auto found = std::ranges::find(points, place, &RitterPoint::at);
    if (found == points.end()) return std::nullopt;
    return static_cast<std::size_t>(found - points.begin());
}

/// Its equations, and the force of the bar whose Ritter point moments are taken about.
std::vector<std::string> sentences(const FreeBody& body, const Vector3d& about, std::optional<std::size_t> ritter,
                                   const femoop::Model& model, const ui::Catalogue& tr)
{
    std::vector<std::string> lines = equation_lines(body, model, about, tr);
    if (ritter)
        std::ranges::move(ritter_lines(body, model, body.ritter_points[*ritter], tr), std::back_inserter(lines));
    return lines;
}

} // namespace

void AskedBody::clear()
{
    const std::size_t next = number_ + 1;
    *this = {};
    number_ = next;
}

void AskedBody::lift(const femoop::Model& model, femoop::NodeId node)
{
    clear();
    node_ = model[node].id;
}

void AskedBody::lift(const femoop::Model& model, femoop::MemberId member, bool adds)
{
    std::vector<std::string> members = adds ? std::move(members_) : std::vector<std::string>();
    clear();
    const std::string& name = model[member].id;
    if (std::erase(members, name) == 0) members.push_back(name);
    members_ = std::move(members);
}

void AskedBody::lift(const femoop::Model& model, const std::vector<femoop::MemberId>& members)
{
    clear();
    for (const femoop::MemberId member : members) members_.push_back(model[member].id);
}

void AskedBody::cut(const femoop::Model& model, const CutLine& line)
{
    const femoop::Discretisation structure = discretise(model);
    const std::vector<Cut> cuts = crossed(structure, line).cuts;
    across_ = members_across(structure, cuts);
    if (cuts.empty() || !across_.empty()) return;
    clear();
    line_ = line;
}

void AskedBody::turn_cut()
{
    std::swap(line_->from, line_->to);
    about_.reset();
    subject_.reset();
    ++number_;
}

void AskedBody::put_moment_point(const Vector3d& about)
{
    about_ = about;
    subject_.reset();
}

void AskedBody::to_next_ritter_point()
{
    const std::size_t next = picture_->ritter ? *picture_->ritter + 1 : 0;
    const std::vector<RitterPoint>& points = picture_->lifted.ritter_points;
    put_moment_point(points[next % points.size()].at);
}

Body AskedBody::body(const femoop::Model& model) const
{
    if (const auto node = model.find_node(node_)) return body_of(*node);
    if (members_.empty() && !line_) return {};
    const femoop::Discretisation structure = discretise(model);
    if (line_) {
        const Crossed found = crossed(structure, *line_);
        const bool parts = !found.cuts.empty() && members_across(structure, found.cuts).empty();
        return parts ? body_of(structure, found.cuts, found.left) : Body();
    }
    std::vector<femoop::MemberId> members;
    for (const std::string& name : members_)
        if (const auto member = model.find_member(name)) members.push_back(*member);
    return body_of(structure, members);
}

/// Out of the structure by the shortest way, so that the labels of neither stand on the other; on the projector beside
/// it where equations below leave a wide sheet.
Vector3d AskedBody::aside(const femoop::Model& model, const Body& body, ui::ThemeName theme) const
{
    constexpr double wide = 4.0; // less what symbols and labels need
    const femoop::Discretisation structure = discretise(model);
    const double share = line_ ? share_beside_cut : node_.empty() ? share_aside : share_of_stubs;
    Eigen::AlignedBox3d box;
    for (const Vector3d& position : structure.positions) box.extend(position);
    const Vector3d toward_eye = line_ ? line_->toward_eye : Vector3d::Zero();
    return way_out(box, box_around(structure, body), femoop::is_plane(model.analysis) ? 1 : 2, share * structure.size(),
                   toward_eye,
                   theme == ui::ThemeName::Projector && femoop::is_plane(model.analysis) ? std::optional(wide)
                                                                                         : std::nullopt);
}

const drawing::FreeBodyPicture* AskedBody::picture(const femoop::Model& model, const femoop::Results& results,
                                                   std::uint64_t generation, const drawing::DrawOptions& options) const
{
    const drawing::CountedUnits units = drawing::counted_units(model, options);
    const Subject subject{generation, options.load_case, options.tr.language(), units.units, options.theme};
    if (subject_ == subject) return last();
    subject_ = subject;
    picture_.reset();
    const Body body = this->body(model);
    if (body.is_empty() || options.load_case.index >= results.n_cases()) return nullptr;
    FreeBody lifted = lift_out(model, results, options.load_case, body);
    const Vector3d about = about_.value_or(usual_moment_point(lifted, model));
    const auto ritter = at_place(lifted.ritter_points, about);
    std::vector<std::string> equations = sentences(scaled(lifted, units.length, units.force), units.length * about,
                                                   ritter, counted_in(units, model), options.tr);
    picture_ = drawing::FreeBodyPicture{.lifted = std::move(lifted),
                                        .aside = aside(model, body, options.theme),
                                        .about = about,
                                        .ritter = ritter,
                                        .equations = std::move(equations)};
    return last();
}

} // namespace frame
