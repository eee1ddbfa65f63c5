#include "femoop/methods/free_body/free_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "femoop/discretisation/case_loads.h"
#include "femoop/load/case_terms.h"
#include "femoop/methods/free_body/ritter.h"
#include "femoop/rule/integration_rule.h"

namespace femoop::free_body {

namespace {

constexpr double rounding = 1e-9; // of a member's length: places that are nearer to one another are one

using Eigen::Vector3d;

Vector3d forces_of(const NodeVector& v) { return {v[0], v[1], v[2]}; }
Vector3d moments_of(const NodeVector& v) { return {v[3], v[4], v[5]}; }

/// A distributed load where a piece has it: a resultant, and a couple where its values are of both signs.
struct Stretch {
    double from, to, start, end;

    bool has_one_sign() const { return start * end >= 0.0 && start + end != 0.0; }
    double total() const { return 0.5 * (start + end) * (to - from); }
    double place() const
    {
        if (!has_one_sign()) return 0.5 * (from + to);
        return from + (to - from) * (start + 2.0 * end) / (3.0 * (start + end));
    }
    double couple() const { return has_one_sign() ? 0.0 : (to - from) * (to - from) * (end - start) / 12.0; }
};

Stretch within(const SpanLoad& load, double from, double to)
{
    const auto value = [&](double x) {
        return load.to == load.from ? load.start
                                    : load.start + (load.end - load.start) * (x - load.from) / (load.to - load.from);
    };
    const double a = std::max(from, load.from), b = std::min(to, load.to);
    return {a, b, value(a), value(b)};
}

/// Gathers what acts on a body.
class Gatherer {
public:
    Gatherer(const Model& model, const Results& results, CaseId load_case)
        : structure_(discretise(model)),
          loads_(loads_of(model, structure_)),
          terms_(terms_of(model, load_case)),
          result_(results[load_case])
    {}

    FreeBody of(const Body& body)
    {
        free_.body = body;
        for (const NodeId node : body.nodes) add_node(node);
        for (const Piece& piece : body.pieces) add_piece(piece);
        for (std::size_t i = 0; i < structure_.members.size(); ++i) add_ends_at_nodes(MemberId(i));
        const Magnitudes most = result_.magnitudes();
        std::erase_if(free_.forces, [&](const Force& force) {
            return femoop::without_rounding(force.force.norm(), most.force) == 0.0 &&
                   femoop::without_rounding(force.moment.norm(), most.moment) == 0.0;
        });
        for (Force& force : free_.forces) silence_rounding(force, most);
        free_.ritter_points = ritter_points(structure_, free_.body, free_.forces);
        return std::move(free_);
    }

private:
    /// A hinge has no moment that an equation could tell.
    static void silence_rounding(Force& force, const Magnitudes& most)
    {
        for (double& one : force.force) one = femoop::without_rounding(one, most.force);
        for (double& one : force.moment) one = femoop::without_rounding(one, most.moment);
        SectionForces& s = force.section;
        for (double* const one : {&s.N, &s.Vy, &s.Vz}) *one = femoop::without_rounding(*one, most.force);
        for (double* const one : {&s.T, &s.My, &s.Mz}) *one = femoop::without_rounding(*one, most.moment);
    }

    bool has(NodeId node) const { return std::ranges::find(free_.body.nodes, node) != free_.body.nodes.end(); }
    NodeId node_at(MemberId member, std::size_t end) const { return structure_.members[member.index].nodes[end]; }
    bool ends_at(const Piece& piece, std::size_t end) const
    {
        if (end == 0) return !piece.begins_at_cut && piece.from <= 0.0;
        return !piece.ends_at_cut && piece.to >= structure_.geometry(piece.member).length;
    }
    /// Is a piece joined to that end of a member, whose node may be in the body or not?
    bool has_piece_at(MemberId member, std::size_t end) const
    {
        return std::ranges::any_of(free_.body.pieces,
                                   [&](const Piece& piece) { return piece.member == member && ends_at(piece, end); });
    }

    void add_node(NodeId node)
    {
        const Vector3d& at = structure_.positions[node.index];
        Force load{.kind = ForceKind::NodeLoad, .node = node, .member = {}, .at = at};
        for (const CaseTerms::Term& term : terms_.terms)
            for (const CaseLoads::OnNode& one : loads_[term.load_case].nodes)
                if (one.node == node) {
                    load.force += term.factor * forces_of(one.value);
                    load.moment += term.factor * moments_of(one.value);
                }
        add(load);
        if (!result_.is_supported(node)) return;
        const NodeVector reaction = result_.reaction(node);
        add({.kind = ForceKind::Reaction,
             .node = node,
             .member = {},
             .at = at,
             .force = forces_of(reaction),
             .moment = moments_of(reaction)});
    }

    /// Members that the body has not, at nodes that it has, are cut off at their ends.
    void add_ends_at_nodes(MemberId member)
    {
        const double length = structure_.geometry(member).length;
        if (has(node_at(member, 0)) && !has_piece_at(member, 0)) add_stub(member, 0.0);
        if (has(node_at(member, 1)) && !has_piece_at(member, 1)) add_stub(member, length);
    }

    void add_stub(MemberId member, double x)
    {
        add_point_loads(member,
                        [&](double at) { return std::abs(at - x) <= rounding * structure_.geometry(member).length; });
        add_section(member, x, x == 0.0);
    }

    /// With cuts that all but meet a load point put on it, so that they are on one side of it for sure.
    Piece settled(Piece piece) const
    {
        const double near = rounding * structure_.geometry(piece.member).length;
        for (const double place : result_.curve(piece.member).breaks())
            for (double* const end : {&piece.from, &piece.to})
                if (std::abs(*end - place) <= near) *end = place;
        return piece;
    }

    void add_piece(const Piece& asked)
    {
        const Piece piece = settled(asked);
        const bool begins_at_node = ends_at(piece, 0) && has(node_at(piece.member, 0));
        const bool ends_at_node = ends_at(piece, 1) && has(node_at(piece.member, 1));
        const double length = structure_.geometry(piece.member).length, near = rounding * length;
        add_point_loads(piece.member, [&](double at) {
            if (at <= near) return begins_at_node;
            if (at >= length - near) return ends_at_node;
            return piece.from + near < at && at <= piece.to + near;
        });
        add_distributed_loads(piece);
        add_foundation(piece);
        if (!begins_at_node) add_section(piece.member, piece.from, false);
        if (!ends_at_node) add_section(piece.member, piece.to, true);
    }

    template <class Use> void for_each_load(MemberId member, Use&& use) const
    {
        for (const CaseTerms::Term& term : terms_.terms)
            for (const SpanLoad& load : loads_[term.load_case].of(member)) use(load, term.factor);
    }

    /// What acts alike at one place is one force with its components.
    void add(const Force& force)
    {
        const double near = force.member ? rounding * structure_.geometry(*force.member).length : 0.0;
        const auto same = std::ranges::find_if(free_.forces, [&](const Force& other) {
            return other.kind == force.kind && other.member == force.member && std::abs(other.x - force.x) <= near &&
                   force.kind != ForceKind::SectionForces;
        });
        if (force.node || same == free_.forces.end()) {
            free_.forces.push_back(force);
            return;
        }
        same->force += force.force;
        same->moment += force.moment;
    }

    /// A force or a moment along an axis of a member, with a couple of such forces.
    void add_on_member(ForceKind kind, const Cut& place, LocalAxis axis, double value, double couple = 0.0)
    {
        const MemberGeometry geometry = structure_.geometry(place.member);
        const Vector3d direction = geometry.axes.row(static_cast<Eigen::Index>(index(axis)) % 3);
        Force force{.kind = kind, .node = {}, .member = place.member, .x = place.x, .at = geometry.at(place.x)};
        if (is_rotation(axis)) {
            force.moment = value * direction;
        } else {
            force.force = value * direction;
            force.moment = couple * geometry.axes.row(0).transpose().cross(direction);
        }
        add(force);
    }

    template <class Belongs> void add_point_loads(MemberId member, Belongs&& belongs)
    {
        for_each_load(member, [&](const SpanLoad& load, double factor) {
            if (load.kind == SpanLoad::Kind::Point && belongs(load.from))
                add_on_member(ForceKind::MemberLoad, {member, load.from}, load.axis, factor * load.start);
        });
    }

    void add_distributed_loads(const Piece& piece)
    {
        for_each_load(piece.member, [&](const SpanLoad& load, double factor) {
            if (load.kind != SpanLoad::Kind::Distributed) return;
            const Stretch stretch = within(load, piece.from, piece.to);
            if (stretch.to <= stretch.from) return;
            add_on_member(ForceKind::MemberLoad, {piece.member, stretch.place()}, load.axis, factor * stretch.total(),
                          factor * stretch.couple());
        });
    }

    /// Its pressure is k v, against the deflection.
    void add_foundation(const Piece& piece)
    {
        const double k = structure_.properties_of(piece.member).xy.foundation;
        if (k <= 0.0 || piece.to <= piece.from) return;
        const Curve curve = result_.curve(piece.member);
        double total = 0.0, first_moment = 0.0;
        for (const Curve::Piece& part : curve.pieces()) {
            const double from = std::max(piece.from, part.load.begin), to = std::min(piece.to, part.load.end);
            if (to <= from) continue;
            integrate(from, to, [&](double x, double weight) {
                const double pressure = -k * curve.displacement(x).v;
                total += weight * pressure;
                first_moment += weight * pressure * x;
            });
        }
        const double x = total == 0.0 ? 0.5 * (piece.from + piece.to)
                                      : std::clamp(first_moment / total, piece.from, piece.to);
        add_on_member(ForceKind::Foundation, {piece.member, x}, LocalAxis::y, total, first_moment - total * x);
    }

    template <class Use> static void integrate(double from, double to, Use&& use)
    {
        constexpr int n_parts = 16;
        static const IntegrationRule rule = gauss_line(8);
        const double half = 0.5 * (to - from) / n_parts;
        for (int i = 0; i < n_parts; ++i)
            for (const IntegrationPoint& point : rule.points)
                use(from + half * (2.0 * i + 1.0 + point.at.xi), half * point.weight);
    }

    /// Of what the other part does to the face +x' of the body, or to its face -x'.
    void add_section(MemberId member, double x, bool is_on_plus_face)
    {
        const MemberGeometry geometry = structure_.geometry(member);
        const SectionForces s = result_.curve(member).forces(x, x < geometry.length ? Side::After : Side::Before);
        const double sign = is_on_plus_face ? 1.0 : -1.0;
        add({.kind = ForceKind::SectionForces,
             .node = {},
             .member = member,
             .x = x,
             .at = geometry.at(x),
             .force = sign * geometry.axes.transpose() * Vector3d(s.N, -s.Vy, -s.Vz),
             .moment = sign * geometry.axes.transpose() * Vector3d(s.T, -s.My, s.Mz),
             .section = s,
             .is_on_plus_face = is_on_plus_face,
             .axes = geometry.axes});
    }

    Discretisation structure_;
    std::vector<CaseLoads> loads_;
    CaseTerms terms_;
    CaseResult result_;
    FreeBody free_;
};

std::vector<Dof> axes(AnalysisKind kind)
{
    if (is_plane(kind)) return {Dof::ux, Dof::uy, Dof::rz};
    if (kind == AnalysisKind::Grillage) return {Dof::uz, Dof::rx, Dof::ry};
    return {all_dofs.begin(), all_dofs.end()};
}

} // namespace

Vector3d Force::moment_about(const Vector3d& point) const { return moment + (at - point).cross(force); }

std::vector<ForceComponent> components(const Force& force)
{
    std::vector<ForceComponent> list;
    if (force.kind != ForceKind::SectionForces) {
        for (Eigen::Index i = 0; i < 3; ++i) list.push_back({{}, Vector3d::Unit(i), force.force[i], false});
        for (Eigen::Index i = 0; i < 3; ++i) list.push_back({{}, Vector3d::Unit(i), force.moment[i], true});
        return list;
    }
    using enum MemberComponent;
    const double sign = force.is_on_plus_face ? 1.0 : -1.0;
    const Vector3d x = sign * force.axes.row(0), y = sign * force.axes.row(1), z = sign * force.axes.row(2);
    const SectionForces& s = force.section;
    return {{N, x, s.N, false}, {Vy, -y, s.Vy, false}, {Vz, -z, s.Vz, false},
            {T, x, s.T, true},  {My, -y, s.My, true},  {Mz, z, s.Mz, true}};
}

FreeBody lift_out(const Model& model, const Results& results, CaseId load_case, const Body& body)
{
    return Gatherer(model, results, load_case).of(body);
}

FreeBody scaled(FreeBody body, double length, double force)
{
    const double moment = force * length;
    for (Piece& piece : body.body.pieces) {
        piece.from *= length;
        piece.to *= length;
    }
    for (Force& one : body.forces) {
        one.x *= length;
        one.at *= length;
        one.force *= force;
        one.moment *= moment;
        for (double* const number : {&one.section.N, &one.section.Vy, &one.section.Vz}) *number *= force;
        for (double* const number : {&one.section.T, &one.section.My, &one.section.Mz}) *number *= moment;
    }
    for (RitterPoint& point : body.ritter_points) {
        point.at *= length;
        point.arm *= length;
        for (Vector3d& other : point.others) other *= length;
    }
    return body;
}

Vector3d usual_moment_point(const FreeBody& body, const Model& model)
{
    if (!body.ritter_points.empty()) return body.ritter_points.front().at;
    const auto section = std::ranges::find(body.forces, ForceKind::SectionForces, &Force::kind);
    if (section != body.forces.end()) return section->at;
    return body.body.nodes.empty() ? Vector3d(Vector3d::Zero()) : position_of(model, body.body.nodes.front());
}

namespace {

void add_moments(Equation& equation, std::size_t i, const Force& force, const Vector3d& about)
{
    const auto axis = static_cast<Eigen::Index>(index(equation.dof)) - 3;
    std::size_t dof = 0;
    for (const ForceComponent& one : components(force)) {
        const Vector3d turn = one.is_moment ? one.direction : (force.at - about).cross(one.direction);
        const double moment = one.value * turn[axis];
        const auto arm = one.is_moment ? std::nullopt : std::optional(turn[axis]);
        equation.moments.push_back({i, one.of, all_dofs[dof++], one.value, arm, moment});
    }
}

} // namespace

std::vector<Equation> equations(const FreeBody& body, AnalysisKind kind, const Vector3d& about)
{
    std::vector<Equation> list;
    for (const Dof dof : axes(kind)) {
        const auto i = static_cast<Eigen::Index>(index(dof));
        Equation equation{.dof = dof};
        for (const Force& force : body.forces) {
            const double term = is_rotation(dof) ? force.moment_about(about)[i - 3] : force.force[i];
            equation.terms.push_back(term);
            equation.sum += term;
            const double arm = (force.at - about).norm();
            const double whole = is_rotation(dof) ? force.moment.norm() + arm * force.force.norm() : force.force.norm();
            equation.size = std::max(equation.size, whole);
            if (is_rotation(dof)) add_moments(equation, equation.terms.size() - 1, force, about);
        }
        std::erase_if(equation.moments,
                      [&](const MomentTerm& one) { return std::abs(one.moment) <= rounding * equation.size; });
        list.push_back(std::move(equation));
    }
    return list;
}

} // namespace femoop::free_body
