#include "apps/cli/verify.h"

#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/model_input.h"
#include "apps/cli/plane_input.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/plane/plane_verify.h"
#include "femoop/io/verify.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/plane/analysis/natural_modes.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "ui/files/view_file.h"

namespace cli {

namespace {

using femoop::CheckOutcome;
using femoop::Verdict;

/// The checks of one file, or why there are none.
struct FileOutcome {
    std::string file;
    ExitStatus status = ExitStatus::Done;
    std::vector<CheckOutcome> checks;
};

std::string number(double value, const ui::Catalogue& tr, int digits = 10)
{
    std::array<char, 32> buffer{};
    static_cast<void>(std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value == 0.0 ? 0.0 : value));
    return femoop::localized(buffer.data(), tr);
}

std::string reason(const ui::Catalogue& tr) { return tr("this analysis is not built yet"); }

std::string line(const std::string& file, const CheckOutcome& check, const ui::Catalogue& tr)
{
    if (check.verdict == Verdict::Skipped)
        return file + ": " + check.what + ": " + tr("skipped: {reason}", {{"reason", reason(tr)}}) + "\n";
    const std::string numbers = tr("{result}, expected {expected} within {tolerance}",
                                   {{"result", number(*check.result, tr)},
                                    {"expected", number(check.expected, tr)},
                                    {"tolerance", number(check.tolerance, tr, 3)}});
    return file + ": " + check.what + " = " + numbers + ": " +
           (check.verdict == Verdict::Passed ? tr("passed") : tr("FAILED")) + "\n";
}

std::string_view word(Verdict verdict)
{
    static constexpr std::array<std::string_view, 3> words{"passed", "failed", "skipped"};
    return words[static_cast<std::size_t>(verdict)];
}

class Verify : public Subcommand {
public:
    std::string_view name() const override { return "verify"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    FileOutcome verify_file(const std::string& file, const Console& console) const;
    void verify_plane(femoop::plane::PlaneReading& reading, FileOutcome& outcome, const Console& console) const;
    void print_lines(const std::vector<FileOutcome>& files, Console& console) const;
    void print_json(const std::vector<FileOutcome>& files, Console& console) const;

    std::vector<std::string> files_;
    bool is_quiet_ = false, is_json_ = false;
};

HelpText Verify::help(const ui::Catalogue& tr) const
{
    return {
        tr("check a model against the results that its file expects"),
        tr("Solves each file and compares the entries of its \"expected\" list: a displacement, a reaction, a section "
           "force, an extreme, a frequency of a plane body, with a value and a tolerance. A check passes when the result is within max(atol, rtol "
           "|value|) of the value. One line a check, then a count. Checks of analyses that are not built yet are named "
           "and skipped, never passed; so are view files. A homework sheet with expected results is a test this way."),
        {{"cremona verify tests/cases/members/BM-001.json", tr("Every check of one file.")},
         {"cremona verify --quiet tests/cases/members/*.json",
          tr("Failed checks alone, then the count of all files.")}}};
}

void Verify::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", files_, tr("model files with expected results; - is standard input")).option_text(" ");
    options.add_flag("-q,--quiet", is_quiet_, tr("print failed checks and the count alone"));
    options.add_flag("--json", is_json_, tr("print the checks as JSON"));
}

FileOutcome Verify::verify_file(const std::string& file, const Console& console) const
{
    FileOutcome outcome{display_name(file, console.tr()), ExitStatus::Done, {}};
    femoop::AnyReading reading = examine_any(file, console.tr());
    if (auto* plane = std::get_if<femoop::plane::PlaneReading>(&reading)) {
        verify_plane(*plane, outcome, console);
        return outcome;
    }
    auto& members = std::get<femoop::ModelReading>(reading);
    console.report(outcome.file, members.faults);
    if (!members.is_sound()) {
        outcome.status = ExitStatus::BadInput;
        return outcome;
    }
    const femoop::Model* const model = &members.model;
    std::optional<femoop::Results> results;
    if (femoop::needs_linear_analysis(*model)) {
        auto solved = solve_model(*model, outcome.file, {}, console);
        if (const auto* status = std::get_if<ExitStatus>(&solved)) {
            outcome.status = *status;
            return outcome;
        }
        results = std::get<Solved>(solved).results;
        console.report(outcome.file, results->warnings());
    }
    try {
        outcome.checks = is_json_ ? femoop::verify(*model, results) : femoop::verify(*model, results, console.tr());
    } catch (const femoop::ModelError& error) {
        outcome.status = report_unsolved(error, outcome.file, console);
    }
    if (femoop::count(outcome.checks).failed > 0) outcome.status = ExitStatus::No;
    return outcome;
}

/// A drawing is meshed where results are asked for; counts and areas need none.
void Verify::verify_plane(femoop::plane::PlaneReading& reading, FileOutcome& outcome, const Console& console) const
{
    namespace fp = femoop::plane;
    const femoop::Translator tr = is_json_ ? femoop::english : femoop::Translator(console.tr());
    const bool needs_results = fp::needs_linear_analysis(reading.model);
    const std::size_t n_modes = fp::n_modes_needed(reading.model);
    const bool needs_mesh = needs_results || n_modes > 0;
    const PlaneInput input(reading, needs_mesh ? PlaneInput::Depth::Mesh : PlaneInput::Depth::Drawing);
    console.report(outcome.file, reading.faults);
    outcome.status = ExitStatus::BadInput;
    if (!reading.is_sound()) return;
    try {
        fp::PlaneFindings found;
        if (needs_results) {
            found.results = fp::analyse(input.model());
            console.report(outcome.file, found.results->warnings());
        }
        if (n_modes > 0) {
            found.modes = fp::natural_modes(input.model(), n_modes);
            console.report(outcome.file, found.modes->warnings);
        }
        outcome.checks = fp::verify(reading.model, found, input.checks(), tr);
        outcome.status = femoop::count(outcome.checks).failed > 0 ? ExitStatus::No : ExitStatus::Done;
    } catch (const femoop::ModelError& error) {
        outcome.status = report_unsolved(error, outcome.file, console);
    }
}

void Verify::print_lines(const std::vector<FileOutcome>& files, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    femoop::CheckCounts total;
    for (const FileOutcome& file : files) {
        total += femoop::count(file.checks);
        for (const CheckOutcome& check : file.checks)
            if (!is_quiet_ || check.verdict == Verdict::Failed) console.print(line(file.file, check, tr));
    }
    console.print(
        tr("{passed} passed, {failed} failed, {skipped} skipped", {{"passed", std::to_string(total.passed)},
                                                                   {"failed", std::to_string(total.failed)},
                                                                   {"skipped", std::to_string(total.skipped)}}) +
        "\n");
}

void Verify::print_json(const std::vector<FileOutcome>& files, Console& console) const
{
    femoop::CheckCounts total;
    femoop::JsonWriter json;
    json.begin_object(femoop::JsonWriter::Layout::Block).member("cremona", 1);
    json.key("checks").begin_array(femoop::JsonWriter::Layout::Block);
    for (const FileOutcome& file : files) {
        total += femoop::count(file.checks);
        for (const CheckOutcome& check : file.checks) {
            if (is_quiet_ && check.verdict != Verdict::Failed) continue;
            json.begin_object().member("file", file.file).member("what", check.what);
            json.member("verdict", word(check.verdict)).member("expected", check.expected);
            if (check.result) json.member("result", *check.result).member("tolerance", check.tolerance);
            if (check.skipped) json.member("reason", reason(ui::Catalogue()));
            json.end();
        }
    }
    json.end().member("passed", total.passed).member("failed", total.failed).member("skipped", total.skipped).end();
    console.print(json.take());
}

ExitStatus Verify::run(Console& console)
{
    if (files_.empty()) throw no_file("verify", console.tr());
    std::vector<FileOutcome> files;
    ExitStatus status = ExitStatus::Done;
    bool is_any_checked = false;
    for (const std::string& file : files_) {
        if (ui::model_of_view(file)) {
            console.message(file + ": " + console.tr()("skipped: {reason}", {{"reason", console.tr()("a view file")}}));
            is_any_checked = true;
            continue;
        }
        files.push_back(verify_file(file, console));
        status = worse(status, files.back().status);
        is_any_checked = is_any_checked || worse(files.back().status, ExitStatus::No) == ExitStatus::No;
    }
    // Programs read JSON whole or not at all; people want the files that could be read.
    if (is_json_ ? worse(status, ExitStatus::No) != ExitStatus::No : !is_any_checked) return status;
    if (is_json_) print_json(files, console);
    else print_lines(files, console);
    return status;
}

} // namespace

std::unique_ptr<Subcommand> verify_command() { return std::make_unique<Verify>(); }

} // namespace cli
