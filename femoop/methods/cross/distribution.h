#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "femoop/methods/cross/problem.h"

namespace femoop::cross {

/// Where a distribution stands: every locked joint holds its unbalance, so that each state is a real structure.
struct State {
    std::vector<double> moments;   ///< at every end
    std::vector<double> rotations; ///< of every joint so far [rad]
    std::vector<double> unbalance; ///< of every joint: moments of its ends less its load
};

/// A number that a step writes into a column.
struct Change {
    EndId end;
    double value = 0.0;
};

/// One joint turned until it is balanced, its mirror image with it, or all of them at once.
struct Step {
    std::optional<JointId> joint;   ///< nothing: all at once
    std::size_t first = 0;          ///< of its balancing moments among Sheet::changes
    std::size_t carried = 0;        ///< of its carry-overs
    std::size_t last = 0;           ///< past them
    double largest_unbalance = 0.0; ///< after it
    bool is_carried = true;         ///< false: the sheet ends with this balance
};

enum class Order : std::uint8_t { Largest, LeftToRight, AllAtOnce, Listed };

struct Procedure {
    Order order = Order::Largest; ///< ties: file order
    std::vector<JointId> joints;  ///< Order::Listed: again and again
    /// Stops when no unbalance is larger; default 0.001 of the largest fixed-end moment.
    std::optional<double> tolerance;
    std::optional<std::size_t> balances; ///< stops after so many instead
    bool ends_with_balance = false;      ///< with `balances`: nothing is carried over after the last
    int digits = 0;                      ///< every number is rounded to so many significant ones; 0: exact
    std::size_t most_steps = 20000;
};

/// A distribution with every number that it writes.
///
/// Signs    moments on the ends of the members, counter-clockwise positive (courseware/conventions.md)
/// Units    the model's base units
/// Source   [Cross1930]
struct Sheet {
    State start; ///< the row of fixed-end moments
    std::vector<Step> steps;
    std::vector<Change> changes;
    State end; ///< the row of totals
    double tolerance = 0.0;
    bool is_balanced = false; ///< no unbalance is larger than the tolerance

    std::span<const Change> balanced(const Step& step) const
    {
        return std::span(changes).subspan(step.first, step.carried - step.first);
    }
    std::span<const Change> carried_over(const Step& step) const
    {
        return std::span(changes).subspan(step.carried, step.last - step.carried);
    }
};

/// The factors that a procedure works with: rounded where it rounds.
std::vector<double> factors_of(const Problem& problem, int digits = 0);

/// The locked structure. \param digits as in Procedure
State locked_state(const Problem& problem, const Loading& loading, int digits = 0);

/// What releasing one joint and its mirror image does to a state: its balancing moments, then its carry-overs.
struct Release {
    std::vector<Change> balance, carry_over;
};
Release release_of(const Problem& problem, const State& state, JointId joint, int digits = 0);

/// The state after a joint is released, balanced and locked again.
State balance(const Problem& problem, const State& state, JointId joint, int digits = 0);

/// The joint with the largest unbalance; the first of equal ones. Nothing without joints to balance.
std::optional<JointId> worst_joint(const Problem& problem, const State& state);
double largest_unbalance(const State& state);

/// Works a whole sheet; \throws ModelError (CrossSteps) naming the worst joint if it needs more steps than it may.
Sheet distribute(const Model& model, const Problem& problem, const Loading& loading, const Procedure& procedure);

/// The same without the exception: Sheet::is_balanced tells.
Sheet try_to_distribute(const Model& model, const Problem& problem, const Loading& loading, const Procedure& procedure);

/// The state after the first `n` steps of a sheet.
State state_after(const Problem& problem, const Sheet& sheet, std::size_t n);

/// What rounding cost: the sheet's totals less those of the same steps without rounding, for every end.
std::vector<double> drift(const Problem& problem, const Loading& loading, const Sheet& sheet);

enum class RowKind : std::uint8_t { FixedEnd, Balance, CarryOver, Total };

/// One row of the sheet as it is written, a number for every end.
struct Row {
    RowKind kind = RowKind::FixedEnd;
    std::optional<JointId> joint; ///< of a balance of one joint
    std::vector<double> values;
};
std::vector<Row> rows_of(const Problem& problem, const Sheet& sheet);

/// The largest unbalance of the locked structure, then after every step.
std::vector<double> convergence(const Sheet& sheet);

/// By which factor the largest unbalance shrinks in one round of all joints, over the last half of the sheet; nothing
/// where the sheet is too short to tell.
std::optional<double> rate(const Problem& problem, const Sheet& sheet);

} // namespace femoop::cross
