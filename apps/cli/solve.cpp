#include "apps/cli/solve.h"

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/asked_body.h"
#include "apps/cli/asked_effect.h"
#include "apps/cli/asked_funicular.h"
#include "apps/cli/asked_redundants.h"
#include "apps/cli/asked_units.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_file.h"
#include "apps/cli/phase_times.h"
#include "apps/cli/plane_solve.h"
#include "apps/cli/solver_trace.h"
#include "femoop/analysis/stopwatch.h"
#include "femoop/analysis/trace.h"
#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/results/results_csv.h"
#include "femoop/io/results/results_json.h"
#include "femoop/io/results/results_table.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "femoop/methods/derivation/derivation.h"
#include "femoop/methods/virtual_work/virtual_work.h"
#include "femoop/plane/model/plane_model.h"
#include "femoop/result/describe.h"

namespace cli {

namespace {

using femoop::CaseId;
using femoop::Model;
using femoop::Results;

/// What is printed of which cases.
struct Selection {
    std::vector<CaseId> cases;
    bool is_envelope = false;
    std::size_t n_stations = femoop::usual_n_stations;
};

class Solve : public Subcommand {
public:
    std::string_view name() const override { return "solve"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    Selection selection(const Model& model, const ui::Catalogue& tr) const;
    std::string output(const Model& model, const Results& results, const Selection& selection,
                       const ui::Catalogue& tr) const;
    std::string tables(const Model& model, const Results& results, const Selection& selection,
                       const ui::Catalogue& tr) const;
    std::string description(const Model& model, const Results& results, const Selection& selection,
                            const ui::Catalogue& tr) const;
    void require_one_output(const ui::Catalogue& tr) const;
    void require_no_envelope(const Model& model, const ui::Catalogue& tr) const;
    std::optional<std::string_view> calculation() const;
    std::optional<std::string_view> of_members_alone() const;
    void count_in_chosen_units(Model& model, const ui::Catalogue& tr);
    std::string trace(const Model& model, const ui::Catalogue& tr) const;
    ExitStatus solve_plane(femoop::plane::PlaneReading& reading, const femoop::AnalysisOptions& options,
                           double seconds_to_read, Console& console) const;
    bool is_of_all_cases(const Model& model) const;
    bool is_of_envelope(const Model& model) const;
    CaseId followed_case(const Model& model, const ui::Catalogue& tr) const;
    femoop::derivation::Derivation derived(const Model& model, const Results& results,
                                           const femoop::MovingEffect& effect, const ui::Catalogue& tr) const;
    std::string derivation(const Model& model, const Results& results, const ui::Catalogue& tr) const;
    std::string virtual_work(const Model& model, const Results& results, const ui::Catalogue& tr) const;
    femoop::virtual_work::VirtualWork worked_out(const Model& model, const Results& results,
                                                 const femoop::MovingEffect& displacement,
                                                 const ui::Catalogue& tr) const;
    void write_csv(const Model& model, const Results& results, const Selection& selection,
                   const Console& console) const;

    std::string file_, stations_ = std::to_string(femoop::usual_n_stations), solver_ = "automatic";
    std::optional<std::string> case_, csv_folder_, traced_member_, asked_number_, kept_case_, worked_displacement_;
    bool is_json_ = false, is_latex_ = false, is_timed_ = false, is_refined_ = false, is_described_ = false;
    SolverTraceOptions solver_trace_;
    AskedBody body_;
    AskedFunicular funicular_;
    PlaneSolve plane_;
    AskedRedundants redundants_;
    AskedUnits units_;
};

HelpText Solve::help(const ui::Catalogue& tr) const
{
    return {
        tr("analyse a structure and print what happens to it"),
        tr("Reads a model file, solves every load case and combination, and prints tables: displacements of the nodes, "
           "reactions, section forces at the ends of the members, their extremes with the exact places, the sums "
           "of loads and reactions, and the degree of static indeterminacy. Values along members are closed forms, "
           "never sampled. A structure that can move is not solved: every way in which it moves is told in words."),
        {{"cremona solve examples/portal.json", tr("Tables of every load case and combination.")},
         {"cremona solve examples/portal.json --case envelope",
          tr("The largest and smallest of every result, with the case that governs.")},
         {"cremona solve examples/portal.json --unit moment=kN*cm,displacement=mm",
          tr("Tables with moments in kN·cm and displacements in mm.")},
         {"cremona solve examples/portal.json --json --stations 11",
          tr("The same numbers for a program: 11 stations along each member, and every load point.")},
         {"cremona solve examples/portal.json --csv results",
          tr("Five files for a spreadsheet in the folder results.")},
         {"cremona solve examples/portal.json --trace BC",
          tr("How member BC enters the system: its stiffness, its rotation, its fixed-end forces, its places.")},
         {"cremona solve examples/portal.json --why member=BC,at=50%,component=M",
          tr("Where this moment comes from, step by step from the data: matrices, equations, end forces.")},
         {"cremona solve examples/portal.json --why node=A,component=fx --latex > why.tex",
          tr("The same steps for a reaction, for a LaTeX document.")},
         {"cremona solve examples/portal.json --virtual-work node=C,component=ux",
          tr("The sway as the work of a unit load's forces on the strains: integrals of M m / EI and their sum.")},
         {"cremona solve examples/portal.json --force-method automatic",
          tr("The force method: redundants, primary structure, its states, the gaps by virtual work, equations, sum.")},
         {"cremona solve examples/portal.json --force-method member=BC,at=50%,component=M",
          tr("The same with one redundant, the moment at midspan: a hinge, whose rotation it closes.")},
         {"cremona solve examples/portal.json --free-body cut=BC@2,beside=A --about 0,4.5",
          tr("The forces on the part left of a cut, and its equations of equilibrium.")},
         {"cremona solve examples/three_hinged_arch.json --funicular automatic",
          tr("The line of thrust of an arch, from the moments of the simple beam.")},
         {"cremona solve examples/dam.json --analysis modal --modes 6",
          tr("How a body vibrates by itself: frequencies, and the mass that each mode moves.")},
         {"cremona solve examples/storey_frame.json --trace-solver",
          tr("Which solver and which order are chosen, and how the front walks over the structure.")},
         {"cremona solve examples/portal.json --describe",
          tr("The structure and its results in sentences, for a screen reader.")},
         {"cremona solve - < examples/portal.json", tr("Reads the model from standard input.")}}};
}

void Solve::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", file_, tr("the model file; - is standard input")).option_text(" ");
    options
        .add_option("--case", case_,
                    tr("what to print: one load case or combination, all (default), or envelope: "
                       "the largest and smallest of all, with the case that governs"))
        .option_text("ID|all|envelope");
    options.add_flag("--json", is_json_, tr("print JSON with every digit instead of tables"));
    options.add_flag(
        "--latex", is_latex_,
        tr("with --why, --virtual-work, --force-method, --free-body or --funicular: print the body of a LaTeX document "
           "instead of text, its matrices by the package amsmath"));
    options
        .add_option("--stations", stations_,
                    tr("how many evenly spaced places along each member JSON and CSV have (default 21); "
                       "load points are always there too, and a jump gives two"))
        .option_text("N");
    options
        .add_option("--csv", csv_folder_,
                    tr("write the results as CSV files into this folder too; it is made if missing"))
        .option_text("DIR");
    options
        .add_option("--solver", solver_,
                    tr("who solves K u = f: automatic (the fastest, default), skyline, multifrontal, ldlt or cholmod"))
        .option_text("NAME");
    options.add_flag(
        "--refine", is_refined_,
        tr("correct the displacements by their own residuals until rounding is left; --time tells how good they are"));
    options.add_flag("--time", is_timed_, tr("print to stderr how long each phase took, and the size of the system"));
    options
        .add_option(
            "--trace", traced_member_,
            tr("print how this member enters the system instead of the results: stiffness in "
               "its own axes and in those of the nodes, transformation, fixed-end forces, places in the system matrix; "
               "of a plane model an element, by its name or by a place X,Y in it: D, of each integration point N, J and "
               "B, stiffness, nodal forces of its loads, places"))
        .option_text("MEMBER");
    options
        .add_option(
            "--why", asked_number_,
            tr("print where one number comes from, instead of the results: every step from the data to it. "
               "member=M,at=X,component=C asks for a section force or a displacement of a member (without at: its "
               "extreme), node=N,component=C for a reaction (fx .., in the plane also R, its size) or a displacement "
               "(ux ..); of the first load case, or that of --case, of an envelope the one that governs"))
        .option_text("WHAT");
    options
        .add_option("--less", kept_case_,
                    tr("with --why: the same number of this load case is taken off, and both are followed"))
        .option_text("ID");
    options
        .add_option(
            "--virtual-work", worked_displacement_,
            tr("print one displacement as virtual work, instead of the results: the forces of a unit load times "
               "the strains, integrated along each member. node=N,component=ux or member=M,at=X,component=v; of "
               "the first load case, or that of --case"))
        .option_text("WHAT");
    units_.declare(options, tr);
    redundants_.declare(options, tr);
    body_.declare(options, tr);
    funicular_.declare(options, tr);
    plane_.declare(options, tr);
    solver_trace_.declare(options, tr);
    options.add_flag("--describe", is_described_,
                     tr("print sentences instead of tables: for a screen reader, or beside a picture"));
}

// A case that bears the name of a keyword is still reached.
bool Solve::is_of_all_cases(const Model& model) const { return !case_ || (*case_ == "all" && !model.find_case("all")); }
bool Solve::is_of_envelope(const Model& model) const { return case_ == "envelope" && !model.find_case("envelope"); }

Selection Solve::selection(const Model& model, const ui::Catalogue& tr) const
{
    Selection selection;
    selection.n_stations = static_cast<std::size_t>(whole_number("--stations", stations_, {2, 100000}, tr));
    if (is_of_all_cases(model)) {
        selection.cases = all_cases(model);
    } else if (is_of_envelope(model)) {
        selection.cases = all_cases(model);
        selection.is_envelope = true;
        if (selection.cases.empty())
            throw UsageError(tr("--case: an envelope needs at least one load case, and the model has none"));
    } else {
        selection.cases = {find_case(model, *case_, tr)};
    }
    return selection;
}

std::string Solve::tables(const Model& model, const Results& results, const Selection& selection,
                          const ui::Catalogue& tr) const
{
    std::string text = femoop::heading_text(model, results, tr);
    const femoop::ResultUnits units = units_.of_results(model, tr);
    if (units_.are_given())
        text += units_line({units.length, units.force, units.moment, units.displacement, units.rotation}, tr);
    if (selection.cases.empty()) return text + "\n" + tr("The model has no load case.") + "\n";
    if (selection.is_envelope) return text + femoop::envelope_text(model, results, selection.cases, units, tr);
    for (const CaseId id : selection.cases) text += femoop::case_text(model, results, id, units, tr);
    return text;
}

/// Options that would print in place of one another.
void Solve::require_one_output(const ui::Catalogue& tr) const
{
    const auto refuse = [&](bool are_both, std::string_view a, std::string_view b) {
        if (are_both) throw print_different_things(a, b, tr);
    };
    struct Output {
        bool is_given;
        std::string_view option;
        bool is_of_a_case, has_csv;
    };
    const std::array outputs{Output{solver_trace_.are_given(), "--trace-solver", false, false},
                             Output{traced_member_.has_value(), "--trace", false, false},
                             Output{asked_number_.has_value(), "--why", true, false},
                             Output{worked_displacement_.has_value(), "--virtual-work", true, false},
                             Output{redundants_.are_asked(), "--force-method", true, false},
                             Output{body_.is_asked(), "--free-body", true, false},
                             Output{funicular_.is_asked(), "--funicular", true, false},
                             Output{is_described_, "--describe", true, true}};
    refuse(is_json_ && is_latex_, "--json", "--latex");
    const bool is_explained = asked_number_ || worked_displacement_ || redundants_.are_asked() || body_.is_asked() ||
                              funicular_.is_asked();
    if (kept_case_ && !asked_number_) throw needs_too("--less", "--why", tr);
    if (is_latex_ && !is_explained)
        throw UsageError(
            tr("{a} needs one of {list} too; add it",
               {{"a", "--latex"}, {"list", "--why, --virtual-work, --force-method, --free-body, --funicular"}}));
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto& [is_given, option, is_of_a_case, has_csv] = outputs[i];
        for (std::size_t j = i + 1; j < outputs.size(); ++j)
            refuse(is_given && outputs[j].is_given, option, outputs[j].option);
        refuse(is_given && !is_of_a_case && case_.value_or("all") != "all", option, "--case");
        refuse(is_given && !has_csv && csv_folder_, option, "--csv");
    }
    if (solver_trace_.are_given() && units_.are_given()) throw units_of_file("--trace-solver", tr);
    if (is_json_ && units_.are_given()) throw units_of_file("--json", tr);
    if (csv_folder_ && units_.are_given()) throw units_of_file("--csv", tr);
}

/// What is of one case is of none of an envelope, unless that is a case's name; --why follows the case that governs.
void Solve::require_no_envelope(const Model& model, const ui::Catalogue& tr) const
{
    if (!is_of_envelope(model)) return;
    const auto refuse = [&](bool is_given, std::string_view option) {
        if (is_given) throw print_different_things(option, "--case envelope", tr);
    };
    refuse(kept_case_.has_value(), "--less");
    refuse(worked_displacement_.has_value(), "--virtual-work");
    refuse(redundants_.are_asked(), "--force-method");
    refuse(body_.is_asked(), "--free-body");
    refuse(funicular_.is_asked(), "--funicular");
    refuse(is_described_, "--describe");
}

std::string Solve::description(const Model& model, const Results& results, const Selection& selection,
                               const ui::Catalogue& tr) const
{
    const std::string text = femoop::describe(model, results, selection.cases, tr);
    return is_json_ ? description_json(text) : text;
}

std::string Solve::trace(const Model& model, const ui::Catalogue& tr) const
{
    const femoop::MemberTrace trace = femoop::trace(model, member_named("--trace", *traced_member_, model, tr));
    return is_json_ ? femoop::trace_json(trace, model.units) : femoop::trace_text(trace, model.units, tr);
}

/// That of --case, else the first.
CaseId Solve::followed_case(const Model& model, const ui::Catalogue& tr) const
{
    if (model.n_cases() == 0) throw UsageError(tr("The model has no load case."));
    return is_of_all_cases(model) ? CaseId(0) : find_case(model, *case_, tr);
}

femoop::derivation::Derivation Solve::derived(const Model& model, const Results& results,
                                              const femoop::MovingEffect& effect, const ui::Catalogue& tr) const
{
    using namespace femoop::derivation;
    if (is_of_envelope(model) && model.n_cases() > 0) return derive_governing(model, results, all_cases(model), effect);
    const CaseId load_case = followed_case(model, tr);
    if (!kept_case_) return derive(model, results, load_case, effect);
    if (!effect.at && effect.member)
        throw UsageError(tr("--less needs one place in both load cases: add at=X to --why"));
    if (is_resultant(effect)) throw UsageError(tr("--less takes no R off, a size; ask for a component, fx or fy"));
    return derive_difference(model, results, load_case, find_case("--less", model, *kept_case_, tr), effect);
}

std::string Solve::derivation(const Model& model, const Results& results, const ui::Catalogue& tr) const
{
    AskedEffect asked;
    asked.set("--why", *asked_number_, tr, AskedEffect::Takes::Numbers);
    asked.require_sensible(tr, AskedEffect::Place::Optional);
    const femoop::derivation::Derivation derivation = derived(model, results, asked.sound_effect(model, tr), tr);
    if (is_latex_) return derivation_latex(derivation, model, tr);
    return is_json_ ? derivation_json(derivation, model, tr) : derivation_text(derivation, model, tr);
}

/// \throws ModelError where the unit load moves what nothing holds
femoop::virtual_work::VirtualWork Solve::worked_out(const Model& model, const Results& results,
                                                    const femoop::MovingEffect& displacement,
                                                    const ui::Catalogue& tr) const
try {
    return femoop::virtual_work::displacement_by_work(model, results, followed_case(model, tr), displacement);
} catch (const femoop::MechanismError&) {
    if (!displacement.node || !displacement.dof || !is_rotation(*displacement.dof)) throw;
    throw UsageError("--virtual-work: " + femoop::virtual_work::free_rotation_text(model, *displacement.node, tr));
}

std::string Solve::virtual_work(const Model& model, const Results& results, const ui::Catalogue& tr) const
{
    AskedEffect asked;
    asked.set("--virtual-work", *worked_displacement_, tr, AskedEffect::Takes::Displacements);
    asked.require_sensible(tr);
    const femoop::MovingEffect displacement = asked.sound_effect(model, tr);
    if (displacement.quantity != femoop::ExpectedQuantity::Displacement)
        throw UsageError(
            tr("--virtual-work finds displacements: u v w along a member, ux uy uz rx ry rz of a node; for "
               "a force see --why"));
    const auto work = worked_out(model, results, displacement, tr);
    if (is_latex_) return virtual_work_latex(work, model, tr);
    return is_json_ ? virtual_work_json(work, model) : virtual_work_text(work, model, tr);
}

std::string Solve::output(const Model& model, const Results& results, const Selection& selection,
                          const ui::Catalogue& tr) const
{
    if (traced_member_) return trace(model, tr);
    if (asked_number_) return derivation(model, results, tr);
    if (worked_displacement_) return virtual_work(model, results, tr);
    const StepFormat format = is_latex_ ? StepFormat::Latex : is_json_ ? StepFormat::Json : StepFormat::Text;
    if (redundants_.are_asked()) return redundants_.output(model, results, followed_case(model, tr), format, tr);
    if (body_.is_asked()) return body_.output(model, results, followed_case(model, tr), format, tr);
    if (funicular_.is_asked()) return funicular_.output(model, followed_case(model, tr), format, tr);
    if (is_described_) return description(model, results, selection, tr);
    if (!is_json_) return tables(model, results, selection, tr);
    return selection.is_envelope ? femoop::envelope_json(model, results, selection.cases, selection.n_stations)
                                 : femoop::results_json(model, results, selection.cases, selection.n_stations);
}

void Solve::write_csv(const Model& model, const Results& results, const Selection& selection,
                      const Console& console) const
{
    write_tables(*csv_folder_,
                 selection.is_envelope ? femoop::envelope_csv(model, results, selection.cases)
                                       : femoop::results_csv(model, results, selection.cases, selection.n_stations),
                 console);
}

/// Values every curve at its stations once, as any reader of the results does.
double seconds_to_recover(const Model& model, const Results& results, const Selection& selection)
{
    femoop::Stopwatch watch;
    for (const CaseId id : selection.cases) {
        const femoop::CaseResult result = results[id];
        for (std::size_t i = 0; i < model.members.size(); ++i)
            static_cast<void>(result.curve(femoop::MemberId(i)).stations(selection.n_stations));
    }
    return watch.lap();
}

/// What plane models are not asked for.
std::optional<std::string_view> Solve::of_members_alone() const
{
    if (const auto option = calculation(); option && !traced_member_ && !is_described_) return option;
    if (stations_ != std::to_string(femoop::usual_n_stations)) return "--stations";
    if (solver_trace_.are_given()) return "--trace-solver";
    return std::nullopt;
}

ExitStatus Solve::solve_plane(femoop::plane::PlaneReading& reading, const femoop::AnalysisOptions& options,
                              double seconds_to_read, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    tell_of_case_named_as_keyword(case_, reading.model, console);
    if (const auto option = of_members_alone())
        throw UsageError(
            tr("{option} is not built yet for plane models; they are solved with --analysis, --case, --at, "
               "--cut, --cycles, --full, --trace, --describe, --unit, --time, --json, --csv and --solver",
               {{"option", *option}}));
    return plane_.solve({.reading = reading,
                         .file = display_name(file_, tr),
                         .case_name = case_,
                         .is_json = is_json_,
                         .traced_element = traced_member_,
                         .units = units_,
                         .csv_folder = csv_folder_,
                         .is_described = is_described_,
                         .is_timed = is_timed_,
                         .is_refined = is_refined_,
                         .seconds_to_read = seconds_to_read},
                        options, console);
}

/// An option whose numbers are those of one calculation, or sentences on it.
std::optional<std::string_view> Solve::calculation() const
{
    if (traced_member_) return "--trace";
    if (asked_number_) return "--why";
    if (worked_displacement_) return "--virtual-work";
    if (redundants_.are_asked()) return "--force-method";
    if (body_.is_asked()) return "--free-body";
    if (funicular_.is_asked()) return "--funicular";
    if (is_described_) return "--describe";
    return std::nullopt;
}

void Solve::count_in_chosen_units(Model& model, const ui::Catalogue& tr)
{
    const auto option = calculation();
    if (!option || !units_.are_given()) return;
    const std::string typed(femoop::name(model.units.length));
    for (auto* const words : {&asked_number_, &worked_displacement_})
        if (*words) *words = with_unit(**words, typed, "at=");
    redundants_.count_lengths_in(typed);
    body_.count_lengths_in(typed);
    funicular_.count_lengths_in(typed);
    model = units_.in_one_system(model, *option, tr);
}

ExitStatus Solve::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (file_.empty()) throw no_file("solve", tr);
    require_one_output(tr);
    body_.require_sensible(tr);
    funicular_.require_sensible(tr);
    solver_trace_.require_trace(tr);
    const femoop::AnalysisOptions options{.solver = solver_named(solver_, tr), .is_refined = is_refined_};
    PhaseTimes phases{.has_refinement = is_refined_};
    femoop::Stopwatch watch;
    femoop::AnyReading reading = examine_any(file_, tr);
    if (auto* plane = std::get_if<femoop::plane::PlaneReading>(&reading))
        return solve_plane(*plane, options, watch.lap(), console);
    plane_.require_none(tr);
    auto& members = std::get<femoop::ModelReading>(reading);
    console.report(display_name(file_, tr), members.faults);
    if (!members.is_sound()) return ExitStatus::BadInput;
    require_no_envelope(members.model, tr);
    count_in_chosen_units(members.model, tr);
    const Model* const model = &members.model;
    const Selection selected = selection(*model, tr);
    tell_of_case_named_as_keyword(case_, members.model, console);
    phases.read = watch.lap();

    const std::string file = display_name(file_, tr);
    const auto solved = solve_model(*model, file, options, console);
    if (const auto* status = std::get_if<ExitStatus>(&solved)) return *status;
    const auto& [results, statistics] = std::get<Solved>(solved);
    console.report(file, results.warnings());

    if (is_timed_) phases.recover = seconds_to_recover(*model, results, selected);
    watch.lap();
    try {
        if (solver_trace_.are_given()) solver_trace_.show(*model, options.solver.kind, is_json_, console);
        else console.print(output(*model, results, selected, tr));
    } catch (const femoop::MechanismError& error) {
        if (worked_displacement_) console.message(tr("under the unit load of --virtual-work:"));
        return report_unsolved(error, file, console);
    }
    if (csv_folder_) write_csv(*model, results, selected, console);
    if (is_timed_) {
        console.flush();
        phases.write = watch.lap();
        report_time(phases, statistics, console);
    }
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> solve_command() { return std::make_unique<Solve>(); }

} // namespace cli
