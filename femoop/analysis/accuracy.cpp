#include "femoop/analysis/accuracy.h"

#include <algorithm>
#include <cmath>

#include "femoop/analysis/settlement_force.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop {

namespace {

constexpr double wanted = 1e-11; // imbalance, at the unknowns: a sum over thousands of nodes then still has nine digits
constexpr double doubtful = 1e-8; // warned of
constexpr double useless = 1e-3;  // refused
constexpr double no_digit = 0.1;
constexpr double rounding = 2e-16; // of the imposed, by which doubles may be wrong though they balance

// Where settlements and heat strain members and nothing holds against them, no force is left but rounding.
constexpr double least_force = 1e-8;         // of the imposed, that a single force is held against
constexpr double least_force_of_body = 1e-5; // where stiffness differs less than among members
constexpr double least_sum = 1e-4;           // of the imposed, that the sums of forces are held against
// Forces through the origin have no moment there, and those of a far part of the structure only rounding.
constexpr double least_arm = 1e-4; // of the farthest node's, that a sum of moments is held against

// What is no number stays none in both, so that no comparison lets it pass.
double ratio(double part, double whole) { return part == 0.0 ? 0.0 : part / whole; }
double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

/// \param least  that forces are held against
double at_unknowns(const detail::Balance& balance, double least)
{
    return ratio(balance.out_of_balance, std::max(balance.largest, least));
}
double at_unknowns(const detail::Balance& balance) { return at_unknowns(balance, least_force * balance.imposed); }

/// Of the loads and reactions as a whole. \param sprung  what springs that settle would bring
double of_sums(const Equilibrium& equilibrium, const detail::Balance& balance, double sprung = 0.0)
{
    const auto unbalanced = [&](std::size_t first) {
        double sum = 0.0;
        for (std::size_t i = first; i < first + 3; ++i)
            sum = larger(sum, std::abs(equilibrium.sum_loads[i] + equilibrium.sum_reactions[i]));
        return sum;
    };
    const double least = std::max(least_sum * balance.imposed, sprung);
    const double least_moment = balance.reach * std::max(least, least_arm * balance.sum_forces);
    return larger(ratio(unbalanced(0), std::max(balance.sum_forces, least)),
                  ratio(unbalanced(3), std::max(balance.sum_moments, least_moment)));
}

/// Bodies that nothing but their springs hold go where these settle, and leave nothing of what the springs would bring:
/// all digits of the forces are rounding, those of the displacements are not.
double sprung_force_of(const detail::Solution& solution, std::size_t load_case, LeastForce least)
{
    if (least == LeastForce::OfMembers || solution.structure == nullptr) return 0.0;
    return sprung_force(*solution.structure, solution.loads[load_case], least_force_of_body);
}

double imbalance_beside(const detail::CaseSolution& each, double part, double sprung)
{
    return larger(at_unknowns(each.balance, std::max(part * each.balance.imposed, sprung)),
                  of_sums(each.equilibrium, each.balance, sprung));
}

/// The part that is told of.
auto shown(const detail::Solution& solution, LeastForce least)
{
    const double part = least == LeastForce::OfBodies ? least_force_of_body : least_force;
    return [&solution, part, least](std::size_t load_case) {
        const detail::CaseSolution& each = solution.solutions[load_case];
        return larger(imbalance_beside(each, part, sprung_force_of(solution, load_case, least)),
                      each.equilibrium.residual);
    };
}

/// What nobody should see where it is too large.
auto unbalanced(const detail::Solution& solution, LeastForce least)
{
    return [&solution, least](std::size_t load_case) {
        return imbalance_beside(solution.solutions[load_case], least_force,
                                sprung_force_of(solution, load_case, least));
    };
}

template <class Error>
std::vector<Fault> worse_than(double limit, const Error& error_of, FaultKind kind, const detail::Solution& solution)
{
    std::vector<Fault> faults;
    for (std::size_t c = 0; c < solution.solutions.size(); ++c) {
        const double error = error_of(c);
        if (error <= limit) continue;
        const double digits = std::isnan(error) ? 0.0 : std::max(0.0, std::floor(-std::log10(error)));
        faults.push_back({.kind = kind, .arguments = {solution.cases[c].name, number_text(digits)}});
    }
    return faults;
}

} // namespace

double imbalance(const detail::CaseSolution& solution) { return imbalance_beside(solution, least_force, 0.0); }

bool needs_precision(const detail::Solution& solution)
{
    return std::ranges::any_of(solution.solutions, [](const detail::CaseSolution& each) {
        const bool is_drowned = rounding * each.balance.imposed > wanted * each.balance.largest;
        return is_drowned || !(at_unknowns(each.balance) <= wanted) ||
               !(of_sums(each.equilibrium, each.balance) <= 10.0 * wanted);
    });
}

std::vector<Fault> inaccurate_cases(const detail::Solution& solution, LeastForce least)
{
    const FaultKind kind = least == LeastForce::OfBodies ? FaultKind::InaccurateBody : FaultKind::InaccurateCase;
    return worse_than(doubtful, shown(solution, least), kind, solution);
}

std::vector<Fault> ill_conditioned_cases(const detail::Solution& solution, LeastForce least)
{
    const auto all = unbalanced(solution, least);
    if (least == LeastForce::OfMembers) return worse_than(useless, all, FaultKind::IllConditionedCase, solution);
    const auto no_digits = worse_than(no_digit, shown(solution, least), FaultKind::IllConditionedBody, solution);
    return no_digits.empty() ? worse_than(useless, all, FaultKind::IllConditionedBody, solution) : no_digits;
}

std::vector<Fault> unsolved_cases(const detail::Solution& solution)
{
    std::vector<Fault> faults;
    for (std::size_t c = 0; c < solution.loads.size(); ++c)
        faults.push_back({.kind = FaultKind::IllConditionedCase, .arguments = {solution.cases[c].name}});
    return faults;
}

} // namespace femoop
