#include "apps/frame/document/solution.h"

#include <algorithm>

#include "femoop/analysis/linear_static.h"
#include "femoop/model/check/check.h"

namespace frame {

namespace {

bool is_error(const femoop::Fault& fault) { return femoop::severity(fault.kind) == femoop::Severity::Error; }

} // namespace

bool Solution::has_errors() const { return std::ranges::any_of(faults, is_error); }

Solution solve(const Document& document)
{
    Solution solution;
    solution.faults = femoop::check(document.model);
    if (solution.has_errors()) return solution;
    try {
        solution.results = femoop::analyse(document.model);
        const auto& warnings = solution.results->warnings();
        solution.faults.insert(solution.faults.end(), warnings.begin(), warnings.end());
    } catch (const femoop::MechanismError& error) {
        solution.mechanisms = error.mechanisms();
        solution.faults.insert(solution.faults.end(), error.faults().begin(), error.faults().end());
    } catch (const femoop::ModelError& error) {
        solution.faults.insert(solution.faults.end(), error.faults().begin(), error.faults().end());
    }
    return solution;
}

} // namespace frame
