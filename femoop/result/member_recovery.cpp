#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>

#include "femoop/element/member_element.h"
#include "femoop/result/curve_reader.h"
#include "femoop/result/end_vectors.h"

namespace femoop::detail {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A member in one case: how its own ends move and what its nodes do to them, in its own axes.
struct MemberState {
    std::array<Vector6, 2> d{Vector6::Zero(), Vector6::Zero()};
    std::array<Vector6, 2> p{Vector6::Zero(), Vector6::Zero()};
};

/// Whose forces follow from a motion: what strains the member, or what its constraint takes from it.
enum class Part : std::uint8_t { Elastic, Constraint };

/// Displacements to as many digits as the solution has.
template <class Scalar> class MotionView {
public:
    MotionView(const CaseSolution& solution, Part part) : solution_(solution), part_(part) {}

    Scalar at_node(std::size_t i) const
    {
        return part_ == Part::Elastic
                   ? value(&Motions<Scalar>::displacements, &Motions<double>::displacements, i)
                   : value(&Motions<Scalar>::constraint_displacements, &Motions<double>::constraint_displacements, i);
    }
    Scalar at_member_end(std::size_t i) const
    {
        return part_ == Part::Elastic
                   ? value(&Motions<Scalar>::member_ends, &Motions<double>::member_ends, i)
                   : value(&Motions<Scalar>::constraint_member_ends, &Motions<double>::constraint_member_ends, i);
    }

private:
    Scalar value(std::vector<Scalar> Motions<Scalar>::*precise, std::vector<double> Motions<double>::*rounded,
                 std::size_t i) const
    {
        if constexpr (!std::is_same_v<Scalar, double>)
            if (!solution_.precise.displacements.empty()) return (solution_.precise.*precise)[i];
        return (solution_.*rounded)[i];
    }

    const CaseSolution& solution_;
    Part part_;
};

/// Reads one member out of a solution.
template <AnalysisKind kind> class MemberReader {
public:
    using Element = MemberElement<kind>;
    using LocalVector = typename Element::LocalVector;
    static constexpr int m = Element::m;
    static constexpr int n = Element::n;
    using NodeDisplacements = Eigen::Matrix<double, n, 1>;
    static constexpr auto& local = AnalysisModel<kind>::local;
    static constexpr bool is_in_plane = kind == AnalysisKind::Truss2d || kind == AnalysisKind::Frame2d;

    MemberReader(const Solution& solution, std::size_t case_index)
        : solution_(solution), structure_(*solution.structure), terms_(solution.cases[case_index].terms)
    {
        for (const CaseTerms::Term& term : terms_)
            is_precise_ |= !solution.solutions[term.load_case].precise.displacements.empty();
        is_unstressed_ = !terms_.empty() && std::ranges::all_of(terms_, [&](const CaseTerms::Term& term) {
            return solution.solutions[term.load_case].is_unstressed;
        });
    }

    void read(MemberId member)
    {
        member_ = member;
        place(member);
        if (is_like_last(member)) return;
        is_begun_ = false;
        end_conditions_ = structure_.end_conditions_of(member);
        properties_ = &structure_.properties_of(member);
        scaled_.clear();
        for (const CaseTerms::Term& term : terms_)
            scaled_.push_back({.loads = solution_.loads[term.load_case].of(member), .factor = term.factor});
        properties_->xy.cut(loading_, geometry_.length, scaled_);
        if (is_plain()) keep_plain();
    }

    MemberState state() const
    {
        if (is_plain()) return plain_state();
        MemberState s;
        s.d = ends(Part::Elastic);
        const bool is_constrained = end_conditions_ != nullptr && end_conditions_->constraint != Constraint::None;
        const Element elastic(*properties_, geometry_, end_conditions_,
                              end_conditions_ == nullptr ? all_actions : elastic_actions(*end_conditions_));
        const LocalVector f = elastic.rigid_joint_forces(loading_);
        const LocalVector d = pack(s.d);
        LocalVector p;
        if (end_conditions_ != nullptr && end_conditions_->has_flexible_joint && !is_constrained) {
            p = is_precise_ ? LocalVector(precise_forces(elastic, elastic.strains(), Part::Elastic) +
                                          elastic.end_forces(LocalVector::Zero(), f))
                            : elastic.end_forces(d, f);
            unpack(elastic.end_displacements(d, f), s.d);
        } else p = strain_forces(elastic, d, Part::Elastic) + f;
        if (is_constrained) {
            const Element constrained(*properties_, geometry_, end_conditions_, constrained_actions(*end_conditions_));
            p += strain_forces(constrained, pack(ends(Part::Constraint)), Part::Constraint) +
                 constrained.rigid_joint_forces(loading_.without_strain());
        }
        unpack(p, s.p);
        if (is_bar()) add_simple_span(s);
        if (is_unstressed_) s.p = {Vector6::Zero(), Vector6::Zero()};
        return s;
    }

    /// \pre a constraint ties the member
    MemberState state(CurvePart part) const
    {
        const Element elastic(*properties_, geometry_, end_conditions_, elastic_actions(*end_conditions_));
        const Element tied(*properties_, geometry_, end_conditions_, constrained_actions(*end_conditions_));
        MemberState s;
        switch (part) {
        case CurvePart::Motion:
            s.d = ends(Part::Elastic);
            unpack(strain_forces(elastic, pack(s.d), Part::Elastic), s.p);
            break;
        case CurvePart::Loads:
            unpack(elastic.rigid_joint_forces(loading_) + tied.rigid_joint_forces(loading_.without_strain()), s.p);
            if (is_bar()) add_simple_span(s);
            break;
        case CurvePart::Constraint:
            unpack(strain_forces(tied, pack(ends(Part::Constraint)), Part::Constraint), s.p);
            break;
        }
        if (is_unstressed_) s.p = {Vector6::Zero(), Vector6::Zero()};
        return s;
    }

    /// \pre always into the same curve
    void write(Curve& curve) { write(curve, state()); }

    /// Of a part; the loads go with one of them alone.
    void write(Curve& curve, CurvePart part)
    {
        const MemberState s = state(part);
        if (part != CurvePart::Loads) properties_->xy.cut(loading_, geometry_.length, {});
        write(curve, s);
    }

private:
    void write(Curve& curve, const MemberState& s)
    {
        if (!is_plain()) law_ = law(s);
        if (!is_begun_) curve.begin(law_, loading_.pieces());
        is_begun_ = is_plain();
        Curve::State at = first_state(s);
        const std::vector<Beam::State> on_foundation = foundation_states(s, law_);
        const std::vector<SpanPiece>& pieces = loading_.pieces();
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (!on_foundation.empty()) at.xy = on_foundation[i];
            pass_jump(at, pieces[i]);
            curve.begin_piece(i, at);
            if (i + 1 < pieces.size()) pass_piece(at, pieces[i], law_);
        }
    }

    bool is_plain() const { return end_conditions_ == nullptr && !is_precise_; }

    bool has_no_end_conditions_like_last(MemberId member) const
    {
        return structure_.end_conditions_of(member) == nullptr && end_conditions_ == nullptr;
    }

    /// Members that are parallel and equally long share their axes: most structures repeat themselves.
    void place(MemberId member)
    {
        const auto [start, end] = structure_.members[member.index].nodes;
        const Eigen::Vector3d chord = structure_.positions[end.index] - structure_.positions[start.index];
        if (!has_no_end_conditions_like_last(member) || chord != chord_) geometry_ = structure_.geometry(member);
        chord_ = chord;
    }

    /// But for its place and direction.
    bool is_like_last(MemberId member) const
    {
        if (!has_no_end_conditions_like_last(member)) return false;
        if (properties_ != &structure_.properties_of(member) || loading_.length() != geometry_.length) return false;
        for (std::size_t i = 0; i < terms_.size(); ++i)
            if (!std::ranges::equal(scaled_[i].loads, solution_.loads[terms_[i].load_case].of(member))) return false;
        return true;
    }

    void keep_plain()
    {
        const Element element(*properties_, geometry_, nullptr, all_actions);
        stiffness_ = element.rigid_joint_stiffness();
        fixed_end_forces_ = element.rigid_joint_forces(loading_);
        law_ = law({}); // whatever its ends do
    }

    MemberState plain_state() const
    {
        MemberState s;
        s.d = ends(Part::Elastic);
        if (!is_unstressed_) unpack(stiffness_.lazyProduct(pack(s.d)) + fixed_end_forces_, s.p);
        return s;
    }

    bool is_bar() const { return end_conditions_ != nullptr && end_conditions_->is_bar; }

    /// Forces on the ends from displacements between rigid joints.
    LocalVector strain_forces(const Element& element, const LocalVector& d, Part part) const
    {
        return is_precise_ ? precise_forces(element, element.rigid_joint_strains(), part)
                           : LocalVector(element.rigid_joint_stiffness() * d);
    }

    /// The same from strains that keep their digits where the displacements of the whole are large beside them.
    LocalVector precise_forces(const Element& element, const StrainForm& form, Part part) const
    {
        const PreciseMatrix B = form.B.cast<DoubleDouble>();
        const PreciseVector strains = B * precise_ends(element, part);
        return rounded(B.transpose() * (form.S.cast<DoubleDouble>() * strains));
    }

    PreciseVector precise_ends(const Element& element, Part part) const
    {
        PreciseVector d(2 * m);
        for (std::size_t end = 0; end < 2; ++end) {
            d.segment<m>(static_cast<int>(end) * m) = element.transformation(end).template cast<DoubleDouble>() *
                                                      node_displacements<DoubleDouble>(end, part);
        }
        visit_member_ends<DoubleDouble>(
            part, [&](std::size_t end, int i, DoubleDouble value) { d[static_cast<int>(end) * m + i] = value; });
        return d;
    }

    /// The member's own ends as they follow its nodes, and where it has ends of its own, those.
    std::array<Vector6, 2> ends(Part part) const
    {
        std::array<Vector6, 2> d{following_node(0, part), following_node(1, part)};
        visit_member_ends<double>(part, [&](std::size_t end, int i, double value) {
            d[end][static_cast<int>(index(local[static_cast<std::size_t>(i)]))] = value;
        });
        return d;
    }

    template <class Scalar> Eigen::Matrix<Scalar, n, 1> node_displacements(std::size_t end, Part part) const
    {
        const std::size_t first = structure_.members[member_.index].nodes[end].index * n;
        Eigen::Matrix<Scalar, n, 1> u = Eigen::Matrix<Scalar, n, 1>::Zero();
        for (const CaseTerms::Term& term : terms_) {
            const MotionView<Scalar> motion(solution_.solutions[term.load_case], part);
            const Scalar factor(term.factor);
            for (int i = 0; i < n; ++i) u[i] += factor * motion.at_node(first + static_cast<std::size_t>(i));
        }
        return u;
    }

    /// Of a node's displacements, along global axes; one that the kind of model does not have is zero.
    template <Dof dof> static double component(const NodeDisplacements& u)
    {
        constexpr auto& global = AnalysisModel<kind>::global;
        constexpr auto i = std::ranges::find(global, dof) - global.begin();
        if constexpr (i < n) return u[i];
        else return 0.0;
    }

    /// How an end moves with its node: along its own axes, and by a rotation through the rigid arm.
    Vector6 following_node(std::size_t end, Part part) const
    {
        const NodeDisplacements u = node_displacements<double>(end, part);
        Eigen::Vector3d moved(component<Dof::ux>(u), component<Dof::uy>(u), component<Dof::uz>(u));
        const Eigen::Vector3d turned(component<Dof::rx>(u), component<Dof::ry>(u), component<Dof::rz>(u));
        if (end_conditions_ != nullptr && end_conditions_->has_offset)
            moved += turned.cross(end_conditions_->offsets[end]);
        Vector6 d = Vector6::Zero();
        if constexpr (is_in_plane) {
            d.head<2>() = geometry_.axes.template topLeftCorner<2, 2>().lazyProduct(moved.head<2>());
            d[5] = geometry_.axes(2, 2) * turned[2];
            return d;
        }
        d.head<3>() = geometry_.axes.lazyProduct(moved);
        d.tail<3>() = geometry_.axes.lazyProduct(turned);
        return d;
    }

    template <class Scalar, class Visit> void visit_member_ends(Part part, Visit&& visit) const
    {
        if (solution_.member_end_dofs_of.empty() || solution_.member_end_dofs_of[member_.index] < 0) return;
        const auto first = 12 * static_cast<std::size_t>(solution_.member_end_dofs_of[member_.index]);
        for (std::size_t end = 0; end < 2; ++end)
            for (int i = 0; i < m; ++i) {
                const std::size_t a = index(local[static_cast<std::size_t>(i)]);
                if (!std::isfinite(end_conditions_->joints[end][a])) continue;
                Scalar sum = 0.0;
                for (const CaseTerms::Term& term : terms_)
                    sum += Scalar(term.factor) * MotionView<Scalar>(solution_.solutions[term.load_case], part)
                                                     .at_member_end(first + 6 * end + a);
                visit(end, i, sum);
            }
    }

    static typename Element::LocalVector pack(const std::array<Vector6, 2>& ends)
    {
        typename Element::LocalVector v;
        for (std::size_t end = 0; end < 2; ++end)
            for (std::size_t i = 0; i < local.size(); ++i)
                v[static_cast<int>(end * local.size() + i)] = ends[end][static_cast<int>(index(local[i]))];
        return v;
    }

    static void unpack(const typename Element::LocalVector& v, std::array<Vector6, 2>& ends)
    {
        for (std::size_t end = 0; end < 2; ++end)
            for (std::size_t i = 0; i < local.size(); ++i)
                ends[end][static_cast<int>(index(local[i]))] = v[static_cast<int>(end * local.size() + i)];
    }

    void add_simple_span(MemberState& s) const
    {
        for (const BendingPlane plane : {BendingPlane::xy, BendingPlane::xz}) {
            const Eigen::Vector2d reactions = Beam::simple_span_forces(loading_, plane);
            const auto axis = static_cast<int>(index(force_axis(plane)));
            s.p[0][axis] = reactions[0];
            s.p[1][axis] = reactions[1];
        }
    }

    /// What strains between the ends: a bar keeps its chord, a constraint takes a stiffness to infinity.
    Curve::Law law(const MemberState& s) const
    {
        Curve::Law law{.axial = properties_->axial,
                       .torsion = properties_->torsion,
                       .xy = properties_->xy,
                       .xz = properties_->xz,
                       .strain = loading_.strain(),
                       .curvature = loading_.curvature(),
                       .is_in_plane = is_in_plane};
        if (is_bar()) {
            law = {.axial = {infinite}, .torsion = {infinite}, .xy = {.EI = infinite}, .xz = {.EI = infinite}};
            law.is_in_plane = is_in_plane;
            law.strain = (s.d[1][0] - s.d[0][0]) / geometry_.length;
            return law;
        }
        // What a kind of model does not ask for, such as Iy in the plane, does not strain.
        for (double* stiffness : {&law.axial.EA, &law.torsion.EA, &law.xy.EI, &law.xz.EI})
            if (*stiffness == 0.0) *stiffness = infinite;
        if (end_conditions_ == nullptr || end_conditions_->constraint == Constraint::None) return law;
        law.axial = {infinite};
        if (end_conditions_->constraint == Constraint::Inextensible) return law;
        law.torsion.EA = infinite;
        law.xy = {.EI = infinite, .foundation = properties_->xy.foundation};
        law.xz = {.EI = infinite};
        return law;
    }

    std::vector<Beam::State> foundation_states(const MemberState& s, const Curve::Law& law) const
    {
        const bool is_one_piece = loading_.pieces().size() == 1; // then it begins with the end's own forces
        if (law.xy.foundation <= 0.0 || law.xy.EI == infinite || is_one_piece) return {};
        const Eigen::Vector4d d(s.d[0][1], s.d[0][5], s.d[1][1], s.d[1][5]);
        return FoundationBeam(law.xy, loading_, BendingPlane::xy, law.curvature).states(d);
    }

    /// Before the point loads at the first end.
    Curve::State first_state(const MemberState& s) const
    {
        Curve::State first{.axial = {.u = s.d[0][0], .N = -s.p[0][0]},
                           .torsion = {.u = s.d[0][3], .N = -s.p[0][3]},
                           .xy = {.v = s.d[0][1], .phi = s.d[0][5], .V = s.p[0][1], .M = -s.p[0][5]},
                           .xz = {.v = s.d[0][2], .phi = -s.d[0][4], .V = s.p[0][2], .M = s.p[0][4]}};
        if (is_bar()) {
            first.xy.phi = (s.d[1][1] - s.d[0][1]) / geometry_.length;
            first.xz.phi = (s.d[1][2] - s.d[0][2]) / geometry_.length;
            first.xy.M = first.xz.M = 0.0;
        }
        return first;
    }

    static void pass_jump(Curve::State& at, const SpanPiece& piece)
    {
        at.axial.N -= piece.jump[index(LocalAxis::x)];
        at.torsion.N -= piece.jump[index(LocalAxis::rx)];
        at.xy = Beam::after_jump(at.xy, piece.jump, BendingPlane::xy);
        at.xz = Beam::after_jump(at.xz, piece.jump, BendingPlane::xz);
    }

    static void pass_piece(Curve::State& at, const SpanPiece& piece, const Curve::Law& law)
    {
        const double h = piece.length();
        at.axial = law.axial.at(h, at.axial, piece, LocalAxis::x, law.strain);
        at.torsion = law.torsion.at(h, at.torsion, piece, LocalAxis::rx, 0.0);
        at.xy = law.xy.at(h, at.xy, piece, BendingPlane::xy, law.curvature);
        at.xz = law.xz.at(h, at.xz, piece, BendingPlane::xz, 0.0);
    }

    const Solution& solution_;
    const Discretisation& structure_;
    const std::vector<CaseTerms::Term>& terms_;
    MemberId member_;
    const MemberEndConditions* end_conditions_ = nullptr;
    const MemberProperties* properties_ = nullptr;
    MemberGeometry geometry_;
    Eigen::Vector3d chord_ = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()); ///< of the last one
    SpanLoading loading_;
    std::vector<SpanLoading::Scaled> scaled_;
    bool is_precise_ = false;
    bool is_unstressed_ = false;
    typename Element::LocalMatrix stiffness_; ///< of the last plain member, in its own axes
    LocalVector fixed_end_forces_;
    Curve::Law law_;        ///< of the last one
    bool is_begun_ = false; ///< the curve has the law and the loads of the last one
};

} // namespace

/// Reads members of one of the five models, whichever.
class AnyReader {
public:
    virtual ~AnyReader() = default;
    virtual void write_curve(MemberId member, Curve& curve) = 0;
    virtual void write_curve(MemberId member, CurvePart part, Curve& curve) = 0;
    virtual MemberState state(MemberId member) = 0;
    virtual MemberState state(MemberId member, CurvePart part) = 0;
};

namespace {

template <AnalysisKind kind> class ReaderOf final : public AnyReader {
public:
    ReaderOf(const Solution& solution, std::size_t case_index) : reader_(solution, case_index) {}
    void write_curve(MemberId member, Curve& curve) override
    {
        reader_.read(member);
        reader_.write(curve);
    }
    void write_curve(MemberId member, CurvePart part, Curve& curve) override
    {
        reader_.read(member);
        reader_.write(curve, part);
    }
    MemberState state(MemberId member) override
    {
        reader_.read(member);
        return reader_.state();
    }
    MemberState state(MemberId member, CurvePart part) override
    {
        reader_.read(member);
        return reader_.state(part);
    }

private:
    MemberReader<kind> reader_;
};

MemberState state_of(const Solution& solution, std::size_t case_index, MemberId member)
{
    return with_model(solution.structure->kind, [&](auto kind) {
        MemberReader<decltype(kind)::value> reader(solution, case_index);
        reader.read(member);
        return reader.state();
    });
}

std::array<NodeVector, 2> node_vectors(const std::array<Vector6, 2>& ends)
{
    std::array<NodeVector, 2> vectors{};
    for (std::size_t end = 0; end < 2; ++end) std::ranges::copy(ends[end], vectors[end].begin());
    return vectors;
}

} // namespace

std::unique_ptr<AnyReader> make_reader(const Solution& solution, std::size_t case_index)
{
    return with_model(solution.structure->kind, [&](auto kind) -> std::unique_ptr<AnyReader> {
        return std::make_unique<ReaderOf<decltype(kind)::value>>(solution, case_index);
    });
}

EndVectors end_displacements(const Solution& solution, std::size_t case_index, MemberId member)
{
    return state_of(solution, case_index, member).d;
}

EndVectors end_forces(const Solution& solution, std::size_t case_index, MemberId member)
{
    return state_of(solution, case_index, member).p;
}

} // namespace femoop::detail

namespace femoop {

CurveReader::CurveReader(const CaseResult& result)
    : solution_(result.solution_), reader_(detail::make_reader(*solution_, result.index_))
{}

CurveReader::~CurveReader() = default;

const Curve& CurveReader::read(MemberId member)
{
    reader_->write_curve(member, curve_);
    return curve_;
}

const Curve& CurveReader::read(MemberId member, CurvePart part)
{
    reader_->write_curve(member, part, curve_);
    return curve_;
}

std::array<NodeVector, 2> CurveReader::end_displacements(MemberId member)
{
    return detail::node_vectors(reader_->state(member).d);
}

std::array<NodeVector, 2> CurveReader::end_forces(MemberId member)
{
    return detail::node_vectors(reader_->state(member).p);
}

std::array<NodeVector, 2> CurveReader::end_forces(MemberId member, CurvePart part)
{
    return detail::node_vectors(reader_->state(member, part).p);
}

} // namespace femoop
