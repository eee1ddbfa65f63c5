#include "femoop/edit/split.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "femoop/edit/member_line.h"
#include "femoop/edit/moving_load_change.h"
#include "femoop/edit/naming.h"
#include "femoop/edit/short_number.h"
#include "femoop/section/tapered_section.h"

namespace femoop {

namespace {

/// Where the cut is, and how long the whole was.
struct Cut {
    double x = 0.0;
    double length = 0.0;
    double slack() const { return 1e-9 * length; }
};

/// A part of the whole member, from `begin` on.
struct Piece {
    MemberId member;
    double begin = 0.0;
    double length = 0.0;
};

Position moved(const Position& position, const Piece& piece, const Cut& cut)
{
    if (std::holds_alternative<Percent>(position))
        return Percent{short_number(100.0 * (along(position, cut.length) - piece.begin) / piece.length,
                                    100.0 * cut.length / piece.length)};
    if (piece.begin == 0.0) return position;
    return Quantity(short_number(along(position, cut.length) - piece.begin, cut.length));
}

/// Gives the loads of the whole member to its parts.
class LoadSplitter {
public:
    LoadSplitter(const Model& model, NodeId node, const Piece& first, const Piece& second, const Cut& cut)
        : dofs_(dofs(model.analysis)), node_(node), first_(first), second_(second), cut_(cut)
    {}

    void split(LoadCase& load_case)
    {
        std::vector<MemberLoad> loads;
        loads.swap(load_case.members);
        case_ = &load_case;
        for (MemberLoad& load : loads) {
            if (load.member == first_.member) std::visit([this](auto& kind) { (*this)(kind); }, load.load);
            else load_case.members.push_back(std::move(load));
        }
    }

    void operator()(const DistributedLoad& load)
    {
        const double from = load.from ? along(*load.from, cut_.length) : 0.0;
        const double to = load.to ? along(*load.to, cut_.length) : cut_.length;
        if (to <= cut_.x + cut_.slack()) return add(first_, within(load, first_, to));
        if (from >= cut_.x - cut_.slack()) return add(second_, within(load, second_, to));
        DistributedLoad before = load, after = load;
        before.to.reset();
        after.from.reset();
        if (load.from) before.from = moved(*load.from, first_, cut_);
        if (load.to) after.to = moved(*load.to, second_, cut_);
        for (std::size_t i = 0; i < load.values.size(); ++i) {
            if (!load.values[i].end) continue;
            const double start = load.values[i].start, end = *load.values[i].end;
            const double middle = short_number(start + (end - start) * (cut_.x - from) / (to - from),
                                               std::max(std::abs(start), std::abs(end)) * cut_.length / (to - from));
            before.values[i].end = middle;
            after.values[i].start = middle;
        }
        add(first_, std::move(before));
        add(second_, std::move(after));
    }

    void operator()(const PointLoad& load)
    {
        const double at = along(load.at, cut_.length);
        if (std::abs(at - cut_.x) <= cut_.slack()) return at_the_cut(load);
        const Piece& piece = at < cut_.x ? first_ : second_;
        PointLoad part = load;
        part.at = moved(load.at, piece, cut_);
        add(piece, std::move(part));
    }

    void operator()(const EndLoads& load)
    {
        if (!load.start.empty()) add(first_, EndLoads{.start = load.start, .end = {}, .axes = load.axes});
        if (!load.end.empty()) add(second_, EndLoads{.start = {}, .end = load.end, .axes = load.axes});
    }

    void operator()(const TemperatureLoad& load)
    {
        add(first_, load);
        add(second_, load);
    }

    void operator()(const Misfit& load)
    {
        add(first_, share(load, first_));
        add(second_, share(load, second_));
    }

private:
    Misfit share(const Misfit& whole, const Piece& piece) const
    {
        return {short_number(whole.elongation * piece.length / cut_.length, whole.elongation)};
    }

    template <class Load> void add(const Piece& piece, Load load)
    {
        case_->members.push_back({piece.member, std::move(load)});
    }

    /// A load that lies on this piece alone. One that reaches the cut reaches the piece's end.
    DistributedLoad within(DistributedLoad load, const Piece& piece, double to) const
    {
        if (load.from) load.from = moved(*load.from, piece, cut_);
        if (load.to && piece.begin == 0.0 && to >= cut_.x - cut_.slack()) load.to.reset();
        if (load.to) load.to = moved(*load.to, piece, cut_);
        return load;
    }

    void at_the_cut(const PointLoad& load)
    {
        const bool fits_node = std::ranges::all_of(load.components,
                                                   [&](const Component& c) { return dofs_.contains(c.dof); });
        if (load.axes == LoadAxes::Global && fits_node) case_->nodes.push_back({node_, load.components});
        else add(first_, PointLoad{.at = Percent{100.0}, .components = load.components, .axes = load.axes});
    }

    DofSet dofs_;
    NodeId node_;
    Piece first_, second_;
    Cut cut_;
    LoadCase* case_ = nullptr;
};

bool bends(const Model& model, const Member& member)
{
    if (!member.section) return false;
    const Section& section = model[*member.section];
    return section.profile || section.shape || section.Iz;
}

/// A bar cut in two: beams, hinged where the bar was.
void make_beams(const Model& model, Member& first, Member& second)
{
    first.bar = second.bar = false;
    for (const Dof dof : all_dofs) {
        if (!is_rotation(dof) || !member_dofs(model.analysis).contains(dof)) continue;
        first.start.release.insert(dof);
        if (dof != Dof::rx) second.end.release.insert(dof); // one end held keeps the new node from spinning
    }
}

/// A check or an effect goes to the piece on which its place lies.
template <class Reading> void follow(Reading& reading, const Piece& first, const Piece& second, const Cut& cut)
{
    if (reading.member != first.member || !reading.at) return;
    const double x = along(*reading.at, cut.length);
    const bool is_after = reading.side == Side::Before ? x > cut.x + cut.slack() : x >= cut.x - cut.slack();
    const Piece& piece = is_after ? second : first;
    reading.at = moved(*reading.at, piece, cut);
    reading.member = piece.member;
}

void follow(std::vector<Expected>& checks, const Piece& first, const Piece& second, const Cut& cut)
{
    std::erase_if(checks, [&](const Expected& check) {
        return check.member == first.member && check.quantity == ExpectedQuantity::Extreme;
    });
    for (Expected& check : checks) follow(check, first, second, cut);
}

} // namespace

SplitMember split_member(Model& model, MemberId id, double x)
{
    const MemberLine line = line_of(model, model[id]);
    if (!(x > 0.0 && x < line.length)) throw std::invalid_argument("split_member: the place is no inner point");
    const NodeId node = model.add(Node{.id = fresh_node_id(model), .at = coordinates(line.at(x), line.length)});
    return split_member(model, id, x, node);
}

SplitMember split_member(Model& model, MemberId id, double x, NodeId node)
{
    const Cut cut{x, line_of(model, model[id]).length};
    if (!(x > 0.0 && x < cut.length)) throw std::invalid_argument("split_member: the place is no inner point");
    const bool rename = is_named_after_nodes(model, model[id]) && model.extra.empty();
    Member second = model[id];
    Member& first = model.members[id.index];
    first.nodes[1] = second.nodes[0] = node;
    first.end = second.start = MemberEnd{};
    if (!first.depths.empty()) {
        const double scale = std::max(first.depths[0].value(), first.depths[1].value());
        first.depths[1] = second.depths[0] = short_number(depth_at(second, cut.x / cut.length), scale);
    }
    if (first.bar && !is_truss(model.analysis) && bends(model, first)) make_beams(model, first, second);
    if (rename) first.id = fresh_member_id(model, first.nodes[0], node);
    second.id = fresh_member_id(model, node, second.nodes[1]);
    const MemberId second_id = model.add(std::move(second));

    const Piece before{id, 0.0, x}, after{second_id, x, cut.length - x};
    LoadSplitter splitter(model, node, before, after, cut);
    for (LoadCase& load_case : model.load_cases) splitter.split(load_case);
    follow(model.expected, before, after, cut);
    for (InfluenceLineDefinition& line : model.moving_loads.influence_lines) follow(line.effect, before, after, cut);
    follow_split(model, id, second_id);
    return {node, id, second_id};
}

} // namespace femoop
