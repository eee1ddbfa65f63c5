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
        for (std::size_t i = 0; i < diagram_.joints.steps.size(); ++i) {
            if (!diagram_.joints.steps[i].found.empty()) draw(i);
            else diagram_.steps.push_back({.joint_step = i, .closes = is_closed(i)});
        }
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

    /// Each bar that is found takes the diagram from a known point to the next, or closes it. One that begins nowhere
    /// waits for what others bring.
    void draw(std::size_t joint_step)
    {
        const std::vector<MemberId>& found = diagram_.joints.steps[joint_step].found;
        for (const MemberId bar : found) name_sides(bar);
        if (found.size() == 2 && meet_in_new_point(found[0], found[1])) {
            diagram_.steps.push_back(
                {.joint_step = joint_step, .bar = found[0], .from = known_side(found[0]), .is_open = true});
            add_line(found[1], joint_step, found[0]);
            check(found[0]);
        } else {
            for (const MemberId bar : found) waiting_.push_back({bar, joint_step});
        }
        const auto is_ready = [&](const Found& one) { return known_side(one.bar).has_value(); };
        for (auto next = waiting_.begin(); next != waiting_.end();) {
            next = std::ranges::find_if(waiting_, is_ready);
            if (next == waiting_.end()) break;
            const Found one = *next;
            waiting_.erase(next);
            add_line(one.bar, one.joint_step, std::nullopt);
            next = waiting_.begin();
        }
    }

    /// Of the bar's two spaces the one whose point is known, of two the left one.
    std::optional<SpaceId> known_side(MemberId bar) const
    {
        for (const SpaceId space : diagram_.bar_spaces[bar.index])
            if (is_known_[space.index]) return space;
        return std::nullopt;
    }

    std::optional<SpaceId> new_side(MemberId bar) const
    {
        for (const SpaceId space : diagram_.bar_spaces[bar.index])
            if (!is_known_[space.index]) return space;
        return std::nullopt;
    }

    bool meet_in_new_point(MemberId a, MemberId b) const
    {
        return known_side(a) && known_side(b) && new_side(a) && new_side(a) == new_side(b);
    }

    void add_line(MemberId bar, std::size_t joint_step, std::optional<MemberId> cuts)
    {
        DiagramStep step{.joint_step = joint_step, .bar = bar, .from = known_side(bar), .cuts = cuts};
        if (const auto space = new_side(bar)) {
            diagram_.spaces[space->index].point = diagram_[*step.from].point + side(bar, *step.from);
            is_known_[space->index] = true;
            step.spaces.push_back(*space);
        } else {
            check(bar);
        }
        step.closes = is_closed(joint_step);
        diagram_.steps.push_back(std::move(step));
    }

    bool is_closed(std::size_t joint_step) const
    {
        const std::optional<NodeId> joint = diagram_.joints.steps[joint_step].joint;
        return joint && std::ranges::all_of(truss_.bars_at[joint->index], [&](MemberId bar) {
                   const auto& spaces = diagram_.bar_spaces[bar.index];
                   return std::ranges::all_of(
                       spaces, [&](SpaceId space) { return space != no_space && is_known_[space.index]; });
               });
    }

    /// From the point of one of its spaces to that of the other.
    Eigen::Vector2d side(MemberId bar, SpaceId from) const
    {
        const Eigen::Vector2d force = diagram_.joints.forces[bar.index] * truss_[bar].direction;
        return from == diagram_.bar_spaces[bar.index][0] ? force : Eigen::Vector2d(-force);
    }

    /// By how much the line of a bar misses the point that it has to end in.
    void check(MemberId bar)
    {
        const auto [left, right] = diagram_.bar_spaces[bar.index];
        const Eigen::Vector2d missed = diagram_[right].point - diagram_[left].point - side(bar, left);
        diagram_.closing_error = std::max(diagram_.closing_error, missed.norm());
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

    const Truss& truss_;
    Faces faces_;
    Reciprocal diagram_;
    std::vector<SpaceId> inner_; ///< of each face
    std::vector<bool> is_known_; ///< of each space
    struct Found {
        MemberId bar;
        std::size_t joint_step;
    };
    std::vector<Found> waiting_; ///< bars neither of whose points is known yet
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

std::vector<PolygonSide> Reciprocal::polygon(const Truss& truss, const Step& step) const
{
    std::vector<PolygonSide> sides;
    const auto is_found = [&](const Spoke& spoke) {
        return spoke.bar && std::ranges::find(step.found, *spoke.bar) != step.found.end();
    };
    std::vector<Spoke> spokes = arrangement[step.joint->index];
    const auto comes_last = [&](const Spoke& spoke) { return is_found(spoke) && !is_found(spokes.front()); };
    for (std::size_t i = 0; i < spokes.size() && !comes_last(spokes.back()); ++i)
        std::rotate(spokes.begin(), std::next(spokes.begin()), spokes.end());
    for (const Spoke& spoke : spokes) {
        std::array<SpaceId, 2> spaces;
        if (spoke.bar) {
            spaces = bar_spaces[spoke.bar->index];
            if (truss[*spoke.bar].joints[0] != *step.joint) std::swap(spaces[0], spaces[1]);
        } else {
            const auto at = std::ranges::find(forces, *spoke.force);
            spaces = force_spaces(static_cast<std::size_t>(at - forces.begin()));
        }
        sides.push_back({.bar = spoke.bar, .force = spoke.force, .from = spaces[0], .to = spaces[1]});
    }
    return sides;
}

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
