#include "apps/cli/truss.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/asked_units.h"
#include "apps/cli/model_input.h"
#include "femoop/io/truss/truss_json.h"
#include "femoop/io/truss/truss_sentence.h"
#include "femoop/io/truss/truss_text.h"

namespace cli {

namespace {

using femoop::Model;
using femoop::truss::Refusal;

class Truss : public Subcommand {
public:
    std::string_view name() const override { return "truss"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void require_sensible(const ui::Catalogue& tr) const;
    bool is_by(std::string_view method) const
    {
        return method_ == method || (!method_ && cut_ && method == "sections");
    }
    std::variant<std::string, Refusal> output(const Model& model, const femoop::Results& results,
                                              const ui::Catalogue& tr) const;

    std::string file_;
    std::optional<std::string> case_, method_, cut_;
    AskedUnits units_;
    bool is_json_ = false, is_latex_ = false;
};

HelpText Truss::help(const ui::Catalogue& tr) const
{
    return {
        tr("work out a plane truss by hand: zero-force bars, joints, sections, Cremona diagram"),
        tr("Takes a statically determinate plane truss apart as on paper. Joint by joint, in an order in which each "
           "joint has at most two unknown bars, with equations and force polygon; by a section, with the Ritter point "
           "and lever arm of each bar; or by the reciprocal diagram of Maxwell and Cremona, with Bow's notation. Bars "
           "that carry nothing are found first, each with its rule. What the method cannot do is refused with the "
           "reason."),
        {{"cremona truss examples/truss.json", tr("Joint by joint.")},
         {"cremona truss examples/pratt_truss.json --cut U2U3,U2L3,L2L3", tr("Three bars by one section.")},
         {"cremona truss examples/truss.json --method cremona",
          tr("The Cremona diagram: spaces, points, sides, and how they are read.")},
         {"cremona truss examples/pratt_truss.json --method zero-force",
          tr("The bars that carry nothing, with the rule of each.")},
         {"cremona truss examples/truss.json --latex", tr("The same sheet for a LaTeX document.")}}};
}

void Truss::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", file_, tr("the model file; - is standard input")).option_text(" ");
    options.add_option("--case", case_, tr("the load case or combination (default the first)")).option_text("ID");
    options.add_option("--method", method_, tr("joints (default), zero-force, sections (needs --cut) or cremona"))
        .option_text("NAME");
    options
        .add_option("--cut", cut_,
                    tr("the bars that a section cuts, separated by commas: each is found by itself if the "
                       "others meet in one point or are parallel"))
        .option_text("BARS");
    units_.declare(options, tr);
    options.add_flag("--json", is_json_, tr("print JSON instead of text"));
    options.add_flag("--latex", is_latex_, tr("print the body of a LaTeX document instead of text"));
}

void Truss::require_sensible(const ui::Catalogue& tr) const
{
    if (file_.empty()) throw no_file("truss", tr);
    if (is_json_ && units_.are_given()) throw units_of_file("--json", tr);
    if (is_json_ && is_latex_) throw print_different_things("--json", "--latex", tr);
    constexpr std::array<std::string_view, 4> methods{"zero-force", "joints", "sections", "cremona"};
    if (method_ && std::ranges::find(methods, *method_) == methods.end())
        throw not_one_of("--method", *method_, "zero-force, joints, sections, cremona", tr);
    if (cut_ && !is_by("sections")) throw contradiction("--cut", "--method " + *method_, tr);
    if (!cut_ && is_by("sections")) throw needs_too("--method sections", "--cut", tr);
}

std::variant<std::string, Refusal> Truss::output(const Model& model, const femoop::Results& results,
                                                 const ui::Catalogue& tr) const
{
    using namespace femoop::truss;
    if (const auto refusal = why_no_truss(model, results)) return *refusal;
    const femoop::CaseId load_case = case_ ? find_case(model, *case_, tr) : femoop::CaseId(0);
    const femoop::truss::Truss truss = truss_of(model, results, load_case);
    const auto written = [&](const Sheet& sheet) { return is_latex_ ? latex(sheet) : plain_text(sheet, tr); };
    if (is_by("sections")) {
        const std::vector<femoop::MemberId> bars = members_named("--cut", comma_list(*cut_), model, tr);
        if (const auto refusal = why_no_cut(truss, bars)) return *refusal;
        return is_json_ ? cut_json(model, truss, load_case, bars, tr)
                        : written(cut_sheet(model, truss, load_case, bars, tr));
    }
    if (is_by("zero-force"))
        return is_json_ ? zero_force_json(model, truss, load_case, tr)
                        : written(zero_force_sheet(model, truss, load_case, tr));
    if (is_by("cremona")) {
        if (const auto refusal = why_no_reciprocal(truss)) return *refusal;
        return is_json_ ? diagram_json(model, truss, load_case, tr)
                        : written(diagram_sheet(model, truss, load_case, tr));
    }
    return is_json_ ? joint_json(model, truss, load_case, tr) : written(joint_sheet(model, truss, load_case, tr));
}

ExitStatus Truss::run(Console& console)
{
    require_sensible(console.tr());
    std::optional<Model> model = load_model(file_, console);
    if (!model) return ExitStatus::BadInput;
    if (units_.are_given()) model = units_.in_one_system(*model, "cremona truss", console.tr());
    const std::string file = display_name(file_, console.tr());
    auto solved = solve_model(*model, file, {}, console);
    if (const auto* status = std::get_if<ExitStatus>(&solved)) return *status;
    auto output = this->output(*model, std::get<Solved>(solved).results, console.tr());
    if (const auto* refusal = std::get_if<Refusal>(&output))
        throw UsageError(file + ": " + femoop::truss::sentence(*refusal, *model, console.tr()));
    console.print(std::get<std::string>(std::move(output)));
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> truss_command() { return std::make_unique<Truss>(); }

} // namespace cli
