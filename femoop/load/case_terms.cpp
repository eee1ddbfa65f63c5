#include "femoop/load/case_terms.h"

#include <utility>

namespace femoop {

namespace {

/// The factor of every load case in combinations, each expanded once.
class Expansion {
public:
    explicit Expansion(const Model& model) : model_(model), factors_(model.combinations.size()) {}

    CaseTerms terms(CaseId id)
    {
        if (id.index >= model_.n_cases()) return {};
        if (id.index < model_.load_cases.size())
            return {.name = model_.load_cases[id.index].id, .terms = {{.load_case = id.index, .factor = 1.0}}};
        const std::size_t combination = id.index - model_.load_cases.size();
        CaseTerms found{.name = model_.combinations[combination].id, .terms = {}};
        const std::vector<double>& factors = expanded(combination);
        for (std::size_t i = 0; i < model_.load_cases.size(); ++i)
            if (factors[i] != 0.0) found.terms.push_back({.load_case = i, .factor = factors[i]});
        return found;
    }

private:
    /// A combination may name others, also later ones.
    const std::vector<double>& expanded(std::size_t combination)
    {
        if (!factors_[combination].empty()) return factors_[combination];
        const std::size_t n = model_.load_cases.size();
        std::vector<double> sum(n + 1, 0.0); // one more, so that an expanded one is never empty
        factors_[combination] = sum;         // what leads back to it in a circle adds nothing
        for (const Combination::Term& term : model_.combinations[combination].terms) {
            if (term.of.index < n) {
                sum[term.of.index] += term.factor;
                continue;
            }
            if (term.of.index >= model_.n_cases()) continue;
            const std::vector<double>& other = expanded(term.of.index - n);
            for (std::size_t i = 0; i < n; ++i) sum[i] += term.factor * other[i];
        }
        return factors_[combination] = std::move(sum);
    }

    const Model& model_;
    std::vector<std::vector<double>> factors_;
};

} // namespace

CaseTerms terms_of(const Model& model, CaseId id) { return Expansion(model).terms(id); }

std::vector<CaseTerms> cases_of(const Model& model)
{
    Expansion expansion(model);
    std::vector<CaseTerms> cases;
    for (std::size_t i = 0; i < model.load_cases.size() + model.combinations.size(); ++i)
        cases.push_back(expansion.terms(CaseId(i)));
    return cases;
}

} // namespace femoop
