#include "apps/cli/check.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "apps/cli/model_input.h"
#include "apps/frame/document/companion/companion_file.h"
#include "femoop/io/file_text.h"
#include "femoop/io/json/json_writer.h"

namespace cli {

namespace {

using femoop::Severity;

std::size_t number_of(const std::vector<femoop::Fault>& faults, Severity severity)
{
    return static_cast<std::size_t>(std::count_if(faults.begin(), faults.end(), [&](const femoop::Fault& fault) {
        return femoop::severity(fault.kind) == severity;
    }));
}

/// Everything wrong with a file: with a view file as it stands beside its model, else with a model.
std::vector<femoop::Fault> faults_of(const std::string& file, const ui::Catalogue& tr)
{
    const auto beside = frame::model_of_companion(file);
    if (!beside) return examine(file, tr).faults;
    femoop::FileText model = femoop::file_text(*beside);
    if (model.fault) return {*std::move(model.fault)};
    femoop::FileText views = femoop::file_text(file);
    if (views.fault) return {*std::move(views.fault)};
    return frame::read_companion(views.text, femoop::examine_model(model.text).model).faults;
}

/// What `check` says of a file that can be used.
struct SoundFile {
    std::string file;
    std::vector<femoop::Fault> warnings;
};

class Check : public Subcommand {
public:
    std::string_view name() const override { return "check"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(CLI::App& app, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void print_json(const std::vector<SoundFile>& files, Console& console) const;

    std::vector<std::string> files_;
    bool is_json_ = false;
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
         {"cremona check homework/*.json", tr("A class's files: the status is 2 if any has an error.")}}};
}

void Check::declare(CLI::App& app, const ui::Catalogue& tr)
{
    app.add_option("FILE", files_, tr("model files and view files; - is standard input"))->option_text(" ");
    app.add_flag("--json", is_json_, tr("print the sound files and their warnings as JSON"));
}

void Check::print_json(const std::vector<SoundFile>& files, Console& console) const
{
    femoop::JsonWriter json;
    json.begin_object().member("cremona", 1).key("files").begin_array(femoop::JsonWriter::Layout::Block);
    for (const SoundFile& file : files) {
        json.begin_object().member("file", file.file).key("warnings").begin_array();
        for (const femoop::Fault& warning : file.warnings) json.value(console.sentence(warning));
        json.end().end();
    }
    json.end().end();
    console.print(json.take());
}

ExitStatus Check::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (files_.empty()) throw UsageError(tr("no file is given; see {command}", {{"command", "cremona check --help"}}));
    ExitStatus status = ExitStatus::Done;
    std::vector<SoundFile> sound;
    for (const std::string& file : files_) {
        const std::vector<femoop::Fault> faults = faults_of(file, tr);
        const std::string shown = display_name(file, tr);
        console.report(shown, faults);
        const std::size_t errors = number_of(faults, Severity::Error);
        const std::size_t warnings = number_of(faults, Severity::Warning);
        if (errors == 0) sound.push_back({shown, faults});
        else status = ExitStatus::BadInput;
        if (errors > 0)
            console.message(shown + ": " +
                            tr("errors: {errors}, warnings: {warnings}",
                               {{"errors", std::to_string(errors)}, {"warnings", std::to_string(warnings)}}));
        else if (!is_json_)
            console.print(shown + ": " +
                          tr("no errors, warnings: {warnings}", {{"warnings", std::to_string(warnings)}}) + "\n");
    }
    if (is_json_ && status == ExitStatus::Done) print_json(sound, console);
    return status;
}

} // namespace

std::unique_ptr<Subcommand> check_command() { return std::make_unique<Check>(); }

} // namespace cli
