#include "apps/cli/plane_solve.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/plane_cycles.h"
#include "apps/cli/plane_input.h"
#include "apps/cli/plane_modes.h"
#include "apps/cli/plane_places.h"
#include "apps/plane/discretize/error_cycle.h"
#include "femoop/io/plane/element_trace_output.h"
#include "femoop/io/plane/modes_output.h"
#include "femoop/io/plane/plane_output.h"
#include "femoop/plane/analysis/natural_modes.h"
#include "femoop/plane/analysis/plane_analysis.h"

namespace cli {

namespace {

namespace fp = femoop::plane;

std::vector<femoop::CaseId> cases_named(const fp::PlaneModel& model, const std::string& name, const ui::Catalogue& tr)
{
    std::vector<femoop::CaseId> cases;
    if (const auto found = model.find_case(name)) return {*found};
    std::vector<std::string> names;
    for (std::size_t i = 0; i < model.n_cases(); ++i) {
        cases.emplace_back(i);
        names.push_back(model.case_name(femoop::CaseId(i)));
    }
    if (name == "all") return cases;
    throw unknown_choice("--case", name, names, tr);
}

/// The points of a drawing that are in material.
std::vector<fp::ShownPoint> points_of(const fp::PlaneModel& drawn, const discretize::MeshedDrawing& mesh,
                                      const fp::Locator& locator)
{
    std::vector<fp::ShownPoint> points;
    for (std::size_t i = 0; i < drawn.points.size(); ++i) {
        const fp::PlanePoint& point = drawn.points[i];
        fp::ShownPoint shown{.id = point.id, .node = mesh.node(femoop::NodeId(i)), .at = {point.at[0], point.at[1]}};
        if (shown.node || !locator.find(shown.at).empty()) points.push_back(std::move(shown));
    }
    return points;
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
    options.add_flag("--full", is_full_, tr("of a plane model: write the mesh into the JSON too"));
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
    if (!places_.empty() || !cuts_.empty() || is_full_)
        throw print_different_things("--cycles", !places_.empty() ? "--at" : !cuts_.empty() ? "--cut" : "--full", tr);
    constexpr auto most = static_cast<long>(discretize::ErrorCycle::most_cycles);
    return static_cast<std::size_t>(whole_number("--cycles", *cycles_, {1, most}, tr));
}

void PlaneSolve::require_modes_alone(const Question& question, const ui::Catalogue& tr) const
{
    const auto refuse = [&](bool is_given, std::string_view option) {
        if (is_given) throw print_different_things("--analysis modal", option, tr);
    };
    refuse(question.case_name != "all", "--case");
    refuse(question.traced_element.has_value(), "--trace");
    refuse(!places_.empty(), "--at");
    refuse(!cuts_.empty(), "--cut");
    refuse(cycles_.has_value(), "--cycles");
}

ExitStatus PlaneSolve::print_modes(const Question& question, const PlaneInput& input,
                                   const femoop::AnalysisOptions& options, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    std::optional<std::size_t> wanted;
    if (modes_) wanted = static_cast<std::size_t>(whole_number("--modes", *modes_, {1, most_modes}, tr));
    fp::ModesSelection selection{.is_full = is_full_};
    if (input.mesh() != nullptr)
        selection.points = points_of(question.reading.model, *input.mesh(), fp::Locator(input.model()));
    try {
        const fp::NaturalModes found = fp::natural_modes(input.model(), wanted, options);
        console.report(question.file, found.warnings);
        console.print(question.is_json ? fp::natural_modes_json(found, selection) : fp::natural_modes_text(found, tr));
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, question.file, console);
    }
    return ExitStatus::Done;
}

ExitStatus PlaneSolve::solve(const Question& question, const femoop::AnalysisOptions& options, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    auto& [reading, file, case_name, is_json, traced_element] = question;
    const PlaneInput input(reading);
    console.report(file, reading.faults);
    if (!reading.is_sound()) return ExitStatus::BadInput;
    const fp::PlaneModel& model = input.model();
    if (is_modal(tr)) {
        require_modes_alone(question, tr);
        return print_modes(question, input, options, console);
    }
    if (traced_element) {
        const fp::ElementTrace trace = fp::trace(model, element_named(*traced_element, model, tr));
        console.print(is_json ? fp::trace_json(trace, model.units) : fp::trace_text(trace, model.units, tr));
        return ExitStatus::Done;
    }
    if (cycles_) {
        if (input.mesh() == nullptr)
            throw UsageError(tr("--cycles: the file holds a mesh; only a drawing of curves can be meshed anew"));
        return print_cycles({.drawing = *input.drawing(),
                             .mesh = *input.mesh(),
                             .file = file,
                             .cases = cases_named(model, case_name, tr),
                             .n_cycles = n_cycles(tr),
                             .is_json = is_json},
                            options, console);
    }
    fp::PlaneSelection selection{
        .cases = cases_named(model, case_name, tr), .probes = {}, .cuts = {}, .is_full = is_full_};
    const fp::Locator locator(model);
    if (input.mesh() != nullptr) {
        selection.points = points_of(reading.model, *input.mesh(), locator);
        for (const discretize::RegionReport& report : input.mesh()->reports())
            selection.methods.push_back(report.method);
    }
    selection.probes = places_in(locator, places_, tr);
    selection.cuts = cuts_through(model, locator, cuts_, tr);
    try {
        const fp::PlaneResults results = fp::analyse(model, options);
        console.report(file, results.warnings());
        console.print(is_json ? fp::plane_results_json(results, selection)
                              : fp::plane_results_text(results, selection, tr));
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, file, console);
    }
    return ExitStatus::Done;
}

} // namespace cli
