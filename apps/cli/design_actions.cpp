#include "apps/cli/design_actions.h"

#include <algorithm>
#include <vector>

#include "apps/cli/argument.h"
#include "femoop/load/design_code.h"

namespace cli {

namespace {

using femoop::CaseAction;
using femoop::DesignCode;

DesignCode code_named(const std::string& typed, const ui::Catalogue& tr)
{
    if (const auto code = femoop::design_code(typed)) return *code;
    std::vector<std::string> ids;
    for (const DesignCode code : femoop::design_codes()) ids.emplace_back(id(code));
    throw unknown_choice("--combinations", typed, ids, tr);
}

const femoop::ActionKind& kind_named(DesignCode code, const std::string& typed, const ui::Catalogue& tr)
{
    if (const femoop::ActionKind* const kind = find_action(code, typed)) return *kind;
    std::vector<std::string> ids;
    for (const femoop::ActionKind& kind : action_kinds(code)) ids.emplace_back(kind.id);
    throw unknown_choice("--actions", typed, ids, tr);
}

femoop::CaseId load_case_named(const femoop::Model& model, const std::string& typed, const ui::Catalogue& tr)
{
    const auto found = model.find_case(typed);
    if (found && found->index < model.load_cases.size()) return *found;
    throw unknown_choice("--actions", typed, ids_of(model.load_cases), tr);
}

std::vector<CaseAction> actions_of(const femoop::Model& model, DesignCode code, const std::string& typed,
                                   const ui::Catalogue& tr)
{
    std::vector<CaseAction> actions;
    for (const std::string& part : comma_list(typed)) {
        const std::size_t equals = part.rfind('=');
        if (equals == std::string::npos)
            throw UsageError(tr("--actions: found {found}; wanted a load case and its action, such as G=permanent",
                                {{"found", part}}));
        const femoop::CaseId load_case = load_case_named(model, part.substr(0, equals), tr);
        if (std::ranges::find(actions, load_case, &CaseAction::load_case) != actions.end())
            throw UsageError(tr("--actions: {case} is named twice; give each load case one action",
                                {{"case", model.case_name(load_case)}}));
        actions.push_back({load_case, &kind_named(code, part.substr(equals + 1), tr)});
    }
    return actions;
}

std::string meaning(const femoop::Model& model, DesignCode code, const femoop::DesignCombination& one,
                    const ui::Catalogue& tr)
{
    std::string text = std::string(name(code)) + ", " + std::string(one.clause);
    if (one.leading) text += tr(", {case} leads", {{"case", model.case_name(*one.leading)}});
    return text;
}

} // namespace

void add_design_combinations(femoop::Model& model, const DesignActions& typed, Console& console)
{
    const ui::Catalogue& tr = console.tr();
    const DesignCode code = code_named(typed.code, tr);
    const std::vector<CaseAction> actions = actions_of(model, code, typed.actions, tr);
    if (are_too_many_combinations(code, actions, limit_states(code)))
        throw UsageError(tr("--actions: more than {most} combinations may come of so many alternatives; leave cases "
                            "out, and combine them in several runs",
                            {{"most", std::to_string(femoop::most_design_combinations)}}));
    const auto combinations = design_combinations(code, actions, limit_states(code));
    for (const femoop::DesignCombination& one : combinations) {
        const std::string name = combination_name(code, model, one, tr);
        console.message(name + ": " +
                        (model.find_case(name) ? tr("the file has one of this name, which stays as it is")
                                               : meaning(model, code, one, tr)));
    }
    add_combinations(code, model, combinations, tr);
}

} // namespace cli
