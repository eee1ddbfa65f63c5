#include "apps/cli/train.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/asked_effect.h"
#include "apps/cli/asked_units.h"
#include "apps/cli/model_input.h"
#include "apps/cli/moving_picture.h"
#include "apps/cli/picture.h"
#include "apps/cli/train_why.h"
#include "femoop/io/train/train_block.h"
#include "femoop/io/train/train_json.h"
#include "femoop/io/train/train_table.h"

namespace cli {

namespace {

using femoop::ExpectedQuantity;
using femoop::Model;
using femoop::MovingEffect;
using femoop::MovingEnvelope;
using femoop::influence::TrainAnalysis;
using femoop::influence::TrainResults;

/// What is asked for: of these trains and envelopes, these effects.
struct Question {
    std::vector<const femoop::Train*> trains;
    std::vector<const MovingEnvelope*> envelopes;
    std::vector<MovingEffect> effects, extremes;
};

class Train : public Subcommand {
public:
    std::string_view name() const override { return "train"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void choose_loads(Question& question, const Model& model, const std::optional<femoop::influence::TrainBlock>& block,
                      const ui::Catalogue& tr) const;
    void choose_effects(Question& question, const Model& model, const ui::Catalogue& tr) const;
    std::vector<TrainResults> results(const Question& question, TrainAnalysis& analysis) const;
    void answer(const Model& model, Console& console) const;
    void explain(const Question& question, const Model& model, Console& console) const;
    void describe(Question question, const Model& model, Console& console) const;

    std::string file_, stations_ = "11";
    std::vector<std::string> trains_, envelopes_;
    AskedEffect asked_;
    AskedUnits units_;
    std::optional<std::string> why_;
    bool is_json_ = false, is_proved_ = false, is_described_ = false;
};

HelpText Train::help(const ui::Catalogue& tr) const
{
    return {
        tr("move trains of loads over a structure and print where they are worst"),
        tr("Moves every train of the file (axles at fixed or variable distances, uniform load, single forces) "
           "along its path and prints the largest and least value of each effect, and where the axles stand then. "
           "The effect of the axles is a polynomial between the positions at which one of them passes the end of "
           "a piece of the influence line: all these positions and the roots of the derivative between them are "
           "looked at, nothing is sampled. Without an effect to look for, every section force at some sections of "
           "each member, every reaction, and the worst of all sections of each member are printed. A \"train\" "
           "block of the file is printed too, and `cremona verify` compares the answers that stand in it."),
        {{"cremona train examples/bridge.json", tr("Every train and envelope of the file.")},
         {"cremona train examples/bridge.json --train HS20 --member BC --at 50% --component M --proof",
          tr("One moment, with all candidates and their values.")},
         {"cremona train examples/bridge.json --member BC --component M", tr("The worst of all sections of a member.")},
         {"cremona train examples/bridge.json --envelope \"deck + G\" --why member=BC,at=50%,component=M",
          tr("Which train governs a number of an envelope, where it stands, and what its forces come to.")},
         {"cremona train examples/bridge.json --envelope \"deck + G\" --json",
          tr("Permanent load and the worst of the trains, for a program.")}}};
}

void Train::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", file_, tr("the model file; - is standard input")).option_text(" ");
    options.add_option("--train", trains_, tr("this train alone; may be given again"))
        .option_text("ID")
        .one_value_each();
    options.add_option("--envelope", envelopes_, tr("this envelope alone; may be given again"))
        .option_text("ID")
        .one_value_each();
    asked_.declare(options, tr);
    options.add_option("--stations", stations_, tr("how many sections of each member are looked at (default 11)"))
        .option_text("N");
    units_.declare(options, tr);
    options.add_flag("--proof", is_proved_, tr("print breaks and roots, and the value at each of them"));
    options
        .add_option(
            "--why", why_,
            tr("print where one number of a train or an envelope comes from: member=M,at=X,component=C (without at: "
               "where it is worst) or node=N,component=fy; which train governs and where it stands, its forces "
               "times the ordinates of the line, and the analysis with the train standing there"))
        .option_text("WHAT");
    options.add_flag("--json", is_json_, tr("print JSON with every digit instead of tables"));
    options.add_flag(
        "--describe", is_described_,
        tr("print sentences instead of tables, for a screen reader: of the effect that is asked for, else of the "
           "one that `render` draws; of an envelope the largest and least of every component and reaction"));
}

void Train::choose_loads(Question& question, const Model& model,
                         const std::optional<femoop::influence::TrainBlock>& block, const ui::Catalogue& tr) const
{
    std::vector<std::string> train_names, envelope_names;
    const bool is_all = trains_.empty() && envelopes_.empty();
    const auto take = [&](auto& chosen, const auto& part, const std::vector<std::string>& wanted, auto& names) {
        names.push_back(part.id);
        if (is_all || std::ranges::find(wanted, part.id) != wanted.end()) chosen.push_back(&part);
    };
    for (const femoop::Train& train : model.moving_loads.trains) take(question.trains, train, trains_, train_names);
    if (block) take(question.trains, block->train, trains_, train_names);
    for (const MovingEnvelope& envelope : model.moving_loads.envelopes)
        take(question.envelopes, envelope, envelopes_, envelope_names);
    const auto require = [&](const auto& wanted, const auto& names, std::string_view option) {
        for (const std::string& name : wanted)
            if (std::ranges::find(names, name) == names.end()) throw unknown_choice(option, name, names, tr);
    };
    require(trains_, train_names, "--train");
    require(envelopes_, envelope_names, "--envelope");
    if (question.trains.empty() && question.envelopes.empty())
        throw UsageError(tr("the file has no train; add one to \"trains\", or a block \"train\""));
    if (is_proved_ && question.trains.empty())
        throw UsageError(tr("--proof is of one train's positions, and an envelope has the worst of them; ask for a "
                            "train by --train"));
}

void Train::choose_effects(Question& question, const Model& model, const ui::Catalogue& tr) const
{
    if (asked_.is_asked()) {
        const MovingEffect effect = asked_.sound_effect(model, tr);
        const bool is_extreme = effect.quantity == ExpectedQuantity::Extreme;
        if (is_extreme && is_proved_) throw needs_too("--proof", "--at", tr);
        (is_extreme ? question.extremes : question.effects).push_back(effect);
        return;
    }
    const auto n = static_cast<std::size_t>(whole_number("--stations", stations_, {2, 100000}, tr));
    question.effects = femoop::influence::default_effects(model, n);
    question.extremes = femoop::influence::default_extremes(model);
}

std::vector<TrainResults> Train::results(const Question& question, TrainAnalysis& analysis) const
{
    std::vector<TrainResults> all;
    const auto add = [&](const auto& loads, bool is_envelope) {
        TrainResults& results = all.emplace_back();
        results.id = loads.id;
        results.is_envelope = is_envelope;
        results.effects = analysis.effects(loads, question.effects);
        for (const MovingEffect& effect : question.extremes)
            results.extremes.push_back(analysis.extreme(loads, effect));
    };
    for (const femoop::Train* train : question.trains) {
        add(*train, false);
        if (!is_proved_) continue;
        for (const MovingEffect& effect : question.effects) {
            const auto search = analysis.search(*train, effect);
            all.back().proofs.push_back(
                {search.proof(femoop::ExtremeKind::Max), search.proof(femoop::ExtremeKind::Min)});
        }
    }
    for (const MovingEnvelope* envelope : question.envelopes) add(*envelope, true);
    return all;
}

/// \throws UsageError where the worst sections would be looked for too long
void require_searchable(const Question& question, const Model& model, const ui::Catalogue& tr)
{
    double size = 0.0;
    const auto add = [&](const femoop::Train& train) {
        size += static_cast<double>(question.extremes.size()) * femoop::influence::search_size(model, train);
        if (!(size > femoop::influence::most_search_size)) return;
        const std::string members = std::to_string(femoop::influence::members_of(model, train.path).size());
        if (train.spacing_ranges.empty())
            throw UsageError(tr(
                "{train}: with {axles} axles and {members} members on its path the worst sections would be looked for "
                "too long. Ask for one section by --member, --at and --component, or leave axles out",
                {{"train", train.id}, {"axles", std::to_string(train.axles.size())}, {"members", members}}));
        throw UsageError(tr(
            "{train}: {count} spacings vary; with {members} members on its path the worst sections would be looked for "
            "too long. Ask for one section by --member, --at and --component, or let fewer spacings vary",
            {{"train", train.id}, {"count", std::to_string(train.spacing_ranges.size())}, {"members", members}}));
    };
    for (const femoop::Train* train : question.trains) add(*train);
    for (const MovingEnvelope* envelope : question.envelopes)
        for (const femoop::TrainId id : envelope->trains) add(model.moving_loads.trains[id.index]);
}

/// \throws UsageError where so many sections would be looked at that it takes minutes
void require_few_sections(const Question& question, const Model& model, const ui::Catalogue& tr)
{
    constexpr double most = 1e6; // axles times effects: some 3e4 a second
    double n_axles = 0.0;
    const auto add = [&](const femoop::Train& train) {
        n_axles += static_cast<double>(std::max<std::size_t>(1, train.axles.size()));
    };
    for (const femoop::Train* train : question.trains) add(*train);
    for (const MovingEnvelope* envelope : question.envelopes)
        for (const femoop::TrainId id : envelope->trains) add(model.moving_loads.trains[id.index]);
    if (n_axles * static_cast<double>(question.effects.size()) <= most) return;
    throw UsageError(
        tr("--stations: {count} section forces and reactions would be looked at, each under all trains, for "
           "minutes. Ask for fewer sections, or for one effect by --member, --at and --component",
           {{"count", std::to_string(question.effects.size())}}));
}

void Train::explain(const Question& question, const Model& model, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    if (question.trains.size() + question.envelopes.size() != 1)
        throw UsageError(tr("--why: the number is of one train or envelope; name it by --train or --envelope"));
    AskedEffect asked;
    asked.set("--why", *why_, tr);
    asked.require_sensible(tr, AskedEffect::Place::Optional);
    const TrainNumber number{.train = question.trains.empty() ? nullptr : question.trains.front(),
                             .envelope = question.envelopes.empty() ? nullptr : question.envelopes.front(),
                             .effect = asked.sound_effect(model, tr)};
    console.print(train_why(model, number, is_json_, console));
}

void Train::describe(Question question, const Model& model, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const drawing::DrawOptions options = units_.of_pictures(draw_options(tr));
    const std::string file = display_name(file_, tr);
    std::optional<MovingEffect> asked;
    if (asked_.is_asked()) asked = asked_.sound_effect(model, tr);
    if (is_proved_ && asked && asked->quantity == ExpectedQuantity::Extreme) throw needs_too("--proof", "--at", tr);
    question.extremes = femoop::influence::default_extremes(model);
    if (asked) question.extremes.clear();
    require_searchable(question, model, tr);
    for (const femoop::Train* train : question.trains)
        console.print(
            train_in_words(model, *train, {.effect = asked, .is_proved = is_proved_}, options, file, console));
    for (const MovingEnvelope* envelope : question.envelopes)
        console.print(envelope_in_words(model, *envelope, asked, options, file, console));
}

void Train::answer(const Model& model, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const auto block = femoop::influence::train_block_of(model);
    Question question;
    choose_loads(question, model, block, tr);
    if (why_) return explain(question, model, console);
    if (is_described_) return describe(question, model, console);
    choose_effects(question, model, tr);
    require_searchable(question, model, tr);
    require_few_sections(question, model, tr);
    TrainAnalysis analysis(model);
    const std::vector<TrainResults> all = results(question, analysis);
    console.report(display_name(file_, tr), analysis.warnings());
    if (asked_.is_asked()) // of all reactions those that are held are among them
        for (const MovingEffect& effect : question.effects)
            warn_of_zero_by_support(model, effect, display_name(file_, tr), console);
    console.print(is_json_ ? femoop::influence::trains_json(model, all)
                           : femoop::influence::trains_text(model, all, units_.of_results(model, tr), tr));
}

ExitStatus Train::run(Console& console)
{
    if (file_.empty()) throw no_file("train", console.tr());
    asked_.require_sensible(console.tr(), AskedEffect::Place::Optional);
    if (why_ && is_described_) throw ask_for_different_things("--why", "--describe", console.tr());
    if (why_ && is_proved_) throw ask_for_different_things("--why", "--proof", console.tr());
    if (why_ && asked_.is_asked()) throw ask_for_different_things("--why", asked_.option(), console.tr());
    if (is_json_ && is_described_) throw ask_for_different_things("--json", "--describe", console.tr());
    if (is_json_ && units_.are_given()) throw units_of_file("--json", console.tr());
    std::optional<Model> model = load_model(file_, console);
    if (!model) return ExitStatus::BadInput;
    if (why_ && units_.are_given()) {
        if (!model->extra.empty()) throw units_of_file("\"" + model->extra.front().key + "\"", console.tr());
        why_ = with_unit(*why_, femoop::name(model->units.length), "at=");
        model = units_.in_one_system(*model, "--why", console.tr());
    }
    try {
        answer(*model, console);
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, display_name(file_, console.tr()), console);
    }
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> train_command() { return std::make_unique<Train>(); }

} // namespace cli
