#include "femoop/load/case_terms.h"

#include <utility>

namespace femoop {

namespace {

/// The factor of every load case in combinations, each expanded once.
class Expansion {
public:
    Expansion(std::vector<std::string_view> load_cases, const std::vector<Combination>& combinations)
        : load_cases_(std::move(load_cases)), combinations_(combinations), factors_(combinations.size())
    {}

    std::size_t n_cases() const { return load_cases_.size() + combinations_.size(); }

    CaseTerms terms(CaseId id)
    {
        if (id.index >= n_cases()) return {};
        if (id.index < load_cases_.size())
            return {.name = std::string(load_cases_[id.index]), .terms = {{.load_case = id.index, .factor = 1.0}}};
        const std::size_t combination = id.index - load_cases_.size();
        CaseTerms found{.name = combinations_[combination].id, .terms = {}};
        const std::vector<double>& factors = expanded(combination);
        for (std::size_t i = 0; i < load_cases_.size(); ++i)
            if (factors[i] != 0.0) found.terms.push_back({.load_case = i, .factor = factors[i]});
        return found;
    }

private:
    /// A combination may name others, also later ones.
    const std::vector<double>& expanded(std::size_t combination)
    {
        if (!factors_[combination].empty()) return factors_[combination];
        const std::size_t n = load_cases_.size();
        std::vector<double> sum(n + 1, 0.0); // one more, so that an expanded one is never empty
        factors_[combination] = sum;         // what leads back to it in a circle adds nothing
        for (const Combination::Term& term : combinations_[combination].terms) {
            if (term.of.index < n) {
                sum[term.of.index] += term.factor;
                continue;
            }
            if (term.of.index >= n_cases()) continue;
            const std::vector<double>& other = expanded(term.of.index - n);
            for (std::size_t i = 0; i < n; ++i) sum[i] += term.factor * other[i];
        }
        return factors_[combination] = std::move(sum);
    }

    std::vector<std::string_view> load_cases_;
    const std::vector<Combination>& combinations_;
    std::vector<std::vector<double>> factors_;
};

} // namespace

namespace {

std::vector<std::string_view> names_of_load_cases(const Model& model)
{
    std::vector<std::string_view> names;
    for (const LoadCase& load_case : model.load_cases) names.push_back(load_case.id);
    return names;
}

} // namespace

CaseTerms terms_of(const Model& model, CaseId id)
{
    return Expansion(names_of_load_cases(model), model.combinations).terms(id);
}

std::vector<CaseTerms> cases_of(const Model& model) { return cases_of(names_of_load_cases(model), model.combinations); }

std::vector<CaseTerms> cases_of(const std::vector<std::string_view>& load_cases,
                                const std::vector<Combination>& combinations)
{
    Expansion expansion(load_cases, combinations);
    std::vector<CaseTerms> cases;
    for (std::size_t i = 0; i < expansion.n_cases(); ++i) cases.push_back(expansion.terms(CaseId(i)));
    return cases;
}

} // namespace femoop
