#include "apps/plane/view/case_shares.h"

#include <string_view>

#include "femoop/load/case_terms.h"

namespace plane {

std::vector<CaseShare> shares_of(const femoop::plane::PlaneModel& model, femoop::CaseId shown)
{
    if (shown.index >= model.n_cases()) return {};
    std::vector<std::string_view> names;
    for (const auto& load_case : model.load_cases) names.push_back(load_case.id);
    std::vector<CaseShare> shares;
    const std::vector<femoop::CaseTerms> cases = femoop::cases_of(names, model.combinations);
    for (const auto& [load_case, factor] : cases[shown.index].terms)
        shares.push_back({model.load_cases[load_case], factor});
    return shares;
}

} // namespace plane
