#include "femoop/methods/truss/reciprocal.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <tuple>

namespace femoop::truss {

namespace {

constexpr SpaceId no_space(std::numeric_limits<std::uint32_t>::max());
constexpr std::string_view letters = "ABCDEFGHJKLMNPQRSTUVWXYZ";

/// A, B ... Z, AA, AB ...
std::string letter(std::size_t i)
{
    const std::string last(1, letters[i % letters.size()]);
    return i < letters.size() ? last : letter(i / letters.size() - 1) + last;
}

std::string in_small_letters(std::string name)
{
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
}

IsOpen outside(const Truss& truss, const Faces& faces)
{
    return [&](NodeId joint, MemberId bar) { return faces.left({bar, truss[bar].joints[0] == joint}) == faces.outer; };
}

std::vector<NodeId> forces_inside(const Truss& truss, const Faces& faces)
{
    std::vector<bool> is_outside(truss.joints.size(), false);
    for (const Way& way : faces.loops[faces.outer]) is_outside[end_of(truss, way).index] = true;
    std::vector<NodeId> inside;
    for (const ExternalForce& force : truss.forces)
        if (!is_outside[force.joint.index]) inside.push_back(force.joint);
    inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
    return inside;
}

class DiagramMaker {
public:
    explicit DiagramMaker(const Truss& truss) : truss_(truss), faces_(faces_of(truss))
    {
        diagram_.arrangement = arrange(truss, outside(truss, faces_));
        diagram_.joints = joint_method(truss, diagram_.arrangement);
        diagram_.bar_spaces.assign(truss.bars.size(), {no_space, no_space});
        inner_.assign(faces_.loops.size(), no_space);
    }

    Reciprocal made() &&
    {
        walk_around();
        draw_forces();
        for (std::size_t i = 0; i < diagram_.joints.steps.size(); ++i)
            if (!diagram_.joints.steps[i].found.empty()) draw(i);
        return std::move(diagram_);
    }

private:
    /// The forces that lie between this bar and the next one clockwise.
    std::vector<std::size_t> forces_after(NodeId joint, MemberId bar) const
    {
        const std::vector<Spoke>& spokes = diagram_.arrangement[joint.index];
        const auto at = std::ranges::find(spokes, std::optional(bar), &Spoke::bar);
        std::vector<std::size_t> forces;
        for (auto spoke = std::next(at); spoke != spokes.end() && spoke->force; ++spoke)
            forces.push_back(*spoke->force);
        return forces;
    }

    /// Clockwise around the truss: each force ends a space and begins the next. The last one is the leftmost reaction.
    void walk_around()
    {
        struct Stop {
            std::vector<Way> outline; ///< from the force before to this one
            std::size_t force;
        };
        std::vector<Stop> stops;
        std::vector<Way> outline;
        for (const Way& way : faces_.loops[faces_.outer]) {
            outline.push_back(way);
            for (const std::size_t force : forces_after(end_of(truss_, way), way.bar)) {
                stops.push_back({outline, force});
                outline.clear();
            }
        }
        stops.front().outline.insert(stops.front().outline.begin(), outline.begin(), outline.end());
        const auto last = std::ranges::min_element(stops, {}, [&](const Stop& stop) {
            const ExternalForce& force = truss_.forces[stop.force];
            const Eigen::Vector2d& at = truss_.joints[force.joint.index];
            return std::tuple(force.cause == ForceCause::Load, at.x(), at.y());
        });
        std::rotate(stops.begin(), std::next(last), stops.end());
        for (std::size_t i = 0; i < stops.size(); ++i) {
            for (const Way& way : stops[i].outline) side(way) = SpaceId(i);
            diagram_.spaces.push_back({.name = letter(i), .outline = std::move(stops[i].outline)});
            diagram_.forces.push_back(stops[i].force);
        }
    }

    SpaceId& side(const Way& way) { return diagram_.bar_spaces[way.bar.index][way.is_back ? 1 : 0]; }

    void draw_forces()
    {
        DiagramStep step;
        Eigen::Vector2d point = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < diagram_.forces.size(); ++i) {
            diagram_.spaces[i].point = point;
            step.spaces.emplace_back(i);
            point += truss_.forces[diagram_.forces[i]].force;
        }
        diagram_.closing_error = point.norm();
        diagram_.steps.push_back(std::move(step));
        is_known_.assign(diagram_.spaces.size(), true);
    }

    /// Each bar that is found takes the diagram from a known point to the next, or closes it.
    void draw(std::size_t joint_step)
    {
        const std::vector<MemberId>& found = diagram_.joints.steps[joint_step].found;
        DiagramStep step{.joint_step = joint_step, .bars = found, .spaces = {}};
        for (const MemberId bar : found) name_sides(bar);
        pending_.insert(pending_.end(), found.begin(), found.end());
        const auto is_drawn = [&](MemberId bar) { return draw_bar(bar, step); };
        while (std::erase_if(pending_, is_drawn) > 0) {
        }
        diagram_.steps.push_back(std::move(step));
    }

    void name_sides(MemberId bar)
    {
        for (const bool is_back : {false, true}) {
            const Way way{bar, is_back};
            if (side(way) != no_space) continue;
            SpaceId& space = inner_[faces_.left(way)];
            if (space == no_space) {
                space = SpaceId(diagram_.spaces.size());
                const std::size_t number = diagram_.spaces.size() - diagram_.n_outside() + 1;
                diagram_.spaces.push_back(
                    {.name = std::to_string(number), .is_inside = true, .outline = faces_.loops[faces_.left(way)]});
                is_known_.push_back(false);
            }
            side(way) = space;
        }
    }

    /// False while neither side's point is known.
    bool draw_bar(MemberId bar, DiagramStep& step)
    {
        const auto [left, right] = diagram_.bar_spaces[bar.index];
        const Eigen::Vector2d force = diagram_.joints.forces[bar.index] * truss_[bar].direction;
        Eigen::Vector2d &from = diagram_.spaces[left.index].point, &to = diagram_.spaces[right.index].point;
        if (!is_known_[left.index] && !is_known_[right.index]) return false;
        if (is_known_[left.index] && is_known_[right.index])
            diagram_.closing_error = std::max(diagram_.closing_error, (to - from - force).norm());
        else if (is_known_[left.index]) to = from + force;
        else from = to - force;
        for (const SpaceId space : {left, right}) {
            if (!is_known_[space.index]) step.spaces.push_back(space);
            is_known_[space.index] = true;
        }
        return true;
    }

    const Truss& truss_;
    Faces faces_;
    Reciprocal diagram_;
    std::vector<SpaceId> inner_; ///< of each face
    std::vector<bool> is_known_; ///< of each space
    std::vector<MemberId> pending_;
};

} // namespace

std::string Space::point_name() const { return in_small_letters(name); }

std::array<SpaceId, 2> Reciprocal::force_spaces(std::size_t i) const
{
    return {SpaceId(i), SpaceId((i + 1) % n_outside())};
}

std::string Reciprocal::name(MemberId bar) const
{
    const auto [left, right] = bar_spaces[bar.index];
    const auto& [first, second] = std::minmax(left, right);
    return spaces[first.index].name + "-" + spaces[second.index].name;
}

std::string Reciprocal::side_name(MemberId bar) const { return in_small_letters(name(bar)); }

std::optional<Refusal> why_no_reciprocal(const Truss& truss)
{
    if (truss.forces.empty()) return Refusal{.kind = RefusalKind::NoForce};
    if (auto refusal = why_not_planar(truss)) return refusal;
    if (auto inside = forces_inside(truss, faces_of(truss)); !inside.empty())
        return Refusal{.kind = RefusalKind::ForceInside, .bars = {}, .joints = std::move(inside)};
    return std::nullopt;
}

Reciprocal reciprocal(const Truss& truss) { return DiagramMaker(truss).made(); }

Arrangement usual_arrangement(const Truss& truss)
{
    if (why_no_reciprocal(truss)) return arrange(truss, [](NodeId, MemberId) { return true; });
    const Faces faces = faces_of(truss);
    return arrange(truss, outside(truss, faces));
}

} // namespace femoop::truss
