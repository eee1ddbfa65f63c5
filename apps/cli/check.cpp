#include "apps/cli/check.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "apps/cli/model_input.h"
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
        tr("Reports all errors and warnings of each file at once, with the place, what was found, what is wanted and a "
           "remedy. Nothing is solved, so a mechanism is not noticed (solve does). Warnings, such as a section that no "
           "member uses or members that cross without a node, leave the status 0."),
        {{"cremona check examples/portal.json", tr("One file.")},
         {"cremona check homework/*.json", tr("A class's files: the status is 2 if any has an error.")}}};
}

void Check::declare(CLI::App& app, const ui::Catalogue& tr)
{
    app.add_option("FILE", files_, tr("model files; - is standard input"))->option_text(" ");
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
        const femoop::ModelReading reading = examine(file, tr);
        const std::string shown = display_name(file, tr);
        console.report(shown, reading.faults);
        if (reading.is_sound()) sound.push_back({shown, reading.faults});
        else status = ExitStatus::BadInput;
        const std::size_t errors = number_of(reading.faults, Severity::Error);
        const std::size_t warnings = number_of(reading.faults, Severity::Warning);
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
