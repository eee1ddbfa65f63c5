#include "apps/drawing/loads/case_terms.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using femoop::Dof;

// A checked model has no circles; the depth keeps the view of an unchecked one finite.
void add_terms(const femoop::Model& model, femoop::CaseId id, double factor, std::size_t depth,
               std::vector<CaseTerm>& terms)
{
    const std::size_t n_cases = model.load_cases.size();
    if (id.index < n_cases) {
        terms.push_back({&model.load_cases[id.index], factor, id.index});
        return;
    }
    if (id.index - n_cases >= model.combinations.size() || depth > model.combinations.size()) return;
    for (const auto& term : model.combinations[id.index - n_cases].terms)
        add_terms(model, term.of, factor * term.factor, depth + 1, terms);
}

void raise(double& largest, double value)
{
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
}

void add(LargestLoads& largest, const std::vector<femoop::Component>& components, double factor)
{
    for (const femoop::Component& c : components)
        if (!femoop::is_rotation(c.dof)) raise(largest.force, factor * c.value);
}

void add(LargestLoads& largest, const femoop::MemberLoad& load, double factor)
{
    if (const auto* line = std::get_if<femoop::DistributedLoad>(&load.load)) {
        for (const auto& value : line->values) {
            if (femoop::is_rotation(value.dof)) continue;
            raise(largest.per_length, factor * value.start);
            if (value.end) raise(largest.per_length, factor * *value.end);
        }
    } else if (const auto* point = std::get_if<femoop::PointLoad>(&load.load)) {
        add(largest, point->components, factor);
    } else if (const auto* ends = std::get_if<femoop::EndLoads>(&load.load)) {
        add(largest, ends->start, factor);
        add(largest, ends->end, factor);
    }
}

} // namespace

std::vector<CaseTerm> terms_of(const femoop::Model& model, femoop::CaseId id)
{
    std::vector<CaseTerm> terms;
    add_terms(model, id, 1.0, 0, terms);
    std::erase_if(terms, [](const CaseTerm& term) { return term.factor == 0.0; });
    return terms;
}

LargestLoads largest_loads(const std::vector<CaseTerm>& terms)
{
    LargestLoads largest;
    for (const CaseTerm& term : terms) {
        for (const auto& load : term.load_case->nodes) add(largest, load.components, term.factor);
        for (const auto& load : term.load_case->members) add(largest, load, term.factor);
    }
    return largest;
}

} // namespace drawing
