#include <algorithm>

#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/name_column.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::translatable;

namespace {

LoadCase& load_case_at(Model& model, const Part& part)
{
    return model.load_cases[std::get<LoadCasePlace>(part).load_case];
}
const LoadCase& load_case_at(const Model& model, const Part& part)
{
    return model.load_cases[std::get<LoadCasePlace>(part).load_case];
}

Combination& combination_at(Model& model, const Part& part)
{
    return model.combinations[std::get<CombinationPlace>(part).combination];
}
const Combination& combination_at(const Model& model, const Part& part)
{
    return model.combinations[std::get<CombinationPlace>(part).combination];
}

/// The name of a load case or combination: both share one set of names.
template <class Find> Column case_name_column(std::string_view heading, Find find)
{
    Column column{.heading = heading, .read = {}};
    column.read = [find](const Model& model, const Part& part) -> CellValue { return find(model, part).id; };
    column.write = [find](Document& document, const Part& part, const CellText& entry) -> Refusal {
        if (entry.text.empty()) return value_needed(entry.manner);
        find(document.model, part).id = std::string(entry.text);
        return std::nullopt;
    };
    return column;
}

// Empty means none.
Column self_weight_column()
{
    return number_column(translatable("Self-weight ×"), Measure::Plain,
                         {.get = [](const Model& model, const Part& part) -> std::optional<Quantity> {
                              return Quantity(load_case_at(model, part).self_weight);
                          },
                          .set = [](Document& document, const Part& part, const std::optional<Quantity>& value,
                                    const Manner&) -> Refusal {
                              load_case_at(document.model, part).self_weight = value ? value->value() : 0.0;
                              return std::nullopt;
                          }});
}

Column n_loads_column()
{
    Column column{.heading = translatable("Number of loads"), .is_number = true, .read = {}};
    column.read = [](const Model& model, const Part& part) -> CellValue {
        const LoadCase& load_case = load_case_at(model, part);
        const std::size_t n = load_case.nodes.size() + load_case.members.size() + load_case.settlements.size();
        return Quantity(static_cast<double>(n));
    };
    return column;
}

Column factor_column(const Model& model, CaseId of)
{
    return number_column(ui::Message("{case} ×", {{"case", model.case_name(of)}}), Measure::Plain,
                         {.get = [of](const Model& m, const Part& part) -> std::optional<Quantity> {
                              const auto& terms = combination_at(m, part).terms;
                              const auto found = std::ranges::find(terms, of, &Combination::Term::of);
                              return found != terms.end() ? std::optional(Quantity(found->factor)) : std::nullopt;
                          },
                          .set = [of](Document& document, const Part& part, const std::optional<Quantity>& value,
                                      const Manner&) -> Refusal {
                              auto& terms = combination_at(document.model, part).terms;
                              const auto found = std::ranges::find(terms, of, &Combination::Term::of);
                              if (!value) std::erase_if(terms, [of](const auto& term) { return term.of == of; });
                              else if (found != terms.end()) found->factor = value->value();
                              else terms.push_back({of, value->value()});
                              return std::nullopt;
                          }});
}

bool is_combined(const Model& model, CaseId id)
{
    const auto has_it = [id](const Combination& combination) {
        return std::ranges::find(combination.terms, id, &Combination::Term::of) != combination.terms.end();
    };
    return std::ranges::any_of(model.combinations, has_it);
}

} // namespace

std::vector<Column> load_case_columns()
{
    const auto find = [](auto& model, const Part& part) -> auto& { return load_case_at(model, part); };
    return {case_name_column(translatable("Load case"), find), self_weight_column(), n_loads_column()};
}

// A combination of combinations is rare: these have columns only where one is in use.
std::vector<Column> combination_columns(const Model& model)
{
    const auto find = [](auto& m, const Part& part) -> auto& { return combination_at(m, part); };
    std::vector<Column> all{case_name_column(translatable("Combination"), find)};
    for (std::size_t i = 0; i < model.n_cases(); ++i)
        if (i < model.load_cases.size() || is_combined(model, CaseId(i)))
            all.push_back(factor_column(model, CaseId(i)));
    return all;
}

} // namespace frame
