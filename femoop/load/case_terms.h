#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/model.h"

namespace femoop {

/// A load case or combination as a sum of load cases.
struct CaseTerms {
    struct Term {
        std::size_t load_case = 0;
        double factor = 1.0;
    };
    std::string name;
    std::vector<Term> terms;
};

/// A combination multiplied out: each load case once, in the model's order, those with the factor 0 left out. Of a case
/// that the model lacks, and of what combinations name in a circle, there is nothing (femoop/model/check/check.h tells).
CaseTerms terms_of(const Model& model, CaseId id);
std::vector<CaseTerms> cases_of(const Model& model); ///< of load cases, then of combinations
std::vector<CaseTerms> cases_of(const std::vector<std::string_view>& load_cases,
                                const std::vector<Combination>& combinations);

} // namespace femoop
