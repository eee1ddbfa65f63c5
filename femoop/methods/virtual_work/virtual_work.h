#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/element/polynomial.h"
#include "femoop/methods/virtual_work/loaded_structure.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop::virtual_work {

/// The work along a stretch of a member over which both forces are polynomials in t = x - from:
///
///      value = integral of  unit (flexibility real / stiffness + strain / depth) dt
///
/// term by term, and along a taper by power series over short pieces: exact.
struct WorkIntegral {
    MemberId member;
    std::optional<MemberComponent> force; ///< N Vy Vz T My Mz; none: the pressure p = -k v of its foundation
    double from = 0.0, to = 0.0;          ///< along the member
    Polynomial real, unit;                ///< under the loads, and under the unit load
    double flexibility = 0.0;             ///< 1 / EA, 1 / GAs, 1 / GJ, 1 / EI, 1 / k, at the first end of the member
    double strain = 0.0;                  ///< imposed by heat or misfit: a lengthening (N), a curvature there (Mz)
    Polynomial stiffness{1.0};            ///< beside that at the first end: along a taper it varies
    Polynomial depth{1.0};                ///< likewise, where it divides an imposed curvature
    double value = 0.0;
};

/// real unit, a polynomial of t; nothing where one of them is a power series, on a foundation.
std::optional<Polynomial> product(const WorkIntegral& along);
/// integral of  real unit dt  over the stretch: what a table of standard integrals has.
double integral_of_product(const WorkIntegral& along);

/// The work of a spring between a member's end and its node: real unit / stiffness.
struct JointWork {
    MemberId member;
    std::size_t end = 0;
    MemberComponent force = MemberComponent::Mz;
    double real = 0.0, unit = 0.0;
    double stiffness = 0.0;
    double value = 0.0;
};

/// What a support that moves takes: - unit reaction times its real displacement, by a spring or imposed.
struct SupportWork {
    NodeId node;
    Dof dof = Dof::ux; ///< in the support's axes
    double displacement = 0.0;
    double reaction = 0.0; ///< under the unit load
    double value = 0.0;
};

/// Everything that works where one loading moves through another.
struct Work {
    std::vector<WorkIntegral> integrals; ///< member by member; none that is nothing
    std::vector<JointWork> joints;
    std::vector<SupportWork> supports;

    double of(MemberId member) const; ///< its integrals and joints
    double sum() const;
};

/// By the principle of virtual forces the displacement, under `real`, that the unit load of `unit` works on:
///
///      1 D = sum of  int n N / EA + int v V / GAs + int m M / EI + int t T / GJ + int n alpha T0 + int m kappa ..
///            + sum of  m M / k (joints)  - sum of  r c (supports)
///
/// \pre    the two models have the same members, of which `unit` may release some forces: its supports are among those
///         of `real`
/// Signs   femoop/result/curve.h
/// Units   the model's base units
/// Source  [Kassimali, ch. 7]; what a bar (truss) carries between its nodes strains it along its axis alone
Work work_between(const Loading& real, const Loading& unit);

/// A displacement, and what it is made of.
struct VirtualWork {
    MovingEffect displacement;
    CaseId load_case;
    Model unit_model;   ///< the structure under its unit load alone
    Results under_unit; ///< of that model
    Work work;
    double sum = 0.0;   ///< of the work
    double value = 0.0; ///< as the results have it
};

/// \param results  of the model  \pre the effect is a displacement that is sound (check_effect)
/// \throws ModelError, MechanismError  as `analyse`, of the structure under the unit load
VirtualWork displacement_by_work(const Model& model, const Results& results, CaseId load_case,
                                 const MovingEffect& displacement);

} // namespace femoop::virtual_work
