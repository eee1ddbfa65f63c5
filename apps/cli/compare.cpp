#include "apps/cli/compare.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/asked_units.h"
#include "apps/cli/model_input.h"
#include "apps/cli/reference.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/results/difference_text.h"
#include "femoop/io/results/results_table.h"
#include "femoop/tabular/plain_text.h"

namespace cli {

namespace {

using femoop::CaseId;
using femoop::ComparedCase;

/// A case and the one that it is compared with.
struct CasePair {
    CaseId now, before;
};

class Compare : public Subcommand {
public:
    std::string_view name() const override { return "compare"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void require_sensible(const ui::Catalogue& tr) const;
    std::vector<CasePair> pairs(const femoop::Model& model, const drawing::ReferenceResults& reference,
                                const Console& console) const;
    std::string title(const std::string& now, const std::string& before, const ui::Catalogue& tr) const;
    std::string text(const femoop::Model& model, const femoop::Results& results,
                     const drawing::ReferenceResults& reference, const std::vector<CasePair>& pairs,
                     const ui::Catalogue& tr) const;
    std::string json(const femoop::Model& model, const femoop::Results& results,
                     const drawing::ReferenceResults& reference, const std::vector<CasePair>& pairs) const;

    std::string file_;
    std::optional<std::string> other_, case_, with_;
    AskedUnits units_;
    bool is_json_ = false, is_described_ = false;
};

HelpText Compare::help(const ui::Catalogue& tr) const
{
    return {
        tr("set results beside those of another load case or another file, with the changes"),
        tr("Solves both and prints, for each member, where its section forces differ most, each reaction and each "
           "displacement: now (FILE, --case), before (OTHER, --with), and the change, now less before. Parts and cases "
           "are matched by their names, and what only one of the structures has is said. A file in other units is "
           "converted to those of FILE. The structures are of one kind."),
        {{"cremona compare examples/portal.json --case Q --with G", tr("Two load cases of one structure.")},
         {"cremona compare portal.json old_portal.json", tr("Every case that both files have.")},
         {"cremona compare portal.json old_portal.json --case ULS --describe",
          tr("What changes most in one case, in sentences.")}}};
}

void Compare::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", file_, tr("the model file; - is standard input")).option_text(" ");
    options.add_option("OTHER", other_, tr("the model file that it is compared with; without it two cases of FILE are"))
        .option_text(" ");
    options.add_option("--case", case_, tr("the load case or combination of FILE that is compared (default: all)"))
        .option_text("ID");
    options
        .add_option("--with", with_,
                    tr("the load case or combination that it is compared with (default: the one of the same name)"))
        .option_text("ID");
    units_.declare(options, tr);
    options.add_flag("--json", is_json_, tr("print JSON with every digit instead of tables"));
    options.add_flag("--describe", is_described_, tr("print what changes most in sentences instead of tables"));
}

void Compare::require_sensible(const ui::Catalogue& tr) const
{
    if (file_.empty()) throw no_file("compare", tr);
    if (!other_ && !with_) throw UsageError(tr("give a second file, or --with for two load cases of one file"));
    if (other_ && file_ == "-" && *other_ == "-")
        throw UsageError(tr("standard input is one file; name the other one"));
    if (is_json_ && units_.are_given()) throw units_of_file("--json", tr);
    if (is_json_ && is_described_) throw print_different_things("--json", "--describe", tr);
}

/// Those with a counterpart; the others are told.
std::vector<CasePair> Compare::pairs(const femoop::Model& model, const drawing::ReferenceResults& reference,
                                     const Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const auto asked = case_ ? std::vector{find_case("--case", model, *case_, tr)} : all_cases(model);
    std::vector<CasePair> found;
    for (const CaseId id : asked) {
        const auto counterpart = reference.counterpart(model, id);
        const bool is_itself = !other_ && counterpart == id && !case_;
        if (is_itself) continue;
        if (counterpart) found.push_back({id, *counterpart});
        else
            console.message(tr("{case}: there is none of this name in {file}; it is not compared",
                               {{"case", model.case_name(id)}, {"file", display_name(*other_, tr)}}));
    }
    if (found.empty()) throw UsageError(tr("there are no two cases to compare; name them with --case and --with"));
    return found;
}

std::string Compare::title(const std::string& now, const std::string& before, const ui::Catalogue& tr) const
{
    if (!other_) return tr("{now} compared with {before}", {{"now", now}, {"before", before}});
    return tr("{now} compared with {before}",
              {{"now", display_name(file_, tr) + ", " + now}, {"before", display_name(*other_, tr) + ", " + before}});
}

std::string Compare::text(const femoop::Model& model, const femoop::Results& results,
                          const drawing::ReferenceResults& reference, const std::vector<CasePair>& pairs,
                          const ui::Catalogue& tr) const
{
    const femoop::ResultUnits units = units_.of_results(model, tr);
    std::string text;
    for (const auto& [now, before] : pairs) {
        const std::string heading = title(model.case_name(now), reference.model.case_name(before), tr);
        text += (text.empty() ? "" : "\n") + heading + "\n" + std::string(tabular::shown_width(heading), '=') + "\n";
        const ComparedCase present{&model, results[now]}, former{&reference.model, reference.results[before]};
        text += is_described_ ? differences_sentences(present, former, units, tr)
                              : differences_text(present, former, units, tr);
    }
    return text;
}

std::string Compare::json(const femoop::Model& model, const femoop::Results& results,
                          const drawing::ReferenceResults& reference, const std::vector<CasePair>& pairs) const
{
    femoop::JsonWriter json;
    begin_output(json, model.units);
    json.key("comparisons").begin_array(femoop::JsonWriter::Layout::Block);
    for (const auto& [now, before] : pairs) {
        json.begin_object(femoop::JsonWriter::Layout::Block);
        json.member("case", model.case_name(now)).member("with", reference.model.case_name(before));
        write_differences(json, {&model, results[now]}, {&reference.model, reference.results[before]});
        json.end();
    }
    json.end().end();
    return json.take();
}

ExitStatus Compare::run(Console& console)
{
    require_sensible(console.tr());
    const std::optional<femoop::Model> model = load_model(file_, console);
    if (!model) return ExitStatus::BadInput;
    const std::string file = display_name(file_, console.tr());
    const auto solved = solve_model(*model, file, {}, console);
    if (const auto* status = std::get_if<ExitStatus>(&solved)) return *status;
    const femoop::Results& results = std::get<Solved>(solved).results;
    console.report(file, results.warnings());
    const auto found = reference_of({other_, with_, "--with"}, *model, results, console);
    if (const auto* status = std::get_if<ExitStatus>(&found)) return *status;
    const auto& reference = std::get<drawing::ReferenceResults>(found);
    const std::vector<CasePair> compared = pairs(*model, reference, console);
    console.print(is_json_ ? json(*model, results, reference, compared)
                           : text(*model, results, reference, compared, console.tr()));
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> compare_command() { return std::make_unique<Compare>(); }

} // namespace cli
