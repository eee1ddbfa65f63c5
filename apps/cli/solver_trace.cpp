#include "apps/cli/solver_trace.h"

#include <CLI/CLI.hpp>

#include "apps/cli/argument.h"

namespace cli {

using femoop::Ordering;
using femoop::SolverTrace;

void SolverTraceOptions::declare(CLI::App& app, const ui::Catalogue& tr)
{
    app.add_flag("--trace-solver", is_traced_,
                 tr("print how the system is eliminated instead of the results: the orders side by side with what they "
                    "cost, the fronts one after the other, and where L fills in"));
    app.add_option("--ordering", ordering_,
                   tr("with --trace-solver: whose fronts walk, natural, cuthill-mckee, minimum-degree or "
                      "nested-dissection (default: the solver's own order)"))
        ->option_text("NAME");
    app.add_option("--step", step_, tr("with --trace-solver: the front that is shown more closely, from 1"))
        ->option_text("N");
}

void SolverTraceOptions::require_trace(const ui::Catalogue& tr) const
{
    if (is_traced_) return;
    const auto refuse = [&](bool is_given, const char* option) {
        if (is_given) throw UsageError(tr("{option} goes with --trace-solver; add it", {{"option", option}}));
    };
    refuse(ordering_.has_value(), "--ordering");
    refuse(step_.has_value(), "--step");
}

femoop::SolverTraceRequest SolverTraceOptions::request(const SolverTrace& trace, const ui::Catalogue& tr) const
{
    femoop::SolverTraceRequest request;
    if (ordering_) {
        request.ordering = femoop::ordering_named(*ordering_);
        std::vector<std::string> names;
        for (const Ordering ordering : femoop::all_orderings) names.emplace_back(name(ordering));
        if (!request.ordering) throw unknown_choice("--ordering", *ordering_, names, tr);
    }
    if (!step_) return request;
    const auto n = static_cast<long>(trace.walk(request.ordering.value_or(usual_ordering(trace))).fronts.size());
    if (n == 0 || !trace.has_details())
        throw UsageError(tr("--step: no fronts are told of a system of {count} unknowns; leave the option out",
                            {{"count", std::to_string(trace.n_unknowns())}}));
    request.step = static_cast<std::size_t>(whole_number("--step", *step_, {1, n}, tr) - 1);
    return request;
}

std::string SolverTraceOptions::text(const femoop::Model& model, femoop::SolverKind wanted, bool is_json,
                                     const ui::Catalogue& tr) const
{
    const SolverTrace trace = femoop::trace_solver(model, wanted);
    const femoop::SolverTraceRequest asked = request(trace, tr);
    return is_json ? femoop::solver_trace_json(trace) : femoop::solver_trace_text(trace, asked, tr);
}

} // namespace cli
