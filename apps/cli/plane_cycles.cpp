#include "apps/cli/plane_cycles.h"

#include <optional>

#include "apps/cli/analysis_run.h"
#include "apps/plane/discretize/error_cycle.h"
#include "apps/plane/view/error_curve.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/tabular/plain_text.h"

namespace cli {

namespace {

namespace fp = femoop::plane;
using discretize::ErrorCycle;
using discretize::MeshError;
using femoop::JsonWriter;

/// A cycle that has run, and why it ended before its last mesh.
struct RunCycle {
    ErrorCycle cycle;
    std::optional<discretize::NextMesh> end{};
};

/// \throws femoop::ModelError where a mesh cannot be solved
RunCycle run_cycle(const CycleQuestion& question, femoop::CaseId load_case, const femoop::AnalysisOptions& options)
{
    constexpr std::size_t most_unknowns = 1'000'000;
    RunCycle run{.cycle = ErrorCycle(load_case, most_unknowns)};
    const auto add = [&](const fp::PlaneModel& mesh) {
        const fp::PlaneResults results = fp::analyse(mesh, options);
        run.cycle.add(results, results[load_case]);
    };
    add(question.mesh.model());
    for (std::size_t i = 0; i < question.n_cycles; ++i) {
        const discretize::NextMesh next = run.cycle.next();
        if (next.end) {
            run.end = next;
            break;
        }
        const discretize::MeshedDrawing mesh(question.drawing, {}, next.sizes);
        if (!mesh.is_sound()) throw femoop::ModelError(mesh.faults());
        run.cycle.take(next.sizes);
        add(mesh.model());
    }
    run.cycle.compare(question.drawing);
    return run;
}

void write_meshes(JsonWriter& json, std::string_view key, const std::vector<MeshError>& meshes)
{
    json.key(key).begin_array(JsonWriter::Layout::Block);
    for (const MeshError& mesh : meshes)
        json.begin_object()
            .member("elements", mesh.n_elements)
            .member("unknowns", mesh.n_unknowns)
            .member("error_estimate", mesh.error)
            .end();
    json.end();
}

void write_rate(JsonWriter& json, std::string_view key, const std::optional<double>& rate)
{
    if (rate) json.member(key, *rate);
}

void write_case(JsonWriter& json, const ErrorCycle& cycle)
{
    write_meshes(json, "refined", cycle.meshes());
    write_meshes(json, "evenly", cycle.uniform());
    write_rate(json, "rate", discretize::rate(cycle.meshes()));
    write_rate(json, "rate_evenly", discretize::rate(cycle.uniform()));
    json.member("rate_smooth", cycle.smooth_rate());
    if (const auto at = cycle.singular_place())
        json.key("singular").begin_array().value(at->at.x()).value(at->at.y()).end();
}

/// One line a mesh, with the exponent from the one before.
std::string table_text(const std::vector<MeshError>& meshes, const ::plane::PlateOptions& options)
{
    const ui::Catalogue& tr = options.tr;
    tabular::Table table({{tr("mesh")},
                          {tr("elements")},
                          {tr("unknowns")},
                          {tr("error"), {}, tabular::Alignment::Right},
                          {tr("exponent of N"), {}, tabular::Alignment::Right}});
    std::vector<MeshError> so_far;
    for (const MeshError& mesh : meshes) {
        so_far.push_back(mesh);
        const auto rate = discretize::rate(so_far);
        table.add_row({std::to_string(so_far.size() - 1), mesh.n_elements, mesh.n_unknowns,
                       ::plane::percent_text(mesh.error, options.numbers),
                       rate ? ::plane::exponent_text(*rate, options.numbers) : "-"});
    }
    return tabular::plain_text(table, {2, femoop::decimal_mark(tr)});
}

std::string case_text(const RunCycle& run, const fp::PlaneModel& model, const ui::Catalogue& tr)
{
    ::plane::PlateOptions options;
    options.tr = tr;
    options.numbers.mark = ui::decimal_mark(tr.language());
    std::string text = "\n" + model.case_name(run.cycle.load_case()) + "\n" + tr("refined by the error") + "\n" +
                       table_text(run.cycle.meshes(), options);
    if (run.cycle.uniform().size() > 1) text += tr("refined evenly") + "\n" + table_text(run.cycle.uniform(), options);
    for (const std::string& sentence : ::plane::sentences(run.cycle, model, options)) text += sentence + "\n";
    if (run.end) text += tr(::plane::reason_of(*run.end, run.cycle)) + "\n";
    return text;
}

} // namespace

ExitStatus print_cycles(const CycleQuestion& question, const femoop::AnalysisOptions& options, Console& console)
{
    const ui::Catalogue& tr = console.tr();
    const fp::PlaneModel& drawn = question.drawing.model();
    if (const auto mapped = discretize::mapped_region(drawn))
        throw UsageError(tr("--cycles: region {region} is mapped, and its mesh follows its sides; give it the method "
                            "delaunay, or leave its method out",
                            {{"region", drawn[*mapped].id}}));
    std::string text = drawn.title + "\n";
    JsonWriter json;
    femoop::begin_output(json, drawn.units);
    json.key("cases").begin_object(JsonWriter::Layout::Block);
    try {
        for (const femoop::CaseId load_case : question.cases) {
            const RunCycle run = run_cycle(question, load_case, options);
            text += case_text(run, drawn, tr);
            json.key(drawn.case_name(load_case)).begin_object(JsonWriter::Layout::Block);
            write_case(json, run.cycle);
            json.end();
        }
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, question.file, console);
    }
    json.end().end();
    console.print(question.is_json ? json.take() : text);
    return ExitStatus::Done;
}

} // namespace cli
