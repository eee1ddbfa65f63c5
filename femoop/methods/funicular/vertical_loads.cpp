#include "femoop/methods/funicular/vertical_loads.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "femoop/discretisation/case_loads.h"
#include "femoop/element/span_load.h"
#include "femoop/load/case_terms.h"

namespace femoop::funicular {

namespace {

using Eigen::Vector2d;

constexpr double rounding = 1e-9; // of the largest force, or of the span

/// A force and a moment: along global axes, per unit of horizontal length where they are distributed.
struct Action {
    Vector2d force = Vector2d::Zero();
    double moment = 0.0;
};

/// What acts at a place, or along a stretch.
struct Acting {
    std::optional<MemberId> member;
    std::optional<NodeId> node;
    double from = 0.0, to = 0.0; ///< the same of a point
    Action start, end;           ///< the same of a point

    bool is_distributed() const { return to > from; }
    double length() const { return is_distributed() ? to - from : 1.0; }
};

/// Gathers what acts on a chain, from left to right.
class ChainLoads {
public:
    ChainLoads(const Model& model, const Discretisation& structure, const Chain& chain, CaseId load_case)
        : structure_(structure), chain_(chain), loads_(loads_of(model, structure)), terms_(terms_of(model, load_case))
    {
        for (std::size_t i = 0; i < chain.links.size(); ++i) {
            add_link(chain.links[i]);
            if (i + 1 < chain.links.size()) add_node(chain.nodes[i + 1]);
        }
        for (const Acting& one : acting_)
            for (const Action& action : {one.start, one.end})
                largest_ = std::max({largest_, action.force.norm() * one.length(),
                                     std::abs(action.moment) * one.length() / chain.span()});
    }

    std::optional<Refusal> refusal() const
    {
        for (const Acting& one : acting_)
            for (const Action& action : {one.start, one.end}) {
                if (!is_zero(action.force.x() * one.length()))
                    return blame(one, RefusalKind::NotVertical, action.force.x());
                if (!is_zero(action.moment * one.length() / chain_.span()))
                    return blame(one, RefusalKind::Couple, action.moment);
            }
        if (vertical().is_empty()) return Refusal{.kind = RefusalKind::NoLoad};
        return std::nullopt;
    }

    VerticalLoads vertical() const
    {
        VerticalLoads found;
        for (const Acting& one : acting_) {
            if (one.is_distributed()) add_stretch(found.stretches, one);
            else add_force(found.forces, {one.from, -one.start.force.y()});
        }
        std::erase_if(found.forces, [&](const PointForce& force) { return is_zero(force.P) || is_at_end(force.x); });
        return found;
    }

private:
    bool is_at_end(double x) const
    {
        const double near = rounding * chain_.span();
        return x <= chain_.left().x() + near || x >= chain_.right().x() - near;
    }
    bool is_zero(double force) const { return std::abs(force) <= rounding * largest_; }

    /// As it was given: of what is distributed per unit of the member's length.
    Refusal blame(const Acting& one, RefusalKind kind, double value) const
    {
        Refusal refusal{.kind = kind, .value = value, .is_distributed = one.is_distributed()};
        if (one.node) refusal.nodes = {*one.node};
        if (one.member) refusal.members = {*one.member};
        if (one.is_distributed()) refusal.value *= share_across(*one.member);
        return refusal;
    }

    double share_across(MemberId member) const { return std::abs(structure_.geometry(member).axes(0, 0)); }

    void add_node(NodeId node)
    {
        Acting load{.member = {}, .node = node};
        load.from = load.to = structure_.positions[node.index].x();
        for (const CaseTerms::Term& term : terms_.terms)
            for (const CaseLoads::OnNode& one : loads_[term.load_case].nodes) {
                if (one.node != node) continue;
                load.start.force += term.factor * Vector2d(one.value[index(Dof::ux)], one.value[index(Dof::uy)]);
                load.start.moment += term.factor * one.value[index(Dof::rz)];
            }
        load.end = load.start;
        acting_.push_back(load);
    }

    void add_link(const Chain::Link& link)
    {
        const MemberGeometry geometry = structure_.geometry(link.member);
        std::vector<SpanLoading::Scaled> scaled;
        for (const CaseTerms::Term& term : terms_.terms)
            scaled.push_back({loads_[term.load_case].of(link.member), term.factor});
        SpanLoading loading;
        loading.assign(geometry.length, scaled, SpanLoading::no_settling);
        const std::size_t first = acting_.size();
        for (const SpanPiece& piece : loading.pieces()) {
            add_point(link, geometry, piece.begin, piece.jump);
            add_piece(link, geometry, piece);
        }
        add_point(link, geometry, geometry.length, loading.last_jump());
        if (link.is_reversed) std::reverse(acting_.begin() + static_cast<std::ptrdiff_t>(first), acting_.end());
    }

    using Local = std::array<double, n_local_axes>;

    static Action action_of(const MemberGeometry& geometry, const Local& local)
    {
        const Eigen::Vector3d force = geometry.axes.transpose() * Eigen::Vector3d(local[0], local[1], local[2]);
        return {force.head<2>(), local[index(LocalAxis::rz)]};
    }

    void add_point(const Chain::Link& link, const MemberGeometry& geometry, double along, const Local& jump)
    {
        Acting point{.member = link.member, .node = {}};
        point.from = point.to = geometry.at(along).x();
        point.start = point.end = action_of(geometry, jump);
        acting_.push_back(point);
    }

    void add_piece(const Chain::Link& link, const MemberGeometry& geometry, const SpanPiece& piece)
    {
        Acting part{.member = link.member, .node = {}};
        Local last = piece.value;
        for (std::size_t i = 0; i < last.size(); ++i) last[i] += piece.slope[i] * piece.length();
        part.from = geometry.at(piece.begin).x();
        part.to = geometry.at(piece.end).x();
        part.start = across(link, action_of(geometry, piece.value));
        part.end = across(link, action_of(geometry, last));
        if (link.is_reversed) {
            std::swap(part.from, part.to);
            std::swap(part.start, part.end);
        }
        if (part.is_distributed()) acting_.push_back(part);
    }

    /// Per unit of horizontal length.
    Action across(const Chain::Link& link, const Action& along) const
    {
        const double share = share_across(link.member);
        return {along.force / share, along.moment / share};
    }

    /// What acts at one place is one force.
    void add_force(std::vector<PointForce>& forces, const PointForce& force) const
    {
        if (!forces.empty() && std::abs(forces.back().x - force.x) <= rounding * chain_.span())
            forces.back().P += force.P;
        else forces.push_back(force);
    }

    void add_stretch(std::vector<Stretch>& stretches, const Acting& one) const
    {
        const auto without_rounding = [&](double q) { return is_zero(q * one.length()) ? 0.0 : q; };
        const double start = without_rounding(-one.start.force.y()), end = without_rounding(-one.end.force.y());
        const auto add = [&](const Stretch& part) {
            if (part.start != 0.0 || part.end != 0.0) stretches.push_back(part);
        };
        if (start * end >= 0.0) return add({one.from, one.to, start, end});
        const double turn = one.from + one.length() * start / (start - end);
        add({one.from, turn, start, 0.0});
        add({turn, one.to, 0.0, end});
    }

    const Discretisation& structure_;
    const Chain& chain_;
    std::vector<CaseLoads> loads_;
    CaseTerms terms_;
    std::vector<Acting> acting_;
    double largest_ = 0.0;
};

} // namespace

std::optional<Refusal> why_no_vertical_loads(const Model& model, const Discretisation& structure, const Chain& chain,
                                             CaseId load_case)
{
    if (load_case.index >= model.n_cases()) return Refusal{.kind = RefusalKind::NoCase};
    return ChainLoads(model, structure, chain, load_case).refusal();
}

VerticalLoads vertical_loads(const Model& model, const Discretisation& structure, const Chain& chain, CaseId load_case)
{
    return ChainLoads(model, structure, chain, load_case).vertical();
}

} // namespace femoop::funicular
