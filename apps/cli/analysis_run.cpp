#include "apps/cli/analysis_run.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <string>

#include "apps/cli/argument.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/io/json/json_writer.h"

namespace cli {

using femoop::Fault;
using femoop::FaultKind;

namespace {

/// What makes a structure unsolvable that is well described.
constexpr std::array structural{FaultKind::ConstraintConflict,     FaultKind::IllConditionedCase,
                                FaultKind::IllConditionedBody,     FaultKind::CrossJointFree,
                                FaultKind::CrossSwayUndetermined,  FaultKind::CrossHeldElongation,
                                FaultKind::CrossHeldSettlement,    FaultKind::NoSupport,
                                FaultKind::TooFewSupports,         FaultKind::PartWithoutSupport,
                                FaultKind::PartWithTooFewSupports, FaultKind::NothingHasMass,
                                FaultKind::MasslessMotion,         FaultKind::TooFewModes,
                                FaultKind::ModeLostInRounding,     FaultKind::IllConditionedLine};

std::string headline(std::size_t n, bool are_more, const ui::Catalogue& tr)
{
    if (n == 1) return tr("the structure is a mechanism, so it cannot be solved; it can move in one way:");
    if (!are_more)
        return tr("the structure is a mechanism, so it cannot be solved; it can move in {n} independent ways:",
                  {{"n", std::to_string(n)}});
    return tr("the structure is a mechanism, so it cannot be solved; it can move in at least {n} independent ways:",
              {{"n", std::to_string(n)}});
}

} // namespace

ExitStatus status_of(const std::vector<Fault>& faults)
{
    const bool is_structural = std::ranges::all_of(
        faults, [](const Fault& fault) { return std::ranges::find(structural, fault.kind) != structural.end(); });
    return is_structural ? ExitStatus::CannotSolve : ExitStatus::BadInput;
}

namespace {

/// A primary structure moves since forces were released: what mends a structure does not help, other redundants do.
bool is_of_redundants(const femoop::MechanismError& error)
{
    return std::ranges::any_of(error.causes(),
                               [](const Fault& cause) { return cause.kind == femoop::FaultKind::PrimaryMoves; });
}

void report_primary(const femoop::MechanismError& error, const std::string& file, const Console& console)
{
    for (const Fault& cause : error.causes()) {
        const std::string words = console.sentence(cause);
        console.message(file + ": " + words);
        if (words.find('[') != std::string::npos)
            console.message("  " + console.tr()("in brackets stands the node at which a member is cut"));
    }
    for (const femoop::Mechanism& mechanism : error.mechanisms())
        console.message("  " + femoop::without_remedy(console.sentence(mechanism.fault)));
}

} // namespace

void report_mechanisms(const femoop::MechanismError& error, const std::string& file, const Console& console)
{
    if (is_of_redundants(error)) return report_primary(error, file, console);
    const ui::Catalogue& tr = console.tr();
    const std::size_t n = error.mechanisms().size() + error.n_more();
    for (const Fault& cause : error.causes()) console.message(file + ": " + console.sentence(cause));
    console.message(file + ": " + headline(n, error.n_more() > 0, tr));
    for (const femoop::Mechanism& mechanism : error.mechanisms())
        console.message("  " + console.sentence(mechanism.fault));
    if (error.n_more() > 0)
        console.message("  " +
                        tr("and in at least {n} ways more; mend these first", {{"n", std::to_string(error.n_more())}}));
}

std::variant<Solved, ExitStatus> solve_model(const femoop::Model& model, const std::string& file,
                                             const femoop::AnalysisOptions& options, const Console& console)
{
    try {
        femoop::LinearStatic analysis(model, options);
        femoop::Results results = analysis.solve(model);
        return Solved{std::move(results), analysis.statistics()};
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, file, console);
    }
}

ExitStatus report_unsolved(const femoop::ModelError& error, const std::string& file, const Console& console)
{
    if (const auto* mechanism = dynamic_cast<const femoop::MechanismError*>(&error)) {
        report_mechanisms(*mechanism, file, console);
        return ExitStatus::CannotSolve;
    }
    console.report(file, error.faults());
    return status_of(error.faults());
}

femoop::SolverKind solver_named(const std::string& name, const ui::Catalogue& tr)
{
    if (const auto kind = femoop::solver_named(name)) return *kind;
    std::vector<std::string> names;
    for (const femoop::SolverKind kind : femoop::available_solvers()) names.emplace_back(femoop::name(kind));
    throw unknown_choice("--solver", name, names, tr);
}

std::string description_json(const std::string& sentences)
{
    femoop::JsonWriter json;
    json.begin_object().member("cremona", 1).member("description", sentences).end();
    return json.take();
}

} // namespace cli
