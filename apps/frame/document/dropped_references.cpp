#include "apps/frame/document/dropped_references.h"

#include <algorithm>
#include <string>

#include "ui/text/catalogue.h"

namespace frame {

using femoop::Combination;
using femoop::Model;
using ui::translatable;

namespace {

void list(std::string& names, const std::string& name) { names += names.empty() ? name : ", " + name; }

std::optional<ui::Message> lost_terms(const Model& before, const Model& after)
{
    std::string poorer, cases;
    for (const Combination& combination : before.combinations) {
        const auto now = std::ranges::find(after.combinations, combination.id, &Combination::id);
        if (now != after.combinations.end() && now->terms.size() < combination.terms.size())
            list(poorer, combination.id);
    }
    for (std::size_t i = 0; i < before.n_cases(); ++i)
        if (const std::string& name = before.case_name(femoop::CaseId(i)); !after.find_case(name)) list(cases, name);
    if (poorer.empty() || cases.empty()) return std::nullopt;
    return ui::Message(translatable("{cases} went out of the combinations {combinations} too; undo brings it back."),
                       {{"cases", cases}, {"combinations", poorer}});
}

std::optional<ui::Message> lost_checks(const Model& before, const Model& after)
{
    if (after.expected.size() >= before.expected.size()) return std::nullopt;
    return ui::Message(
        translatable("Results that the file has to check the model by were deleted with the parts they belong to: "
                     "{count}. Undo brings them back."),
        {{"count", std::to_string(before.expected.size() - after.expected.size())}});
}

} // namespace

std::optional<ui::Message> dropped_references(const Model& before, const Model& after)
{
    const std::optional<ui::Message> terms = lost_terms(before, after), checks = lost_checks(before, after);
    if (terms && checks) return ui::Message("{terms} {checks}", {{"terms", *terms}, {"checks", *checks}});
    return terms ? terms : checks;
}

} // namespace frame
