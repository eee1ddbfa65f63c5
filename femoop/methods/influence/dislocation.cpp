#include "femoop/methods/influence/dislocation.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "femoop/element/analysis_model.h"
#include "femoop/element/member_element.h"
#include "femoop/methods/influence/polynomial_terms.h"

namespace femoop::influence {

namespace {

double held(double x, double L)
{
    if (x <= end_of_member * L) return 0.0;
    return x >= L - end_of_member * L ? L : x;
}

SpanLoading loading_of(const Beam& beam, double length, std::span<const SpanLoad> loads = {})
{
    SpanLoading loading;
    const SpanLoading::Scaled term{loads};
    beam.cut(loading, length, {&term, 1});
    return loading;
}

void add(LocalDisplacement& d, const NodeVector& slip)
{
    d.u += slip[0];
    d.v += slip[1];
    d.w += slip[2];
    d.rx += slip[3];
    d.ry += slip[4];
    d.rz += slip[5];
}

/// Of the nodes on a member when its second node moves, to 32 digits.
template <AnalysisKind kind> PreciseVector forces_of(const MemberElement<kind>& element, const NodeVector& second_node)
{
    constexpr int m = MemberElement<kind>::m, n = MemberElement<kind>::n;
    PreciseMatrix T = PreciseMatrix::Zero(2 * m, 2 * n);
    for (int end = 0; end < 2; ++end)
        T.block(end * m, end * n, m,
                n) = element.transformation(static_cast<std::size_t>(end)).template cast<DoubleDouble>();
    PreciseVector u = PreciseVector::Zero(2 * n);
    for (int i = 0; i < n; ++i) u[n + i] = second_node[index(AnalysisModel<kind>::global[static_cast<std::size_t>(i)])];
    const StrainForm form = element.strains();
    const PreciseMatrix strains = form.B.template cast<DoubleDouble>() * T;
    const PreciseVector stresses = form.S.template cast<DoubleDouble>() * PreciseVector(strains * u);
    return strains.transpose() * stresses;
}

bool bends(AnalysisKind kind, BendingPlane plane)
{
    if (is_truss(kind)) return false;
    return plane == BendingPlane::xy || kind == AnalysisKind::Frame3d;
}

} // namespace

Dislocation::Dislocation(const Discretisation& structure, MemberId member, MemberComponent force, double x)
    : kind_(structure.kind),
      force_(force),
      L_(structure.geometry(member).length),
      is_bar_(is_bar(structure, member)),
      axial_(structure.properties_of(member).axial),
      torsion_(structure.properties_of(member).torsion),
      xy_(beam_of(structure, member, BendingPlane::xy)),
      xz_(beam_of(structure, member, BendingPlane::xz))
{
    x_ = held(x, L_);
    follow_joints(structure, member);
}

Dislocation::Step Dislocation::step(BendingPlane plane) const
{
    const bool is_xy = plane == BendingPlane::xy;
    if (force_ == (is_xy ? MemberComponent::Vy : MemberComponent::Vz)) return {.v = -1.0};
    if (force_ == (is_xy ? MemberComponent::Mz : MemberComponent::My)) return {.phi = 1.0};
    return {};
}

/// Its ends where the part beyond the section is moved and nothing strains.
Dislocation::PlaneEnds Dislocation::rigid_ends(BendingPlane plane) const
{
    const Step moved = step(plane);
    return {0.0, 0.0, moved.v + moved.phi * (L_ - x_), moved.phi};
}

/// What a foundation does to that part where nothing strains.
std::vector<SpanLoad> Dislocation::held_back(BendingPlane plane) const
{
    if (is_at_end()) return {};
    const double k = plane == BendingPlane::xy ? xy_.foundation : xz_.foundation;
    return {{.kind = SpanLoad::Kind::Distributed,
             .axis = force_axis(plane),
             .from = x_,
             .to = L_,
             .start = -k * step(plane).v,
             .end = -k * rigid_ends(plane)[2]}};
}

bool Dislocation::is_simple(BendingPlane plane) const { return is_bar_ || !bends(kind_, plane); }

Eigen::Vector4d Dislocation::end_forces(BendingPlane plane) const
{
    const Step moved = step(plane);
    if (is_simple(plane) || (moved.v == 0.0 && moved.phi == 0.0)) return PlaneEnds::Zero();
    const Beam& beam = plane == BendingPlane::xy ? xy_ : xz_;
    if (beam.foundation <= 0.0) return beam.stiffness(L_) * rigid_ends(plane);
    const FoundationBeam founded(beam, loading_of(beam, L_, held_back(plane)), plane, 0.0);
    return founded.stiffness() * rigid_ends(plane) - founded.fixed_end_forces();
}

/// That hold its ends still inside their joints, member axes.
std::array<NodeVector, 2> Dislocation::fixed_end_forces() const
{
    const PlaneEnds xy = end_forces(BendingPlane::xy), xz = end_forces(BendingPlane::xz);
    const double pull = gap() / axial_.flexibility(L_), torque = is_bar_ ? 0.0 : twist() * torsion_.EA / L_;
    return {NodeVector{pull, -xy[0], -xz[0], torque, xz[1], -xy[1]},
            NodeVector{-pull, -xy[2], -xz[2], -torque, xz[3], -xy[3]}};
}

/// As the part beyond the section, which its end goes with.
NodeVector Dislocation::second_node_moved(const MemberGeometry& geometry, const Eigen::Vector3d& arm) const
{
    const Step xy = is_simple(BendingPlane::xy) ? Step() : step(BendingPlane::xy);
    const Step xz = is_simple(BendingPlane::xz) ? Step() : step(BendingPlane::xz);
    const Eigen::Vector3d shift(gap(), xy.v + xy.phi * (L_ - x_), xz.v + xz.phi * (L_ - x_));
    const Eigen::Vector3d turn = geometry.axes.transpose() * Eigen::Vector3d(is_bar_ ? 0.0 : twist(), -xz.phi, xy.phi);
    const Eigen::Vector3d moved = geometry.axes.transpose() * shift - turn.cross(arm);
    return {moved[0], moved[1], moved[2], turn[0], turn[1], turn[2]};
}

void Dislocation::follow_joints(const Discretisation& structure, MemberId member)
{
    const std::array<NodeVector, 2> held = fixed_end_forces();
    const MemberEndConditions* conditions = structure.end_conditions_of(member);
    const MemberGeometry geometry = structure.geometry(member);
    with_model(kind_, [&](auto k) {
        using Element = MemberElement<decltype(k)::value>;
        using Model = AnalysisModel<decltype(k)::value>;
        const Element element(structure.properties_of(member), geometry, conditions,
                              conditions == nullptr ? all_actions : elastic_actions(*conditions));
        typename Element::LocalVector forces, slips = Element::LocalVector::Zero();
        for (int i = 0; i < 2 * Element::m; ++i)
            forces[i] = held[static_cast<std::size_t>(i / Element::m)]
                            [index(Model::local[static_cast<std::size_t>(i % Element::m)])];
        if (conditions != nullptr && conditions->has_flexible_joint) {
            slips = element.end_displacements(Element::LocalVector::Zero(), forces);
            forces = element.end_forces(Element::LocalVector::Zero(), forces);
        }
        const Eigen::Vector3d arm = conditions == nullptr ? Eigen::Vector3d::Zero() : conditions->offsets[1];
        const PreciseVector moved = xy_.foundation > 0.0 ? PreciseVector()
                                                         : forces_of(element, second_node_moved(geometry, arm));
        for (std::size_t end = 0; end < 2; ++end) {
            const auto first = static_cast<Eigen::Index>(end) * Element::m;
            const Eigen::VectorXd at_node = -(element.transformation(end).transpose() *
                                              forces.template segment<Element::m>(first));
            for (std::size_t i = 0; i < Model::global.size(); ++i) {
                const auto row = static_cast<Eigen::Index>(i),
                           of_both = static_cast<Eigen::Index>(end) * Element::n + row;
                const DoubleDouble force = moved.size() == 0 ? DoubleDouble(at_node[row]) : moved[of_both];
                node_loads_[end].high[index(Model::global[i])] = force.hi;
                node_loads_[end].low[index(Model::global[i])] = force.lo;
            }
            for (std::size_t i = 0; i < Model::local.size(); ++i)
                slips_[end][index(Model::local[i])] = slips[first + static_cast<Eigen::Index>(i)];
        }
    });
}

// A bar's chord; where its own bending is asked for, its two parts swing about its ends, whatever these do.
std::vector<Dislocation::PlaneMotion> Dislocation::simple_beam(BendingPlane plane, const PlaneEnds& ends) const
{
    const Step moved = step(plane);
    if (moved.v == 0.0 && moved.phi == 0.0) {
        const double turn = (ends[2] - ends[0]) / L_;
        return {{0.0, L_, {ends[0], turn}, {turn}}};
    }
    const double turn = -(moved.v + moved.phi * (L_ - x_)) / L_; // brings the second end back to the chord
    std::vector<PlaneMotion> parts;
    if (!is_at_start()) parts.push_back({0.0, x_, {0.0, turn}, {turn}});
    if (!is_at_end()) {
        const double beyond = turn + moved.phi;
        parts.push_back({x_, L_, {turn * x_ + moved.v, beyond}, {beyond}});
    }
    return parts;
}

std::vector<Dislocation::PlaneMotion> Dislocation::from_state(const Beam& beam, const Beam::State& begin,
                                                              BendingPlane plane) const
{
    const Step moved = step(plane);
    std::vector<PlaneMotion> parts;
    Beam::State state = begin;
    const auto pass = [&](double from, double to) {
        const SpanLoading bare = loading_of(beam, to - from);
        for (const SpanPiece& relative : bare.pieces()) {
            const SpanPiece piece{.begin = from + relative.begin, .end = from + relative.end};
            const Beam::Series series = beam.series(state, piece, plane, 0.0);
            parts.push_back({piece.begin, piece.end, series.v, series.phi});
            state = series.at(piece.length());
        }
    };
    if (!is_at_start()) pass(0.0, x_);
    state.v += moved.v;
    state.phi += moved.phi;
    if (!is_at_end()) pass(x_, L_);
    return parts;
}

std::vector<Dislocation::PlaneMotion> Dislocation::elastic_beam(BendingPlane plane, const PlaneEnds& ends) const
{
    const Beam& beam = plane == BendingPlane::xy ? xy_ : xz_;
    const Eigen::Vector4d forces = beam.stiffness(L_) * (ends - rigid_ends(plane));
    return from_state(beam, {.v = ends[0], .phi = ends[1], .V = forces[0], .M = -forces[1]}, plane);
}

// The part beyond the section is moved as if nothing strained; what the foundation does to it bends the whole member.
std::vector<Dislocation::PlaneMotion> Dislocation::on_foundation(BendingPlane plane, const PlaneEnds& ends) const
{
    const Step moved = step(plane);
    const SpanLoading loading = loading_of(xy_, L_, held_back(plane));
    const FoundationBeam founded(xy_, loading, plane, 0.0);
    std::vector<Beam::State> states = founded.states(ends - rigid_ends(plane));
    std::vector<PlaneMotion> parts;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const SpanPiece& loaded = loading.pieces()[i];
        if (loaded.begin >= x_) {
            states[i].v += moved.v + moved.phi * (loaded.begin - x_);
            states[i].phi += moved.phi;
        }
        const SpanPiece bare{.begin = loaded.begin, .end = loaded.end, .is_settled = loaded.is_settled};
        const Beam::Series series = xy_.series(states[i], bare, plane, 0.0);
        parts.push_back({bare.begin, bare.end, series.v, series.phi});
    }
    return parts;
}

std::vector<Dislocation::PlaneMotion> Dislocation::motion(BendingPlane plane, const PlaneEnds& ends) const
{
    if (is_simple(plane)) return simple_beam(plane, ends);
    const bool is_founded = plane == BendingPlane::xy && xy_.foundation > 0.0;
    return is_founded ? on_foundation(plane, ends) : elastic_beam(plane, ends);
}

namespace {

/// A linear function over the member with a step at the section, from its values at the ends.
struct SteppedLine {
    double first, slope, step, x;

    SteppedLine(double start, double end, double jump, double at, double L)
        : first(start), slope((end - start - jump) / L), step(jump), x(at)
    {}
    Polynomial over(double from) const { return {first + slope * from + (from >= x ? step : 0.0), slope}; }
};

} // namespace

// On a foundation x'y' has more pieces than x'z', which is then the same over all those of one side.
MemberMotion Dislocation::motion(std::array<LocalDisplacement, 2> ends) const
{
    for (std::size_t end = 0; end < 2; ++end) add(ends[end], slips_[end]);
    const auto& [a, b] = ends;
    const SteppedLine stretched(a.u, b.u, gap(), x_, L_), around(a.rx, b.rx, twist(), x_, L_);
    const double start = a.u, N = (b.u - a.u - gap()) / axial_.flexibility(L_);
    const auto along = [&](double from, double to) {
        if (axial_.taper == 0.0) return stretched.over(from);
        const double u = start + N * axial_.flexibility(from) + (from >= x_ ? gap() : 0.0);
        return axial_.series({.u = u, .N = N}, {.begin = from, .end = to}, LocalAxis::x, 0.0).u;
    };
    const std::vector<PlaneMotion> xy = motion(BendingPlane::xy, PlaneEnds(a.v, a.rz, b.v, b.rz));
    const std::vector<PlaneMotion> xz = motion(BendingPlane::xz, PlaneEnds(a.w, -a.ry, b.w, -b.ry));
    std::vector<double> places;
    for (const auto* plane : {&xy, &xz})
        for (const PlaneMotion& part : *plane) places.push_back(part.from);
    if (!is_at_end()) places.push_back(x_);
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    places.push_back(L_);

    const auto part_at = [](const std::vector<PlaneMotion>& plane, double from) {
        std::size_t i = 0;
        while (i + 1 < plane.size() && plane[i + 1].from <= from) ++i;
        return plane[i];
    };
    MemberMotion motion;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double from = places[i];
        const PlaneMotion v = part_at(xy, from), w = part_at(xz, from);
        motion.push_back(
            {.from = from,
             .to = places[i + 1],
             .along = {along(from, places[i + 1]), v.v.shifted(from - v.from), w.v.shifted(from - w.from),
                       around.over(from), negated(w.phi.shifted(from - w.from)), v.phi.shifted(from - v.from)}});
    }
    return motion;
}

} // namespace femoop::influence
