#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/cli/mohr_problem.h"

namespace cli {

/// A result by its key in JSON: nothing (null), a number, a list or a list of lists.
struct MohrResult {
    using Value = std::variant<std::monostate, double, std::vector<double>, std::vector<std::vector<double>>>;
    std::string_view key;
    Value value;
};

/// Everything that Mohr's circle tells of a state, in the order in which it is printed. Angles in degrees.
std::vector<MohrResult> mohr_results(const MohrProblem& problem);

const MohrResult* find_result(const std::vector<MohrResult>& results, std::string_view key);

std::string mohr_json(const std::vector<MohrResult>& results, const MohrProblem& problem);

/// The same for people.
std::string mohr_table(const std::vector<MohrResult>& results, const MohrProblem& problem, const ui::Catalogue& tr);

} // namespace cli
