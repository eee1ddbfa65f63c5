#include "apps/drawing/results/envelope_cases.h"

#include "ui/text/shortened.h"

namespace drawing {

namespace {

std::vector<femoop::CaseId> every_case(const femoop::Model& model)
{
    std::vector<femoop::CaseId> all;
    for (std::size_t i = 0; i < model.n_cases(); ++i) all.emplace_back(i);
    return all;
}

} // namespace

std::vector<femoop::CaseId> envelope_cases(const femoop::Model& model, const DrawOptions& options)
{
    std::vector<femoop::CaseId> chosen = every_case(model);
    std::erase_if(chosen, [&](femoop::CaseId id) { return options.left_out.contains(model.case_name(id)); });
    return chosen.empty() ? every_case(model) : chosen;
}

std::string governed(const std::string& number, const std::string& case_name)
{
    constexpr std::size_t longest_name = 28; // letters: a combination of a code with three actions
    return number + " (" + ui::shortened(case_name, longest_name) + ")";
}

std::string envelope_text(const femoop::Model& model, const DrawOptions& options)
{
    const std::vector<femoop::CaseId> chosen = envelope_cases(model, options);
    if (chosen.size() == model.n_cases()) return options.tr("Envelope of all cases");
    std::string names;
    for (const femoop::CaseId id : chosen) names += (names.empty() ? "" : ", ") + model.case_name(id);
    return options.tr("Envelope of {cases}", {{"cases", names}});
}

} // namespace drawing
