#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "femoop/analysis/trace.h"
#include "femoop/methods/derivation/renumbering.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop::derivation {

/// What a step of a derivation does, in the order in which they follow one another.
enum class StepKind : std::uint8_t {
    Governing,        ///< of an envelope: the cases of the largest and of the smallest value
    Combination,      ///< factors times the values of load cases
    Extreme,          ///< where along the member the value is largest and smallest
    Member,           ///< its length and what it resists with
    LocalStiffness,   ///< k', in its own axes
    Transformation,   ///< T, from the axes of its nodes to its own
    Stiffness,        ///< k = T' k' T, and where its rows stand in K
    FixedEndForces,   ///< of its loads, f0' in its own axes and f0 in those of its nodes
    StiffnessRow,     ///< what members and springs bring to one row of K
    LoadRow,          ///< what loads bring to one row of f
    Equations,        ///< K u = f: the whole of it where it is small, else the rows that matter
    EndDisplacements, ///< u of its nodes, u' = T u of its ends
    EndForces,        ///< p' = k' u' + f0'
    NodeForces,       ///< p = k u + f0 of one member, in global axes
    Superposition,    ///< what the ends' motion brings, and what the loads bring between held ends
    Reaction,         ///< forces of the members on the node less the loads on it
    TurnedSupport,    ///< from the axes of a turned support to a global one
    Held,             ///< a displacement that a support imposes
    Numbering,        ///< of the unknowns: as given, and as the solver eliminates
    RightHandSide,    ///< what loads on nodes and on members, and supports, bring to rows of f
    Resultant,        ///< of the components of a reaction, by their squares
    Difference,       ///< what is now, less what was kept
    // of inextensible and rigid members, which tie displacements to one another
    Ties,             ///< C u = c, and u = G y + u0 of the displacements y that are left
    ImposedTies,      ///< c and u0 of a load case: what settlements and heat impose through them
    ReducedEquations, ///< G' K G y = G' (f - K u0), as Equations
    TiedDisplacement, ///< one that follows others: a row of u = G y + u0
    TieForces,        ///< f - K u, which the constraints carry
    // of the force method (femoop/methods/force_method/force_method.h)
    Redundants,         ///< what is released, and how indeterminate the structure is without it
    State,              ///< forces of the primary structure under the loads, or under one redundant
    Flexibility,        ///< the gaps at one release in every state, by virtual work
    RedundantEquations, ///< delta X = c - delta_0
    StateSuperposition  ///< S = S0 + X1 S1 + ..
};
inline constexpr std::size_t n_step_kinds = 32;

/// Numbers as on paper, with what stands beside their rows and above their columns: names of displacements ("B.ux",
/// "B.ux'"), of members, or symbols that courseware/reference/command-line.md explains.
struct NamedMatrix {
    std::string symbol;
    std::vector<std::string> rows, columns;
    Eigen::MatrixXd values;
    int more_digits = 0; ///< than usual, that it is written with: femoop/methods/derivation/lost_digits.h
};

struct Step {
    StepKind kind = StepKind::Member;
    std::optional<MemberId> member; ///< of which it speaks
    std::optional<NodeId> node;
    std::optional<CaseId> load_case; ///< whose numbers these are; none where loads do not matter
    std::vector<NamedMatrix> matrices;
    bool is_whole = false;                    ///< of equations: none is left out
    std::vector<Eigen::Index> rows{};         ///< of the system, that it is about
    std::size_t state = 0;                    ///< of the force method: 0 of the loads, i of its i-th redundant
    std::optional<Renumbering> renumbering{}; ///< of Numbering
};

/// The way from the data to one number: every step with its numbers, the last of which is the number; where that is an
/// unknown of the equations, which are then the last step, its row of u.
///
/// Units    the model's base units, rotations in rad
/// Source   [McGuireGallagherZiemian2000, ch. 3-5]: the direct stiffness method
struct Derivation {
    MovingEffect effect;
    CaseId load_case;
    double value = 0.0;         ///< as the results have it
    double closing_error = 0.0; ///< by which the last step's sum, in 16 digits, is off; the analysis may carry more
    std::vector<Step> steps;
    SystemTrace system{}; ///< of which the steps write what matters
    /// By the force method: all its redundants, of which the first is the number; else none.
    std::vector<MovingEffect> redundants{};
};

/// Systems of no more unknowns are written as a whole.
inline constexpr std::size_t most_unknowns_shown = 12;

/// Through the same code that solves: femoop/analysis/trace.h, and `analyse` for a member between held ends.
/// \param results  of the model
/// \pre   the effect is sound (femoop/model/check/check.h, check_effect), or the resultant of a reaction in the plane
Derivation derive(const Model& model, const Results& results, CaseId load_case, const MovingEffect& effect);

/// The same of an envelope over these cases: of that whose value is the largest in magnitude; of equal ones the first.
/// \pre   at least one case
Derivation derive_governing(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                            const MovingEffect& effect);

/// The number of one case less that of another. \pre it is none along a whole member, and no resultant
Derivation derive_difference(const Model& model, const Results& results, CaseId now, CaseId kept,
                             const MovingEffect& effect);

/// The same number less one that was kept of another model, or of another state of this one: it has no steps here.
Derivation derive_difference(const Model& model, const Results& results, CaseId now, double kept,
                             const MovingEffect& effect);

} // namespace femoop::derivation
