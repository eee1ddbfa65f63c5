#include "femoop/edit/merge.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "femoop/edit/erase.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/moving_load_change.h"
#include "femoop/edit/naming.h"
#include "femoop/edit/reverse.h"
#include "femoop/edit/short_number.h"

namespace femoop {

namespace {

std::vector<MemberId> members_at(const Model& model, NodeId node)
{
    std::vector<MemberId> members;
    for (std::size_t i = 0; i < model.members.size(); ++i)
        if (std::ranges::count(model.members[i].nodes, node) > 0) members.emplace_back(i);
    return members;
}

/// Two members in line: `first` ends at the node where `second` begins.
struct MemberPair {
    MemberId first, second;
};

bool begins_at(const Model& model, MemberId member, NodeId node) { return model[member].nodes[0] == node; }

/// The members at the node, one turned round where both begin or both end there.
std::optional<MemberPair> make_pair_at(Model& model, NodeId node)
{
    const std::vector<MemberId> members = members_at(model, node);
    if (members.size() != 2) return std::nullopt;
    const bool begins = begins_at(model, members[0], node);
    if (begins_at(model, members[1], node) == begins) reverse_member(model, members[1]);
    return begins ? MemberPair{members[1], members[0]} : MemberPair{members[0], members[1]};
}

bool go_on_straight(const Model& model, const MemberPair& pair)
{
    const MemberLine a = line_of(model, model[pair.first]), b = line_of(model, model[pair.second]);
    return (a.direction - b.direction).norm() <= 1e-6;
}

bool is_rigid_joint(const Model& model, NodeId node, const MemberPair& pair)
{
    return !model[node].hinge && model[pair.first].end == MemberEnd{} && model[pair.second].start == MemberEnd{};
}

bool are_alike(Member a, Member b)
{
    const auto strip = [](Member& member) {
        member.id.clear();
        member.nodes = {};
        member.start = member.end = MemberEnd{};
        member.depths.clear();
    };
    strip(a);
    strip(b);
    return a == b && !a.bar; // two bars turn where they meet
}

/// Does the depth of the second go on where that of the first ends, and change as it did?
bool go_on_tapering(const Model& model, const MemberPair& pair)
{
    const std::vector<Quantity>&a = model[pair.first].depths, &b = model[pair.second].depths;
    if (a.empty() || b.empty()) return a.empty() && b.empty();
    const double first = line_of(model, model[pair.first]).length, second = line_of(model, model[pair.second]).length;
    const double middle = a[0] + (b[1] - a[0]) * first / (first + second);
    const double slack = 1e-9 * std::max({a[0].value(), a[1].value(), b[1].value()});
    return std::abs(a[1] - middle) <= slack && std::abs(b[0] - middle) <= slack;
}

bool is_held(const Model& model, NodeId node)
{
    if (model[node].support || !model[node].mass.empty()) return true;
    return std::ranges::any_of(model.load_cases, [&](const LoadCase& load_case) {
        return std::ranges::count(load_case.settlements, node, &Settlement::node) > 0;
    });
}

std::vector<TemperatureLoad> temperatures(const LoadCase& load_case, MemberId member)
{
    std::vector<TemperatureLoad> found;
    for (const MemberLoad& load : load_case.members)
        if (const auto* const temperature = std::get_if<TemperatureLoad>(&load.load);
            temperature && load.member == member)
            found.push_back(*temperature);
    return found;
}

bool have_one_temperature(const Model& model, const MemberPair& pair)
{
    return std::ranges::all_of(model.load_cases, [&](const LoadCase& load_case) {
        return temperatures(load_case, pair.first) == temperatures(load_case, pair.second);
    });
}

/// Lengths of the two, and places on them as places on the whole.
struct Lengths {
    double first, second;

    double whole() const { return first + second; }
    double shortened(double x) const { return short_number(x, whole()); }
    Position of_first(const Position& position) const { return moved(position, 0.0, first); }
    Position of_second(const Position& position) const { return moved(position, first, second); }

private:
    Position moved(const Position& position, double begin, double length) const
    {
        if (std::holds_alternative<Percent>(position))
            return Percent{short_number(100.0 * (begin + along(position, length)) / whole(), 100.0)};
        return begin == 0.0 ? position : Position(Quantity(shortened(begin + along(position, length))));
    }
};

/// Moves the loads of both members to the merged one, which has the first's id and the whole length.
class LoadMerger {
public:
    LoadMerger(const MemberPair& pair, NodeId node, const Lengths& lengths)
        : pair_(pair), node_(node), lengths_(lengths)
    {}

    void merge(LoadCase& load_case)
    {
        std::vector<MemberLoad> loads;
        loads.swap(load_case.members);
        for (MemberLoad& load : loads) {
            if (load.member == pair_.first) {
                std::visit([this](auto& kind) { lengthen(kind); }, load.load);
            } else if (load.member == pair_.second) {
                if (std::holds_alternative<TemperatureLoad>(load.load)) continue; // the first has the same
                std::visit([this](auto& kind) { shift(kind); }, load.load);
                load.member = pair_.first;
                if (join(load_case.members, load)) continue;
            }
            load_case.members.push_back(std::move(load));
        }
        take_node_loads(load_case);
    }

private:
    void lengthen(DistributedLoad& load) const
    {
        if (load.from) load.from = lengths_.of_first(*load.from);
        load.to = load.to ? lengths_.of_first(*load.to) : Position(Quantity(joint()));
    }
    void lengthen(PointLoad& load) const { load.at = lengths_.of_first(load.at); }
    void lengthen(EndLoads&) const {}
    void lengthen(TemperatureLoad&) const {}
    void lengthen(Misfit&) const {}

    void shift(DistributedLoad& load) const
    {
        load.from = load.from ? lengths_.of_second(*load.from) : Position(Quantity(joint()));
        if (load.to) load.to = lengths_.of_second(*load.to);
    }
    void shift(PointLoad& load) const { load.at = lengths_.of_second(load.at); }
    void shift(EndLoads&) const {}
    void shift(TemperatureLoad&) const {}
    void shift(Misfit&) const {}

    /// Adds a load of the second member to one of the first that it continues.
    bool join(std::vector<MemberLoad>& loads, const MemberLoad& load) const
    {
        return std::ranges::any_of(loads, [&](MemberLoad& earlier) {
            if (earlier.member != pair_.first || earlier.load.index() != load.load.index()) return false;
            return std::visit(
                [&](auto& before) { return join(before, std::get<std::decay_t<decltype(before)>>(load.load)); },
                earlier.load);
        });
    }

    static bool join(PointLoad&, const PointLoad&) { return false; }
    static bool join(TemperatureLoad&, const TemperatureLoad&) { return false; }
    static bool join(Misfit& before, const Misfit& after)
    {
        before.elongation = short_number(before.elongation + after.elongation, before.elongation);
        return true;
    }
    static bool join(EndLoads& before, const EndLoads& after)
    {
        if (before.axes != after.axes || !before.end.empty() || !after.start.empty()) return false;
        before.end = after.end;
        return true;
    }
    bool join(DistributedLoad& before, const DistributedLoad& after) const
    {
        if (before.axes != after.axes || before.projected != after.projected) return false;
        if (!before.to || !after.from || before.values.size() != after.values.size()) return false;
        const double begin = before.from ? along(*before.from, whole()) : 0.0;
        const double middle = along(*before.to, whole());
        const double end = after.to ? along(*after.to, whole()) : whole();
        if (std::abs(middle - along(*after.from, whole())) > 1e-9 * whole()) return false;
        for (std::size_t i = 0; i < before.values.size(); ++i)
            if (!continues(before.values[i], after.values[i], (middle - begin) / (end - begin))) return false;
        for (std::size_t i = 0; i < before.values.size(); ++i)
            if (before.values[i].end) before.values[i].end = after.values[i].end;
        before.to = after.to;
        return true;
    }

    /// Is the second the straight continuation of the first, which is this share of both?
    static bool continues(const DistributedLoad::Value& a, const DistributedLoad::Value& b, double share)
    {
        if (a.dof != b.dof || a.end.has_value() != b.end.has_value()) return false;
        if (!a.end) return a.start == b.start;
        const double expected = a.start + share * (*b.end - a.start);
        const double slack = 1e-9 * (std::abs(a.start) + std::abs(*b.end));
        return std::abs(*a.end - expected) <= slack && std::abs(b.start - expected) <= slack;
    }

    void take_node_loads(LoadCase& load_case) const
    {
        for (const NodeLoad& load : load_case.nodes)
            if (load.node == node_)
                load_case.members.push_back(
                    {pair_.first, PointLoad{.at = Quantity(joint()), .components = load.components, .axes = {}}});
    }

    double whole() const { return lengths_.whole(); }
    double joint() const { return lengths_.shortened(lengths_.first); }

    MemberPair pair_;
    NodeId node_;
    Lengths lengths_;
};

/// Checks follow the place that they read; what is an extreme of a part is none of the whole.
void follow(std::vector<Expected>& checks, const MemberPair& pair, const Lengths& lengths)
{
    const auto is_of_part = [&](const Expected& check) {
        return check.member == pair.first || check.member == pair.second;
    };
    std::erase_if(checks, [&](const Expected& check) { return is_of_part(check) && !check.at; });
    for (Expected& check : checks) {
        if (!is_of_part(check)) continue;
        const bool is_of_first = check.member == pair.first;
        const double x = along(*check.at, is_of_first ? lengths.first : lengths.second);
        const bool is_at_joint = x == (is_of_first ? lengths.first : 0.0);
        if (is_at_joint && !check.side) check.side = is_of_first ? Side::Before : Side::After;
        check.at = is_of_first ? lengths.of_first(*check.at) : lengths.of_second(*check.at);
        check.member = pair.first;
    }
}

void follow(MovingEffect& effect, const MemberPair& pair, const Lengths& lengths)
{
    const bool is_of_first = effect.member == pair.first;
    if ((!is_of_first && effect.member != pair.second) || !effect.at) return;
    const double x = along(*effect.at, is_of_first ? lengths.first : lengths.second);
    const bool is_at_joint = x == (is_of_first ? lengths.first : 0.0);
    if (is_at_joint && !effect.side) effect.side = is_of_first ? Side::Before : Side::After;
    effect.at = is_of_first ? lengths.of_first(*effect.at) : lengths.of_second(*effect.at);
    effect.member = pair.first;
}

bool is_loaded_inside(const Model& model, const MemberPair& pair)
{
    const auto acts_at_joint = [&](const MemberLoad& load) {
        const auto* const ends = std::get_if<EndLoads>(&load.load);
        if (!ends) return false;
        return (load.member == pair.first && !ends->end.empty()) ||
               (load.member == pair.second && !ends->start.empty());
    };
    return std::ranges::any_of(model.load_cases, [&](const LoadCase& load_case) {
        return std::ranges::any_of(load_case.members, acts_at_joint);
    });
}

std::optional<MergeObstacle> obstacle(const Model& model, NodeId node, const MemberPair& pair)
{
    if (!go_on_straight(model, pair)) return MergeObstacle::NotInLine;
    if (!are_alike(model[pair.first], model[pair.second]) || !go_on_tapering(model, pair))
        return MergeObstacle::DifferentMembers;
    if (!is_rigid_joint(model, node, pair)) return MergeObstacle::NotRigidJoint;
    if (is_held(model, node)) return MergeObstacle::Held;
    if (!have_one_temperature(model, pair)) return MergeObstacle::DifferentHeating;
    if (is_loaded_inside(model, pair)) return MergeObstacle::LoadedInsideJoint;
    return std::nullopt;
}

} // namespace

std::optional<MergeObstacle> why_not_merge_at(const Model& model, NodeId node)
{
    Model trial = model;
    const std::optional<MemberPair> pair = make_pair_at(trial, node);
    return pair ? obstacle(trial, node, *pair) : MergeObstacle::NotTwoMembers;
}

MemberId merge_members_at(Model& model, NodeId node)
{
    if (why_not_merge_at(model, node)) throw std::invalid_argument("merge_members_at: the members cannot be one");
    const MemberPair pair = *make_pair_at(model, node);
    Member& member = model.members[pair.first.index];
    const Member& tail = model[pair.second];
    const bool rename = is_named_after_nodes(model, member) && model.extra.empty();

    const Lengths lengths{line_of(model, member).length, line_of(model, tail).length};
    LoadMerger merger(pair, node, lengths);
    for (LoadCase& load_case : model.load_cases) merger.merge(load_case);
    follow(model.expected, pair, lengths);
    for (InfluenceLineDefinition& line : model.moving_loads.influence_lines) follow(line.effect, pair, lengths);
    follow_merge(model, pair.first, pair.second);
    member.nodes[1] = tail.nodes[1];
    member.end = tail.end;
    if (!member.depths.empty()) member.depths[1] = tail.depths[1];
    if (rename) member.id = fresh_member_id(model, member.nodes[0], member.nodes[1]);
    const std::string name = member.id;
    erase(model, {.nodes = {node}, .members = {pair.second}});
    return *model.find_member(name);
}

} // namespace femoop
