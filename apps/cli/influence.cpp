#include "apps/cli/influence.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/asked_effect.h"
#include "apps/cli/asked_units.h"
#include "apps/cli/model_input.h"
#include "apps/cli/moving_picture.h"
#include "apps/cli/picture.h"
#include "femoop/io/influence/influence_block.h"
#include "femoop/io/influence/influence_json.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/model/check/check.h"

namespace cli {

namespace {

using femoop::Fault;
using femoop::InfluenceLineDefinition;
using femoop::Model;

constexpr long usual_stations = 11;

class Influence : public Subcommand {
public:
    std::string_view name() const override { return "influence"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    std::vector<InfluenceLineDefinition> of_file(const Model& model, const Console& console) const;
    std::vector<InfluenceLineDefinition> chosen(std::vector<InfluenceLineDefinition> lines,
                                                const ui::Catalogue& tr) const;
    InfluenceLineDefinition asked_line(const Model& model, const Console& console) const;
    std::string output(const Model& model, const std::vector<InfluenceLineDefinition>& definitions,
                       const Console& console) const;

    std::string file_, stations_ = std::to_string(usual_stations);
    std::vector<std::string> lines_;
    std::optional<std::string> path_;
    AskedEffect asked_;
    AskedUnits units_;
    bool is_json_ = false, is_described_ = false;
};

HelpText Influence::help(const ui::Catalogue& tr) const
{
    return {
        tr("find influence lines: the effect of a unit load as a function of where it stands"),
        tr("A unit load moves along a path of members; a line says what it does to a section force, a reaction or a "
           "displacement while it stands at s. By Müller-Breslau's principle the line is the path's own deformed shape "
           "where the section is opened, or the support moved, by 1. Between nodes and the section it is a polynomial "
           "of degree three or less, which is printed, and never sampled: extremes, their places and the areas of "
           "either sign are exact.\n\nThe lines are those of the file (\"influence_lines\", and its block "
           "\"influence\"), or the one that is asked for."),
        {{"cremona influence examples/influence.json", tr("Every line of the file.")},
         {"cremona influence examples/influence.json --path deck --member BC --at 50% --component M",
          tr("The bending moment in the middle of BC.")},
         {"cremona influence examples/influence.json --path AB,BC --node B --component fy --json",
          tr("The reaction at B for a load on two of the members, for a program.")}}};
}

void Influence::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", file_, tr("the model file; - is standard input")).option_text(" ");
    options.add_option("--line", lines_, tr("a line of the file by its id; may be given again (default all)"))
        .option_text("ID")
        .one_value_each();
    options
        .add_option("--path", path_,
                    tr("the members that the load moves along: a path of the file, or members that follow one another; "
                       "lines of the file are then taken along it (default theirs, or the only one)"))
        .option_text("ID|m1,m2,..");
    asked_.declare(options, tr);
    options
        .add_option("--stations", stations_,
                    tr("how many evenly spaced places of each member have their ordinates printed (default 11); "
                       "a jump has two"))
        .option_text("N");
    units_.declare(options, tr);
    options.add_flag("--json", is_json_, tr("print JSON with every digit instead of tables"));
    options.add_flag("--describe", is_described_, tr("print sentences instead of tables: for a screen reader"));
}

std::vector<InfluenceLineDefinition> Influence::of_file(const Model& model, const Console& console) const
{
    std::vector<InfluenceLineDefinition> lines = model.moving_loads.influence_lines;
    if (const auto block = femoop::influence::block_of(model)) {
        for (const auto& check : block->lines) lines.push_back(check.line);
        if (!block->lines.empty())
            console.report(display_name(file_, console.tr()),
                           check_line(model, block->lines.front().line, {"influence", {}}));
    }
    if (lines.empty())
        throw UsageError(
            console.tr()("the file has no influence line; add \"influence_lines\" to it, or ask for one by "
                         "--member M --at X --component C, or --node N --component C"));
    return chosen(std::move(lines), console.tr());
}

std::vector<InfluenceLineDefinition> Influence::chosen(std::vector<InfluenceLineDefinition> lines,
                                                       const ui::Catalogue& tr) const
{
    if (lines_.empty()) return lines;
    std::vector<InfluenceLineDefinition> found;
    for (const std::string& id : lines_) {
        const auto before = found.size();
        std::ranges::copy_if(lines, std::back_inserter(found), [&](const auto& line) { return line.id == id; });
        if (found.size() > before) continue;
        std::vector<std::string> names;
        for (const InfluenceLineDefinition& line : lines) names.push_back(line.id);
        throw unknown_choice("--line", id, names, tr);
    }
    return found;
}

InfluenceLineDefinition Influence::asked_line(const Model& model, const Console& console) const
{
    InfluenceLineDefinition line;
    line.effect = asked_.effect(model, console.tr());
    line.id = asked_.text();
    line.path = path_ ? path_named(model, *path_, console.tr()) : only_path(model);
    return line;
}

std::string Influence::output(const Model& model, const std::vector<InfluenceLineDefinition>& definitions,
                              const Console& console) const
{
    const auto n = static_cast<std::size_t>(whole_number("--stations", stations_, {2, 100000}, console.tr()));
    const femoop::influence::InfluenceLines found = femoop::influence::influence_lines(model, definitions);
    console.report(display_name(file_, console.tr()), found.warnings);
    if (!is_described_)
        for (const InfluenceLineDefinition& line : definitions)
            warn_of_zero_by_support(model, line.effect, display_name(file_, console.tr()), console);
    if (is_described_) {
        std::string words;
        for (std::size_t i = 0; i < found.lines.size(); ++i)
            words += line_in_words(model, definitions[i], found.lines[i],
                                   units_.of_pictures(draw_options(console.tr())));
        return words;
    }
    if (is_json_) return femoop::influence::lines_json(model, definitions, found.lines, n);
    std::vector<femoop::influence::LineUnits> units;
    for (const InfluenceLineDefinition& line : definitions) units.push_back(units_.of_line(model, line, console.tr()));
    return femoop::influence::lines_text(model, definitions, found.lines, units, n, console.tr());
}

ExitStatus Influence::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (file_.empty()) throw no_file("influence", tr);
    asked_.require_sensible(tr);
    if (is_json_ && is_described_) throw ask_for_different_things("--json", "--describe", tr);
    if (is_json_ && units_.are_given()) throw units_of_file("--json", tr);
    if (asked_.is_asked() && !lines_.empty()) throw ask_for_different_things("--line", asked_.option(), tr);
    const std::optional<Model> model = load_model(file_, console);
    if (!model) return ExitStatus::BadInput;
    try {
        std::vector<InfluenceLineDefinition> lines;
        if (asked_.is_asked()) lines = {asked_line(*model, console)};
        else lines = of_file(*model, console);
        if (path_ && !asked_.is_asked())
            for (InfluenceLineDefinition& line : lines) line.path = path_named(*model, *path_, tr);
        if (asked_.is_asked() || path_) {
            const std::vector<Fault> faults = check_line(*model, lines.front(), {asked_.option(), {}});
            console.report(display_name(file_, tr), faults);
            if (std::ranges::any_of(faults, femoop::is_error)) return ExitStatus::BadInput;
        }
        console.print(output(*model, lines, console));
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, display_name(file_, tr), console);
    }
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> influence_command() { return std::make_unique<Influence>(); }

} // namespace cli
