#include "apps/cli/check.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/cli/argument.h"
#include "apps/cli/model_input.h"
#include "apps/cli/plane_input.h"
#include "apps/frame/document/companion/companion_file.h"
#include "apps/plane/backdrop/view_file.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/io/any_model.h"
#include "femoop/io/counting/counting_text.h"
#include "femoop/io/cross/cross_block.h"
#include "femoop/io/file_text.h"
#include "femoop/io/influence/influence_block.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/train/train_block.h"
#include "femoop/io/truss/truss_json.h"
#include "femoop/io/truss/truss_sentence.h"
#include "ui/files/view_file.h"

namespace cli {

namespace {

using femoop::Severity;

std::size_t number_of(const std::vector<femoop::Fault>& faults, Severity severity)
{
    return static_cast<std::size_t>(std::count_if(faults.begin(), faults.end(), [&](const femoop::Fault& fault) {
        return femoop::severity(fault.kind) == severity;
    }));
}

/// What a file holds and everything wrong with it: with a view file as it stands beside its model, else with a model.
femoop::AnyReading read(const std::string& file, const ui::Catalogue& tr)
{
    const auto beside = ui::model_of_view(file);
    if (!beside) return examine_any(file, tr);
    femoop::FileText model = femoop::file_text(*beside);
    if (model.fault) return femoop::ModelReading{{}, {*std::move(model.fault)}};
    femoop::FileText views = femoop::file_text(file);
    if (views.fault) return femoop::ModelReading{{}, {*std::move(views.fault)}};
    femoop::AnyReading any = femoop::examine_any(model.text);
    if (std::holds_alternative<femoop::plane::PlaneReading>(any))
        return femoop::plane::PlaneReading{.faults = ::plane::read_view(views.text, beside->parent_path()).faults};
    auto& reading = std::get<femoop::ModelReading>(any);
    reading.faults = frame::read_companion(views.text, reading.model).faults;
    return any;
}

constexpr femoop::CaseId truss_case(0);

/// Under its first load case; nothing where it is no plane truss whose forces follow from equilibrium alone.
std::optional<femoop::truss::Truss> solved_truss(const femoop::Model& model)
{
    if (model.analysis != femoop::AnalysisKind::Truss2d || model.n_cases() == 0) return std::nullopt;
    try {
        const femoop::Results results = femoop::analyse(model);
        if (femoop::truss::why_no_truss(model, results)) return std::nullopt;
        return femoop::truss::truss_of(model, results, truss_case);
    } catch (const femoop::ModelError&) { // it can move: the count says so
        return std::nullopt;
    }
}

/// What `check` says of a file that can be used.
struct SoundFile {
    std::string file;
    std::vector<femoop::Fault> warnings;
    std::optional<femoop::Model> model; ///< nothing of a plane model
};

void add_faults_of(const femoop::Model& model, std::vector<femoop::Fault>& faults)
{
    const auto read = [&](const auto& block_of) {
        try {
            static_cast<void>(block_of(model));
        } catch (const femoop::ModelError& error) {
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
    };
    read(femoop::influence::block_of);
    read(femoop::influence::train_block_of);
    read(femoop::cross::block_of);
}

/// A reading of either kind, with the blocks that only their own analyses understand.
SoundFile contents_of(const std::string& file, femoop::AnyReading reading)
{
    if (auto* plane = std::get_if<femoop::plane::PlaneReading>(&reading)) {
        const bool has_material = std::ranges::any_of(plane->model.regions,
                                                      [](const auto& region) { return !region.is_hole; });
        const PlaneInput input(*plane, has_material ? PlaneInput::Depth::Mesh : PlaneInput::Depth::Drawing);
        return {file, std::move(plane->faults), {}};
    }
    auto& members = std::get<femoop::ModelReading>(reading);
    if (members.is_sound()) add_faults_of(members.model, members.faults);
    return {file, std::move(members.faults), std::move(members.model)};
}

class Check : public Subcommand {
public:
    std::string_view name() const override { return "check"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void print(const SoundFile& file, Console& console) const;
    void print_count(const femoop::Model& model, Console& console) const;
    void print_json(const std::vector<SoundFile>& files, Console& console) const;

    std::vector<std::string> files_;
    bool is_json_ = false, is_counted_ = false;
};

HelpText Check::help(const ui::Catalogue& tr) const
{
    return {
        tr("read a model file and report everything that is wrong with it"),
        tr("Reports all errors and warnings of each file at once, with the place, what was found, "
           "what is wanted and a remedy. Nothing is solved, so a mechanism is not noticed (solve does). "
           "Warnings, such as a section that no member uses or members that cross without a node, leave the status 0. "
           "A view file (portal.view.json) is checked beside its model (portal.json), which must be there."),
        {{"cremona check examples/portal.json", tr("One file.")},
         {"cremona check examples/portal.json --count",
          tr("The degree of static indeterminacy as a sum of rings, releases, reactions and equations.")},
         {"cremona check homework/*.json", tr("A class's files: the status is 2 if any has an error.")}}};
}

void Check::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", files_, tr("model files and view files; - is standard input")).option_text(" ");
    options.add_flag(
        "--count", is_counted_,
        tr("print what the degree of static indeterminacy of each sound file is made of; a structure that can "
           "move is counted too; of a determinate plane truss the bars that carry nothing under its first "
           "load case, each with its rule"));
    options.add_flag("--json", is_json_, tr("print the sound files and their warnings as JSON"));
}

void Check::print_json(const std::vector<SoundFile>& files, Console& console) const
{
    femoop::JsonWriter json;
    json.begin_object().member("cremona", 1).key("files").begin_array(femoop::JsonWriter::Layout::Block);
    for (const SoundFile& file : files) {
        json.begin_object().member("file", file.file).key("warnings").begin_array();
        for (const femoop::Fault& warning : file.warnings) json.value(console.sentence(warning));
        json.end();
        if (is_counted_ && file.model) {
            const femoop::Model& model = *file.model;
            femoop::counting::write_counting(json.key("counting"), femoop::counting::count(model), model);
            if (const auto truss = solved_truss(model))
                write_zero_force_bars(json.key("zero_force_bars"), *truss, model, console.tr());
        }
        json.end();
    }
    json.end().end();
    console.print(json.take());
}

void Check::print_count(const femoop::Model& model, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    console.print(femoop::counting::counting_text(femoop::counting::count(model), model, tr));
    const auto truss = solved_truss(model);
    if (!truss) return;
    console.print(tr("Load case {id}", {{"id", model.case_name(truss_case)}}) + ": " +
                  zero_force_summary(*truss, model, tr) + "\n");
    for (const femoop::truss::ZeroForceBar& bar : zero_force_bars(*truss))
        console.print("  " + sentence(bar, model, tr) + "\n");
}

void Check::print(const SoundFile& file, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    console.print(file.file + ": " +
                  tr("no errors, warnings: {warnings}", {{"warnings", std::to_string(file.warnings.size())}}) + "\n");
    if (!is_counted_) return;
    if (file.model) print_count(*file.model, console);
    else console.print("  " + tr("a plane model has no degree of static indeterminacy to count") + "\n");
}

ExitStatus Check::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (files_.empty()) throw no_file("check", tr);
    ExitStatus status = ExitStatus::Done;
    std::vector<SoundFile> sound;
    for (const std::string& file : files_) {
        const std::string shown = display_name(file, tr);
        SoundFile contents = contents_of(shown, read(file, tr));
        console.report(shown, contents.warnings);
        const std::size_t errors = number_of(contents.warnings, Severity::Error);
        if (errors > 0) {
            const std::size_t warnings = number_of(contents.warnings, Severity::Warning);
            status = ExitStatus::BadInput;
            console.message(shown + ": " +
                            tr("errors: {errors}, warnings: {warnings}",
                               {{"errors", std::to_string(errors)}, {"warnings", std::to_string(warnings)}}));
            continue;
        }
        sound.push_back(std::move(contents));
        if (!is_json_) print(sound.back(), console);
    }
    if (is_json_ && status == ExitStatus::Done) print_json(sound, console);
    return status;
}

} // namespace

std::unique_ptr<Subcommand> check_command() { return std::make_unique<Check>(); }

} // namespace cli
