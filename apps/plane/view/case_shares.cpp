#include "apps/plane/view/case_shares.h"

#include <algorithm>
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

std::vector<PointForce> point_forces(const femoop::plane::PlaneModel& model, femoop::CaseId shown)
{
    std::vector<PointForce> all;
    for (const auto& [load_case, factor] : shares_of(model, shown))
        for (const femoop::NodeLoad& load : load_case.points) {
            auto sum = std::ranges::find(all, load.node, &PointForce::point);
            if (sum == all.end()) sum = all.insert(all.end(), {.point = load.node});
            for (const femoop::Component& part : load.components)
                sum->force[part.dof == femoop::Dof::ux ? 0 : 1] += factor * part.value;
        }
    return all;
}

} // namespace plane
