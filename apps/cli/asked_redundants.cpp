#include "apps/cli/asked_redundants.h"

#include <algorithm>

#include "apps/cli/asked_effect.h"
#include "apps/cli/asked_units.h"
#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/force_method/force_method_text.h"
#include "femoop/methods/force_method/force_method.h"
#include "femoop/methods/force_method/force_steps.h"

namespace cli {

namespace {

constexpr const char* option = "--force-method";
constexpr const char* automatic = "automatic";

} // namespace

void AskedRedundants::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options
        .add_option(
            option, what_,
            tr("solve by the force method, instead of printing the results: the redundant to release, "
               "node=N,component=fy or member=M,at=X,component=M, once for each; or automatic: the program chooses as "
               "many as the degree of indeterminacy; of the first load case, or that of --case"))
        .option_text("WHAT|automatic")
        .one_value_each();
}

void AskedRedundants::count_lengths_in(std::string_view unit)
{
    for (std::string& one : what_) one = with_unit(one, unit, "at=");
}

std::vector<femoop::MovingEffect> AskedRedundants::redundants(const femoop::Model& model, const ui::Catalogue& tr) const
{
    std::vector<femoop::MovingEffect> all;
    if (what_ == std::vector<std::string>{automatic}) return all;
    for (const std::string& one : what_) {
        if (one == automatic)
            throw UsageError(
                tr("{option}: automatic chooses every redundant; name none beside it", {{"option", option}}));
        AskedEffect asked;
        asked.set(option, one, tr, AskedEffect::Takes::Forces);
        asked.require_sensible(tr);
        all.push_back(asked.sound_effect(model, tr));
    }
    std::string refused;
    for (const femoop::Fault& fault : femoop::force_method::check_redundants(model, all, option))
        refused += (refused.empty() ? "" : "\n") + femoop::message(fault, tr);
    if (!refused.empty()) throw UsageError(refused);
    return all;
}

std::string AskedRedundants::output(const femoop::Model& model, const femoop::Results& results,
                                    femoop::CaseId load_case, StepFormat format, const ui::Catalogue& tr) const
{
    const auto method = femoop::force_method::solve(model, results, load_case, redundants(model, tr));
    switch (format) {
    case StepFormat::Json: return force_method_json(method, model, tr);
    case StepFormat::Latex: return derivation_latex(femoop::force_method::steps(method, model), model, tr);
    case StepFormat::Text: break;
    }
    return force_method_text(method, model, tr);
}

} // namespace cli
