#include "apps/cli/plane_solve.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/asked_units.h"
#include "apps/cli/output_file.h"
#include "apps/cli/plane_cycles.h"
#include "apps/cli/plane_input.h"
#include "apps/cli/plane_modes.h"
#include "apps/cli/plane_places.h"
#include "apps/plane/discretize/error_cycle.h"
#include "apps/plane/view/plate_picture.h"
#include "apps/plane/view/plate_words.h"
#include "femoop/analysis/stopwatch.h"
#include "femoop/io/plane/element_trace_output.h"
#include "femoop/io/plane/modes_output.h"
#include "femoop/io/plane/plane_envelope_output.h"
#include "femoop/io/plane/plane_output.h"
#include "femoop/plane/analysis/natural_modes.h"
#include "femoop/plane/analysis/plane_analysis.h"

namespace cli {

namespace {

namespace fp = femoop::plane;

std::vector<femoop::CaseId> cases_named(const fp::PlaneModel& model, const std::optional<std::string>& name,
                                        const ui::Catalogue& tr)
{
    std::vector<femoop::CaseId> cases;
    if (const auto found = name ? model.find_case(*name) : std::nullopt) return {*found};
    std::vector<std::string> names;
    for (std::size_t i = 0; i < model.n_cases(); ++i) {
        cases.emplace_back(i);
        names.push_back(model.case_name(femoop::CaseId(i)));
    }
    if (!name || *name == "all" || *name == "envelope") return cases;
    throw unknown_choice("--case", *name, names, tr);
}

/// By its name, or by a place in it.
fp::ElementId element_named(const std::string& text, const fp::PlaneModel& mesh, const ui::Catalogue& tr)
{
    const auto found = std::ranges::find(mesh.elements, text, &fp::PlaneElement::id);
    if (found != mesh.elements.end()) return fp::ElementId(static_cast<std::size_t>(found - mesh.elements.begin()));
    if (text.find(',') != std::string::npos) {
        const std::vector<double> at = numbers_of("--trace", text, 2, tr);
        const std::vector<fp::Location> places = fp::Locator(mesh).find({at[0], at[1]});
        if (!places.empty()) return places.front().element;
    }
    throw UsageError(
        tr("--trace: found {found}; wanted an element, of this mesh {first} to {last}, or a place X,Y in one",
           {{"found", "\"" + text + "\""}, {"first", mesh.elements.front().id}, {"last", mesh.elements.back().id}}));
}

/// Recovers the stresses of every case once, as any reader of the results does.
double seconds_to_smooth(const fp::PlaneResults& results, const std::vector<femoop::CaseId>& cases)
{
    femoop::Stopwatch watch;
    const fp::PlaneElement& first = results.model().elements.front();
    for (const femoop::CaseId id : cases)
        static_cast<void>(results[id].smoothed_stress(first.points.front(), first.region));
    return watch.lap();
}

/// How words say numbers.
::plane::PlateOptions manner_of(const PlaneSolve::Question& question, const ui::Catalogue& tr)
{
    ::plane::PlateOptions options;
    options.tr = tr;
    options.numbers.mark = ui::decimal_mark(tr.language());
    options.unit_choices = question.units.choices(tr);
    return options;
}

/// The body once, then what each case does to it: what a picture of all of it would show.
std::string description(const PlaneSolve::Question& question, const PlaneInput& input, const fp::PlaneResults& results,
                        const fp::PlaneSelection& selection, const ui::Catalogue& tr)
{
    ::plane::PlateOptions options = manner_of(question, tr);
    options.probes = selection.probes;
    options.cuts = selection.cuts;
    return ::plane::cases_in_words({.model = question.reading.model,
                                    .drawing = input.drawing(),
                                    .mesh = input.mesh() != nullptr ? &input.model() : nullptr,
                                    .results = &results},
                                   options, selection.cases);
}

} // namespace

void PlaneSolve::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options
        .add_option("--at", places_,
                    tr("of a plane model: print displacement and stresses at this place too; may be given again"))
        .option_text("X,Y")
        .one_value_each();
    options
        .add_option("--cut", cuts_,
                    tr("of a plane model: print N, V and M on the cut from one place to another; may be given again"))
        .option_text("X1,Y1,X2,Y2")
        .one_value_each();
    options
        .add_option(
            "--cycles", cycles_,
            tr("of a drawn plane model: refine its mesh by the estimated error so many times, 1 to 8, each time to "
               "half of it, and print what each mesh has instead of the results"))
        .option_text("N");
    options
        .add_option("--analysis", analysis_,
                    tr("of a plane model: linear (default), or modal: how it vibrates by itself, loads aside"))
        .option_text("KIND");
    options.add_option("--modes", modes_, tr("with --analysis modal: how many natural modes, 1 to 1000 (default 10)"))
        .option_text("N");
    options.add_flag("--full", is_full_, tr("with --json, of a plane model: the mesh too"));
}

bool PlaneSolve::is_modal(const ui::Catalogue& tr) const
{
    const bool is_modal = asks_for_modes(analysis_, tr);
    if (modes_ && !is_modal) throw needs_too("--modes", "--analysis modal", tr);
    return is_modal;
}

void PlaneSolve::require_none(const ui::Catalogue& tr) const
{
    if (is_modal(tr)) throw modes_of_members(tr);
    if (!places_.empty() || !cuts_.empty() || is_full_ || cycles_)
        throw UsageError(tr("--at, --cut, --cycles and --full are for plane models; this is a structure of members"));
}

std::size_t PlaneSolve::n_cycles(const ui::Catalogue& tr) const
{
    constexpr auto most = static_cast<long>(discretize::ErrorCycle::most_cycles);
    return static_cast<std::size_t>(whole_number("--cycles", *cycles_, {1, most}, tr));
}

/// Of a model that has no case of that name.
bool PlaneSolve::asks_for_envelope(const Question& question)
{
    return question.case_name == "envelope" && !question.reading.model.find_case("envelope");
}

/// What would say nothing beside what is printed in place of the results.
void PlaneSolve::require_one_output(const Question& question, const ui::Catalogue& tr) const
{
    struct Given {
        std::string_view option;
        bool is_given;
    };
    const Given load_case{"--case", question.case_name.value_or("all") != "all"}, at{"--at", !places_.empty()},
        cut{"--cut", !cuts_.empty()}, full{"--full", is_full_}, time{"--time", question.is_timed},
        trace{"--trace", question.traced_element.has_value()}, cycles{"--cycles", cycles_.has_value()},
        csv{"--csv", question.csv_folder.has_value()}, description{"--describe", question.is_described},
        envelope{"--case envelope", asks_for_envelope(question)}, refinement{"--refine", question.is_refined};
    const auto refuse = [&](std::string_view output, std::initializer_list<Given> others) {
        for (const Given& other : others)
            if (other.is_given) throw print_different_things(output, other.option, tr);
    };
    if (is_modal(tr))
        refuse("--analysis modal", {load_case, trace, at, cut, cycles, description, csv, time, refinement});
    if (trace.is_given) refuse(trace.option, {at, cut, cycles, full, time, refinement});
    if (cycles.is_given) refuse(cycles.option, {envelope, at, cut, full, description, csv, time});
    if (description.is_given) refuse(description.option, {envelope, full});
    if (question.units.are_given() && (is_modal(tr) || trace.is_given || cycles.is_given))
        throw units_of_file(is_modal(tr) ? "--analysis modal" : trace.is_given ? trace.option : cycles.option, tr);
    if (is_full_ && !question.is_json) throw needs_too("--full", "--json", tr);
}

ExitStatus PlaneSolve::print_modes(const Question& question, const PlaneInput& input,
                                   const femoop::AnalysisOptions& options, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    std::optional<std::size_t> wanted;
    if (modes_) wanted = static_cast<std::size_t>(whole_number("--modes", *modes_, {1, most_modes}, tr));
    fp::ModesSelection selection{.is_full = is_full_};
    selection.points = input.points_in_material();
    try {
        const fp::NaturalModes found = fp::natural_modes(input.model(), wanted, options);
        console.report(question.file, found.warnings);
        console.print(question.is_json ? fp::natural_modes_json(found, selection) : fp::natural_modes_text(found, tr));
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, question.file, console);
    }
    return ExitStatus::Done;
}

void PlaneSolve::print_trace(const Question& question, const fp::PlaneModel& model, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const fp::ElementTrace trace = fp::trace(model, element_named(*question.traced_element, model, tr));
    console.print(question.is_json ? fp::trace_json(trace, model.units) : fp::trace_text(trace, model.units, tr));
}

fp::PlaneSelection PlaneSolve::selection(const Question& question, const PlaneInput& input,
                                         const ui::Catalogue& tr) const
{
    const fp::PlaneModel& model = input.model();
    fp::PlaneSelection selection{
        .cases = cases_named(model, question.case_name, tr), .probes = {}, .cuts = {}, .is_full = is_full_};
    const fp::Locator locator(model);
    selection.points = input.points_in_material();
    selection.methods = input.methods();
    selection.probes = places_in(locator, places_, tr);
    selection.cuts = cuts_through(model, locator, cuts_, tr);
    return selection;
}

std::string PlaneSolve::output(const Question& question, const PlaneInput& input, const fp::PlaneResults& results,
                               const fp::PlaneSelection& selection, const ui::Catalogue& tr) const
{
    const std::string without_case = selection.cases.empty() ? "\n" + tr("The model has no load case.") + "\n" : "";
    if (question.is_described) {
        const std::string text = description(question, input, results, selection, tr) + without_case;
        return question.is_json ? description_json(text) : text;
    }
    const bool is_envelope = asks_for_envelope(question) && !selection.cases.empty();
    if (question.is_json)
        return is_envelope ? fp::plane_envelope_json(results, selection) : fp::plane_results_json(results, selection);
    const fp::PlaneModel& model = results.model();
    const femoop::ResultUnits units = question.units.of_results(model, tr);
    std::string text = fp::plane_heading_text(results, tr);
    if (question.units.are_given())
        text += units_line({units.length, units.force, units.moment, units.displacement, units.stress}, tr);
    if (is_envelope) return text + fp::plane_envelope_text(results, selection, units, tr);
    return text + fp::plane_cases_text(results, selection, units, tr) + without_case;
}

ExitStatus PlaneSolve::print_results(const Question& question, const PlaneInput& input,
                                     const femoop::AnalysisOptions& options, PhaseTimes phases, Console& console) const
{
    const fp::PlaneSelection asked_for = selection(question, input, console.tr());
    try {
        const fp::PlaneResults results = fp::analyse(input.model(), options);
        console.report(question.file, results.warnings());
        if (question.is_timed) phases.recover = seconds_to_smooth(results, asked_for.cases);
        femoop::Stopwatch watch;
        console.print(output(question, input, results, asked_for, console.tr()));
        if (input.drawing() != nullptr && !question.is_described && !asked_for.cases.empty())
            tell_singular_corners(*input.drawing(), question.file, manner_of(question, console.tr()), console);
        if (question.csv_folder)
            write_tables(*question.csv_folder,
                         asks_for_envelope(question) && !asked_for.cases.empty()
                             ? fp::plane_envelope_csv(results, asked_for)
                             : fp::plane_results_csv(results, asked_for),
                         console);
        if (!question.is_timed) return ExitStatus::Done;
        console.flush();
        phases.write = watch.lap();
        report_time(phases, results.statistics(), console);
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, question.file, console);
    }
    return ExitStatus::Done;
}

ExitStatus PlaneSolve::solve(const Question& question, const femoop::AnalysisOptions& options, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    require_one_output(question, tr);
    femoop::Stopwatch watch;
    const PlaneInput input(question.reading);
    PhaseTimes phases{.read = question.seconds_to_read, .has_refinement = question.is_refined};
    if (input.drawing() != nullptr) phases.mesh = watch.lap();
    console.report(question.file, question.reading.faults);
    if (!question.reading.is_sound()) return ExitStatus::BadInput;
    if (is_modal(tr)) return print_modes(question, input, options, console);
    if (question.traced_element) {
        print_trace(question, input.model(), console);
        return ExitStatus::Done;
    }
    if (!cycles_) return print_results(question, input, options, phases, console);
    if (input.mesh() == nullptr)
        throw UsageError(tr("--cycles: the file holds a mesh; only a drawing of curves can be meshed anew"));
    if (input.model().n_cases() == 0)
        throw UsageError(tr("--cycles: the error is that of a load case, and the model has none; add one"));
    return print_cycles({.drawing = *input.drawing(),
                         .mesh = *input.mesh(),
                         .file = question.file,
                         .cases = cases_named(input.model(), question.case_name, tr),
                         .n_cycles = n_cycles(tr),
                         .is_json = question.is_json},
                        options, console);
}

} // namespace cli
