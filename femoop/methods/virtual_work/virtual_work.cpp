#include "femoop/methods/virtual_work/virtual_work.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/analysis/linear_static.h"
#include "femoop/element/polynomial_product.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/unit_load_case.h"
#include "femoop/result/components.h"
#include "femoop/result/expression.h"

namespace femoop::virtual_work {

namespace {

constexpr double shortest_stretch = 1e-12; ///< of a member: places that are nearer are one

bool is_nothing(const Polynomial& p)
{
    for (std::size_t i = 0; i < p.n_terms(); ++i)
        if (p[i] != 0.0) return false;
    return true;
}

/// The polynomial, or nothing where it is round-off beside numbers of this size.
Polynomial without_round_off(const Polynomial& p, double end, double magnitude)
{
    double largest = 0.0, power = 1.0;
    for (std::size_t i = 0; i < p.n_terms(); ++i, power *= end) largest = std::max(largest, std::abs(p[i]) * power);
    return without_rounding(largest, magnitude) == 0.0 ? Polynomial{} : p;
}

double integral_of_product(const Polynomial& p, const Polynomial& q, double end)
{
    double sum = 0.0;
    double power = end;
    for (std::size_t k = 0; k + 1 < p.n_terms() + q.n_terms(); ++k, power *= end)
        sum += product_coefficient(p, q, k) * power / static_cast<double>(k + 1);
    return sum;
}

/// Of p q / divisor. \pre where the divisor is no constant, `end` is within reach of its reciprocal
double integral_of_quotient(const Polynomial& p, const Polynomial& q, const Polynomial& divisor, double end)
{
    if (divisor.n_terms() == 1) return integral_of_product(p, q, end) / divisor[0];
    const Polynomial series = divisor.reciprocal();
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < p.n_terms() + q.n_terms(); ++k)
        sum += product_coefficient(p, q, k) * series.moment(k, end);
    return sum;
}

/// The force that works on a displacement of a member's end.
constexpr std::array<MemberComponent, 6> end_forces{MemberComponent::N, MemberComponent::Vy, MemberComponent::Vz,
                                                    MemberComponent::T, MemberComponent::My, MemberComponent::Mz};

/// All that works along one member.
class MemberWork {
public:
    MemberWork(const LoadedStructure& real, const LoadedStructure& unit, MemberId member, Work& work)
        : member_(member),
          work_(work),
          properties_(real.structure().properties_of(member)),
          end_conditions_(real.structure().end_conditions_of(member)),
          real_(real.result().curve(member)),
          unit_(unit.result().curve(member)),
          real_loading_(real.span_loading(member)),
          unit_loading_(unit.span_loading(member)),
          real_magnitudes_(real.magnitudes()),
          unit_magnitudes_(unit.magnitudes())
    {}

    void add(AnalysisKind kind)
    {
        for (const MemberComponent force : section_force_components(kind)) add_integrals(force);
        if (is_founded()) add_pressure();
        if (end_conditions_ == nullptr) return;
        for (std::size_t end = 0; end < 2; ++end)
            for (const MemberComponent force : end_forces) add_joint(end, force);
    }

private:
    bool is_bar() const { return end_conditions_ != nullptr && end_conditions_->is_bar; }
    bool is_rigid() const { return constraint() == Constraint::Rigid; }
    Constraint constraint() const
    {
        return end_conditions_ == nullptr ? Constraint::None : end_conditions_->constraint;
    }
    bool is_founded() const { return !is_bar() && properties_.xy.foundation > 0.0; }

    static double inverse(double stiffness) { return stiffness > 0.0 ? 1.0 / stiffness : 0.0; }

    double flexibility(MemberComponent force) const
    {
        if (force == MemberComponent::N) return constraint() == Constraint::None ? inverse(properties_.axial.EA) : 0.0;
        if (is_bar() || is_rigid()) return 0.0;
        switch (force) {
        case MemberComponent::T: return inverse(properties_.torsion.EA);
        case MemberComponent::Vy: return properties_.xy.shear_flexibility;
        case MemberComponent::Vz: return properties_.xz.shear_flexibility;
        case MemberComponent::Mz: return inverse(properties_.xy.EI);
        default: return inverse(properties_.xz.EI);
        }
    }

    double strain(MemberComponent force) const
    {
        if (force == MemberComponent::N) return real_loading_.strain();
        return force == MemberComponent::Mz && !is_bar() ? real_loading_.curvature() : 0.0;
    }

    bool is_tapered() const { return !properties_.xy.taper.is_prismatic(); }

    /// Beside that at the first end, as a polynomial of t = x - from.
    Polynomial stiffness(MemberComponent force, double from) const
    {
        if (!is_tapered()) return {1.0};
        const Taper& taper = properties_.xy.taper;
        const auto [a1, a2, a3] = taper.inertia;
        switch (force) {
        case MemberComponent::N: return Polynomial{1.0, properties_.axial.taper}.shifted(from);
        case MemberComponent::Vy: return Polynomial{1.0, taper.shear_area}.shifted(from);
        default: return Polynomial{1.0, a1, a2, a3}.shifted(from);
        }
    }
    Polynomial depth(MemberComponent force, double from) const
    {
        if (!is_tapered() || force != MemberComponent::Mz) return {1.0};
        return Polynomial{1.0, properties_.xy.taper.depth}.shifted(from);
    }

    void add_integrals(MemberComponent force)
    {
        const double flexibility = this->flexibility(force), strain = this->strain(force);
        if (flexibility == 0.0 && strain == 0.0) return;
        visit_stretches([&](const Curve::Piece& real, const Curve::Piece& unit, double from, double to) {
            add_integral({.member = member_,
                          .force = force,
                          .from = from,
                          .to = to,
                          .real = about_real(force, real, from),
                          .unit = about_unit(force, unit, from),
                          .flexibility = flexibility,
                          .strain = strain,
                          .stiffness = stiffness(force, from),
                          .depth = depth(force, from)});
        });
    }

    /// p = -k v works on v: with the flexibility 1 / k.
    void add_pressure()
    {
        const double k = properties_.xy.foundation;
        const auto pressure = [&](const Polynomial& v) {
            Polynomial p;
            for (std::size_t i = 0; i < v.n_terms(); ++i) p.append(-k * v[i]);
            return p;
        };
        visit_stretches([&](const Curve::Piece& real, const Curve::Piece& unit, double from, double to) {
            add_integral({.member = member_,
                          .force = {},
                          .from = from,
                          .to = to,
                          .real = pressure(about_real(MemberComponent::v, real, from)),
                          .unit = pressure(about_unit(MemberComponent::v, unit, from)),
                          .flexibility = 1.0 / k});
        });
    }

    static Polynomial about(const Curve& curve, MemberComponent component, const Curve::Piece& piece, double from,
                            const Magnitudes& magnitudes)
    {
        const Polynomial p = curve.polynomial(component, piece).shifted(from - piece.load.begin);
        return without_round_off(p, piece.load.end - from, magnitudes.of(component));
    }
    Polynomial about_real(MemberComponent component, const Curve::Piece& piece, double from) const
    {
        return about(real_, component, piece, from, real_magnitudes_);
    }
    Polynomial about_unit(MemberComponent component, const Curve::Piece& piece, double from) const
    {
        return about(unit_, component, piece, from, unit_magnitudes_);
    }

    /// Calls visit(real piece, unit piece, from, to) for every stretch that two pieces share.
    template <class Visit> void visit_stretches(Visit&& visit) const
    {
        const std::vector<Curve::Piece>&reals = real_.pieces(), &units = unit_.pieces();
        for (std::size_t i = 0, j = 0; i < reals.size() && j < units.size();) {
            const SpanPiece &real = reals[i].load, &unit = units[j].load;
            const double from = std::max(real.begin, unit.begin), to = std::min(real.end, unit.end);
            if (to - from > shortest_stretch * real_.length()) visit(reals[i], units[j], from, to);
            const bool real_ends = real.end <= unit.end;
            if (unit.end <= real.end) ++j;
            if (real_ends) ++i;
        }
    }

    void add_integral(WorkIntegral integral)
    {
        if (is_nothing(integral.unit) || (is_nothing(integral.real) && integral.strain == 0.0)) return;
        const double length = integral.to - integral.from;
        integral.value = integral.flexibility *
                             integral_of_quotient(integral.real, integral.unit, integral.stiffness, length) +
                         integral.strain * integral_of_quotient(integral.unit, {1.0}, integral.depth, length);
        if (goes_on(integral)) {
            work_.integrals.back().to = integral.to;
            work_.integrals.back().value += integral.value;
        } else {
            work_.integrals.push_back(integral);
        }
    }

    /// Where loads change that neither force knows of, and along a taper, whose displacements have short pieces.
    bool goes_on(const WorkIntegral& next) const
    {
        if (work_.integrals.empty()) return false;
        const WorkIntegral& last = work_.integrals.back();
        if (last.member != next.member || last.force != next.force || last.to != next.from) return false;
        const auto formula = [&](const Polynomial& p, const WorkIntegral& on) {
            return expression(p, on.from, on.to, real_.length());
        };
        return go_on(formula(last.real, last), formula(next.real, next), real_.length()) &&
               go_on(formula(last.unit, last), formula(next.unit, next), real_.length());
    }

    void add_joint(std::size_t end, MemberComponent force)
    {
        const double stiffness = end_conditions_->joints[end][index(axis_of(force))];
        if (!std::isfinite(stiffness) || stiffness == 0.0) return;
        const double real = without_rounding(force_in_joint(real_, real_loading_, end, force),
                                             real_magnitudes_.of(force));
        const double unit = without_rounding(force_in_joint(unit_, unit_loading_, end, force),
                                             unit_magnitudes_.of(force));
        if (real == 0.0 || unit == 0.0) return;
        work_.joints.push_back({member_, end, force, real, unit, stiffness, real * unit / stiffness});
    }

    MemberId member_;
    Work& work_;
    const MemberProperties& properties_;
    const MemberEndConditions* end_conditions_;
    Curve real_, unit_;
    SpanLoading real_loading_, unit_loading_;
    const Magnitudes &real_magnitudes_, &unit_magnitudes_;
};

void add_support(const LoadedStructure& real, const LoadedStructure& unit, const Discretisation::SupportRow& support,
                 Work& work)
{
    const NodeVector moved = in_axes_of(support, real.result().displacement(support.node));
    const NodeVector held = in_axes_of(support, unit.result().reaction(support.node));
    for (const Dof dof : all_dofs) {
        const double c = without_rounding(moved[index(dof)], real.magnitudes().displacement_of(dof));
        const double r = without_rounding(held[index(dof)], unit.magnitudes().force_of(dof));
        const bool moves = support.springs[index(dof)] > 0.0 || support.blocked.contains(dof);
        if (moves && c != 0.0 && r != 0.0) work.supports.push_back({support.node, dof, c, r, -r * c});
    }
}

} // namespace

std::optional<Polynomial> product(const WorkIntegral& along)
{
    constexpr std::size_t longest = 6; // of degree five: more terms are those of a series
    std::size_t n_terms = along.real.n_terms() + along.unit.n_terms();
    const auto coefficient = [&](std::size_t k) { return product_coefficient(along.real, along.unit, k); };
    while (n_terms > 0 && coefficient(n_terms - 1) == 0.0) --n_terms;
    if (n_terms > longest) return std::nullopt;
    Polynomial product;
    for (std::size_t k = 0; k < n_terms; ++k) product.append(coefficient(k));
    return product;
}

double integral_of_product(const WorkIntegral& along)
{
    return integral_of_product(along.real, along.unit, along.to - along.from);
}

double Work::of(MemberId member) const
{
    double sum = 0.0;
    for (const WorkIntegral& one : integrals) sum += one.member == member ? one.value : 0.0;
    for (const JointWork& one : joints) sum += one.member == member ? one.value : 0.0;
    return sum;
}

double Work::sum() const
{
    double sum = 0.0;
    for (const WorkIntegral& one : integrals) sum += one.value;
    for (const JointWork& one : joints) sum += one.value;
    for (const SupportWork& one : supports) sum += one.value;
    return sum;
}

Work work_between(const Loading& real, const Loading& unit)
{
    Work work;
    const LoadedStructure under_loads(real), under_unit(unit);
    const Discretisation& structure = under_loads.structure();
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        MemberWork(under_loads, under_unit, MemberId(i), work).add(structure.kind);
    for (const Discretisation::SupportRow& support : structure.supports)
        if (under_unit.structure().support_of(support.node) != nullptr)
            add_support(under_loads, under_unit, support, work);
    return work;
}

VirtualWork displacement_by_work(const Model& model, const Results& results, CaseId load_case,
                                 const MovingEffect& displacement)
{
    Model unit_model = without_loads(model);
    unit_model.load_cases.push_back(unit_load_case(model, displacement, influence::effect_name(model, displacement)));
    const Results under_unit = analyse(unit_model);
    Work work = work_between({model, results, load_case}, {unit_model, under_unit, CaseId(0)});
    const double sum = work.sum();
    return {.displacement = displacement,
            .load_case = load_case,
            .unit_model = std::move(unit_model),
            .under_unit = under_unit,
            .work = std::move(work),
            .sum = sum,
            .value = influence::effect_in(displacement, results[load_case])};
}

} // namespace femoop::virtual_work
