#include "apps/cli/cross.h"

#include <optional>
#include <string>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_file.h"
#include "apps/cross/report/calculation.h"
#include "femoop/io/cross/cross_block.h"
#include "femoop/io/cross/cross_json.h"
#include "femoop/io/cross/cross_table.h"
#include "femoop/io/cross/other_methods.h"
#include "ui/report/html.h"
#include "ui/report/pages.h"

namespace cli {

namespace {

using femoop::Model;
using femoop::cross::Block;
using femoop::cross::Extent;
using femoop::cross::FarEnds;
using femoop::cross::Problem;
using femoop::cross::Procedure;

class Cross : public Subcommand {
public:
    std::string_view name() const override { return "cross"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void require_sensible(const ui::Catalogue& tr) const;
    FarEnds far_ends(const Model& model, femoop::CaseId load_case, const std::optional<Block>& block) const;
    Extent extent(const std::optional<Block>& block) const;
    Procedure procedure(const Model& model, const Problem& problem, const std::optional<Block>& block,
                        const ui::Catalogue& tr) const;
    std::string output(const Model& model, const ui::Catalogue& tr) const;

    std::string file_;
    void write_report(const Model& model, Console& console) const;
    std::string method_ = "cross";
    std::optional<std::string> case_, order_, tolerance_, digits_, report_;
    bool is_unmodified_ = false, is_modified_ = false, is_by_halves_ = false, is_whole_ = false;
    bool is_json_ = false, is_csv_ = false;
};

HelpText Cross::help(const ui::Catalogue& tr) const
{
    return {
        tr("distribute the moments of a beam or frame as by hand and print the sheet"),
        tr("Works Hardy Cross's moment distribution on a continuous beam or plane frame "
           "and prints every number of it: stiffness and distribution factors, fixed-end moments of every load, each "
           "balance (BAL) and carry-over (CO), totals, and the final moments beside those of the stiffness method. "
           "Moments act on the member ends, counter-clockwise positive; AB is the end at A of the member "
           "between A and B. A frame that sways is held by props first; then each sway has a sheet of its own, and "
           "the shear equations say how much of each is added. Members are taken as axially rigid.\n\nA \"cross\" "
           "block of the file gives the defaults, and `cremona verify` compares the sheet that stands in it."),
        {{"cremona cross examples/continuous_beam.json", tr("The joint with the largest unbalance first.")},
         {"cremona cross examples/continuous_beam.json --order all-at-once --digits 4",
          tr("All joints at once, every number rounded to four digits as on paper, with what that costs.")},
         {"cremona cross examples/portal_kleinlogel.json --symmetry",
          tr("Half of a symmetric portal, with 2EI/L for the beam across the axis: one balance.")},
         {"cremona cross examples/portal.json --json",
          tr("A frame that sways: its sheets and equations, for a program.")}}};
}

void Cross::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", file_, tr("the model file; - is standard input")).option_text(" ");
    options.add_option("--case", case_, tr("the load case or combination (default the first)")).option_text("ID");
    options
        .add_option("--order", order_,
                    tr("which joint is balanced next: largest (the one with the largest unbalance, "
                       "default), left-to-right, all-at-once, or names of joints in turn, again and again: A,C,B"))
        .option_text("ORDER");
    options
        .add_option("--tolerance", tolerance_,
                    tr("stop when no unbalance is larger, "
                       "in the file's unit of moments (default 0.001 of the largest fixed-end moment)"))
        .option_text("T");
    options.add_option("--digits", digits_, tr("round every number to so many significant digits (default all)"))
        .option_text("D");
    options.add_option("--method", method_, tr("cross (default), or on the same structure kani or slope-deflection"))
        .option_text("NAME");
    options
        .add_option("--report", report_,
                    tr("write the whole calculation with its pictures as a report: OUT.html or OUT.report.pdf"))
        .option_text("OUT");
    options.add_flag("--unmodified", is_unmodified_,
                     tr("lock hinged and overhanging far ends too, instead of taking 3EI/L for their members"));
    options.add_flag("--modified", is_modified_, tr("do not, though the file's block locks them"));
    options.add_flag("--symmetry", is_by_halves_,
                     tr("balance half of a symmetric structure, with 2EI/L or 6EI/L where members cross the axis"));
    options.add_flag("--whole", is_whole_, tr("balance every joint, though the file's block asks for half"));
    options.add_flag("--json", is_json_, tr("print JSON instead of tables"));
    options.add_flag("--csv", is_csv_, tr("print the rows of the sheet for a spreadsheet"));
}

void Cross::require_sensible(const ui::Catalogue& tr) const
{
    if (file_.empty()) throw no_file("cross", tr);
    const auto refuse = [&](bool are_both, const std::string& a, const std::string& b) {
        if (are_both) throw print_different_things(a, b, tr);
    };
    refuse(is_json_ && is_csv_, "--json", "--csv");
    refuse(is_csv_ && method_ != "cross", "--csv", "--method " + method_);
    refuse(report_ && method_ != "cross", "--report", "--method " + method_);
    refuse(report_ && is_json_, "--report", "--json");
    refuse(report_ && is_csv_, "--report", "--csv");
    if (method_ != "cross" && method_ != "kani" && method_ != "slope-deflection")
        throw not_one_of("--method", method_, "cross, kani, slope-deflection", tr);
    if (report_ && !report_->ends_with(".html") && !report_->ends_with(".report.pdf"))
        throw UsageError(tr("{option}: found \"{found}\", wanted a name that ends with {endings}",
                            {{"option", "--report"}, {"found", *report_}, {"endings", ".html, .report.pdf"}}));
    if (is_modified_ && is_unmodified_) throw contradiction("--modified", "--unmodified", tr);
    if (is_by_halves_ && is_whole_) throw contradiction("--symmetry", "--whole", tr);
    if (is_by_halves_ && method_ != "cross") throw contradiction("--symmetry", "--method " + method_, tr);
}

FarEnds Cross::far_ends(const Model& model, femoop::CaseId load_case, const std::optional<Block>& block) const
{
    if (is_unmodified_) return FarEnds::Plain;
    return block && !is_modified_ ? far_ends_of(model, load_case, *block) : FarEnds::Modified;
}

/// Kani's method and the equations are of the whole.
Extent Cross::extent(const std::optional<Block>& block) const
{
    if (is_by_halves_) return Extent::Half;
    return is_whole_ || method_ != "cross" ? Extent::Whole : extent_of(block);
}

Procedure Cross::procedure(const Model& model, const Problem& problem, const std::optional<Block>& block,
                           const ui::Catalogue& tr) const
{
    Procedure procedure;
    if (block) procedure = procedure_of(model, problem, *block);
    if (order_) {
        if (order_->empty()) throw not_one_of("--order", "", "largest, left-to-right, all-at-once, A,C,B", tr);
        set_order(procedure, *order_, model, problem);
        procedure.balances.reset();
    }
    if (tolerance_) {
        procedure.tolerance = positive_number("--tolerance", *tolerance_, tr);
        procedure.balances.reset();
    }
    if (digits_) procedure.digits = static_cast<int>(whole_number("--digits", *digits_, {1, 16}, tr));
    return procedure;
}

std::string Cross::output(const Model& model, const ui::Catalogue& tr) const
{
    const std::optional<Block> block = femoop::cross::block_of(model);
    const femoop::CaseId load_case = case_ ? find_case(model, *case_, tr) : case_of(model, block);
    const Problem problem = femoop::cross::problem_of(model, load_case, far_ends(model, load_case, block),
                                                      extent(block));
    if (method_ == "kani") {
        const auto kani = femoop::cross::kani(model, problem);
        return is_json_ ? kani_json(model, problem, kani) : kani_text(model, problem, kani, tr);
    }
    if (method_ == "slope-deflection") {
        const auto equations = femoop::cross::slope_deflection(model, problem);
        return is_json_ ? equations_json(model, problem, equations) : equations_text(model, problem, equations, tr);
    }
    const Procedure own = procedure(model, problem, block, tr);
    const auto all = femoop::cross::superpose(model, problem, own);
    const auto comparison = femoop::cross::compare(model, problem, all.moments);
    const femoop::cross::Worked worked{model, problem, own, all, comparison};
    if (is_json_) return femoop::cross::sheet_json(worked);
    return is_csv_ ? femoop::cross::sheet_csv(worked) : femoop::cross::sheet_text(worked, tr);
}

/// The document of the app that these options mean.
void Cross::write_report(const Model& model, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const std::optional<Block> block = femoop::cross::block_of(model);
    const femoop::CaseId load_case = case_ ? find_case(model, *case_, tr) : case_of(model, block);
    const FarEnds ends = far_ends(model, load_case, block);
    const Problem problem = femoop::cross::problem_of(model, load_case, ends, extent(block));
    const Procedure own = procedure(model, problem, block, tr);
    ::cross::Document document{.model = model};
    document.method = {.load_case = load_case,
                       .order = own.order,
                       .joints = {},
                       .tolerance = own.tolerance,
                       .digits = own.digits,
                       .far_ends = ends,
                       .extent = extent(block)};
    for (const femoop::cross::JointId joint : own.joints)
        document.method.joints.push_back(model[problem[joint].node].id);
    const ui::Fonts fonts;
    ::cross::Look look;
    look.tr = tr;
    const ui::Report report = ::cross::calculation(document, look, fonts);
    require_writable(*report_, tr);
    if (report_->ends_with(".html")) write_file(*report_, ui::report_html(report, fonts), tr);
    else
        ui::write_pdf(*report_, ui::report_pages(report, fonts), fonts,
                      {.background = ui::rgb(0xFFFFFF), .title = report.title});
    console.message(tr("written: {file}", {{"file", *report_}}));
}

ExitStatus Cross::run(Console& console)
{
    require_sensible(console.tr());
    const std::optional<Model> model = load_model(file_, console);
    if (!model) return ExitStatus::BadInput;
    try {
        if (report_) write_report(*model, console);
        else console.print(output(*model, console.tr()));
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, display_name(file_, console.tr()), console);
    }
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> cross_command() { return std::make_unique<Cross>(); }

} // namespace cli
