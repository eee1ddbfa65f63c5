#include "apps/cli/moving_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/asked_units.h"
#include "apps/drawing/draw.h"
#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/influence_words.h"
#include "apps/drawing/results/line_motion.h"
#include "apps/drawing/results/range_words.h"
#include "apps/drawing/results/train_picture.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/io/influence/influence_block.h"
#include "femoop/io/train/train_block.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/train/standing_train.h"
#include "femoop/methods/influence/train/train_analysis.h"
#include "femoop/methods/influence/usual_path.h"

namespace cli {

namespace {

using drawing::Show;
using femoop::ExpectedQuantity;
using femoop::ExtremeKind;
using femoop::InfluenceLineDefinition;
using femoop::MemberComponent;
using femoop::Model;
using femoop::MovingEffect;
using femoop::influence::PathLayout;
using femoop::influence::TrainAnalysis;

/// The part of this id. \throws UsageError with those that there are
template <class Part>
const Part& named(const std::vector<Part>& parts, const std::string& id, std::string_view option,
                  const ui::Catalogue& tr)
{
    const auto found = std::ranges::find(parts, id, &Part::id);
    if (found != parts.end()) return *found;
    std::vector<std::string> names;
    for (const Part& part : parts) names.push_back(part.id);
    throw unknown_choice(option, id, names, tr);
}

InfluenceLineDefinition line_named(const Model& model, const std::string& id, const ui::Catalogue& tr)
{
    std::vector<InfluenceLineDefinition> lines = model.moving_loads.influence_lines;
    if (const auto block = femoop::influence::block_of(model))
        for (const auto& check : block->lines) lines.push_back(check.line);
    return named(lines, id, "--influence", tr);
}

femoop::Train train_named(const Model& model, const std::string& id, const ui::Catalogue& tr)
{
    std::vector<femoop::Train> trains = model.moving_loads.trains;
    if (const auto block = femoop::influence::train_block_of(model)) trains.push_back(block->train);
    return named(trains, id, "--train", tr);
}

/// What a train is drawn for where nothing is asked: the largest bending moment on its path, of a truss the force.
bool is_foremost(const Model& model, const MovingEffect& effect)
{
    const bool bends = effect.component == MemberComponent::Mz || effect.component == MemberComponent::My;
    return is_truss(model.analysis) ? effect.component == MemberComponent::N : bends;
}

struct Worst {
    MovingEffect effect;
    double value = 0.0;
};

Worst worst_of(TrainAnalysis& analysis, const femoop::Train& train, const MovingEffect& extreme)
{
    const Model& model = analysis.unloaded();
    const femoop::influence::TrainExtreme found = analysis.extreme(train, extreme);
    const bool is_max = std::abs(found.max.placing.value) >= std::abs(found.min.placing.value);
    const femoop::influence::WorstSection& worst = is_max ? found.max : found.min;
    const double length = femoop::geometry_of(model, model[*extreme.member]).length;
    return {femoop::influence::at_section(extreme, worst.inside, length), worst.placing.value};
}

MovingEffect foremost_effect(TrainAnalysis& analysis, const Model& model, const femoop::Train& train)
{
    const std::vector<femoop::MemberId>& path = femoop::influence::members_of(model, train.path);
    std::optional<Worst> worst;
    for (const MovingEffect& extreme : femoop::influence::default_extremes(model)) {
        const bool is_on_path = std::ranges::find(path, *extreme.member) != path.end();
        if (!is_foremost(model, extreme) || (!is_on_path && !is_truss(model.analysis))) continue;
        Worst next = worst_of(analysis, train, extreme);
        if (!worst || std::abs(next.value) > std::abs(worst->value)) worst = std::move(next);
    }
    return worst->effect; // every path has a member, and each has its extremes
}

/// A train that stands, and the effect that is asked for.
struct Standing {
    MovingEffect effect;
    drawing::StandingTrain train;
    femoop::influence::WorstPlacings worst;
};

void write(const Model& model, const femoop::Results* results, const drawing::InfluencePicture& picture,
           const PictureOrder& order, const Console& console)
{
    const drawing::DrawInput input{
        .model = model, .results = results, .dimensions = order.dimensions, .influence = &picture};
    write_picture(
        order.file, backdrop_of(order, model), [&](ui::Painter& painter) { drawing::draw(painter, input, order.view); },
        console.tr());
}

/// Draws a train.
class TrainDrawing {
public:
    TrainDrawing(const Model& model, femoop::Train train, const std::string& file, const Console& console)
        : model_(model), train_(std::move(train)), file_(file), console_(console), analysis_(model)
    {}

    /// \param options  whose units a refusal is written in
    Standing standing(const std::optional<MovingEffect>& asked, const std::optional<std::string>& position,
                      const drawing::DrawOptions& options)
    {
        Standing standing{.effect = asked ? *asked : foremost_effect(analysis_, model_, train_)};
        if (standing.effect.quantity == ExpectedQuantity::Extreme)
            standing.effect = worst_of(analysis_, train_, standing.effect).effect;
        const auto search = analysis_.search(train_, standing.effect);
        standing.worst = search.worst();
        const bool is_max = std::abs(standing.worst.max.value) >= std::abs(standing.worst.min.value);
        standing.train = {.name = train_.id,
                          .train = femoop::influence::moving_train(train_, standing.effect),
                          .placing = is_max ? standing.worst.max : standing.worst.min,
                          .kind = is_max ? ExtremeKind::Max : ExtremeKind::Min};
        if (position) stand_at(standing.train, search, *position, options);
        return standing;
    }

    ExitStatus draw(const Standing& standing, PictureOrder order, bool shows_own)
    {
        if (!shows_own) {
            order.view.show = drawing::shown_by_default;
            order.view.show.insert(is_truss(model_.analysis) ? Show::N : Show::M);
            if (!is_truss(model_.analysis)) order.view.show.insert(Show::V);
        }
        order.view.show.insert(Show::Influence);
        order.view.load_case = femoop::CaseId(0);
        order.view.is_envelope = false;
        drawing::InfluencePicture picture = line_under(standing);
        picture.sentences = train_sentences(model_, order.view, picture, standing.train);
        Model loaded = analysis_.unloaded();
        const drawing::StandingTrain& train = standing.train;
        loaded.load_cases = {standing_train(train.name, picture.path, picture.load, train.train, train.placing,
                                            picture.line, train.kind)};
        const femoop::Results results = femoop::analyse(loaded);
        console_.report(file_, results.warnings());
        write(loaded, &results, picture, order, console_);
        return ExitStatus::Done;
    }

    std::string words(const Standing& standing, const drawing::DrawOptions& options)
    {
        const drawing::InfluencePicture picture = line_under(standing);
        console_.report(file_, analysis_.warnings());
        return influence_words(model_, options, picture) +
               train_words(model_, options, picture, standing.train, standing.worst);
    }

    std::string proof(const Standing& standing, const drawing::DrawOptions& options)
    {
        const auto search = analysis_.search(train_, standing.effect);
        return proof_words(model_, options, standing.effect,
                           {search.proof(ExtremeKind::Max), search.proof(ExtremeKind::Min)});
    }

private:
    drawing::InfluencePicture line_under(const Standing& standing)
    {
        drawing::InfluencePicture picture{.path = analysis_.path(train_),
                                          .load = femoop::influence::unit_load(model_.analysis, train_.load),
                                          .line = analysis_.line(train_, standing.effect)};
        stand_on(picture, standing.train);
        return picture;
    }

    void stand_at(drawing::StandingTrain& standing, const femoop::influence::TrainSearch& search,
                  const std::string& text, const drawing::DrawOptions& options) const
    {
        const ui::Catalogue& tr = console_.tr();
        if (standing.train.axles.empty())
            throw UsageError(tr("--at-position: {train} has no axles; leave the option out", {{"train", train_.id}}));
        const double position = length_named("--at-position", text, model_).value();
        const double most = search.positions(false).to;
        if (!(position >= 0.0 && position <= most))
            throw UsageError(tr("--at-position: found {found}; wanted 0 to {most}, where some axle is on the path",
                                {{"found", with_unit(text, femoop::name(model_.units.length))},
                                 {"most", display_units(model_, options).text(most, ui::Measure::Length)}}));
        standing.placing = search.at({.position = position}, standing.kind);
        standing.is_worst = false;
    }

    const Model& model_;
    femoop::Train train_;
    const std::string& file_;
    const Console& console_;
    TrainAnalysis analysis_;
};

ExitStatus draw_line(const Model& model, const InfluenceLineDefinition& definition, PictureOrder order, bool shows_own,
                     const std::string& file, const Console& console)
{
    femoop::influence::InfluenceAnalysis analysis(model);
    const PathLayout path = femoop::influence::lay_out(model, femoop::influence::members_of(model, definition.path));
    const femoop::NodeVector load = femoop::influence::unit_load(model.analysis, definition.load);
    drawing::InfluencePicture picture{.path = path,
                                      .load = load,
                                      .line = analysis.line(path, load, definition.effect),
                                      .motion = analysis.motion(definition.effect)};
    picture.sentences = motion_sentences(model, picture, order.view.tr);
    console.report(file, analysis.warnings());
    if (!shows_own) order.view.show = drawing::labels;
    order.view.show.insert(Show::Influence);
    const auto results = shows_own ? std::optional(femoop::analyse(model)) : std::nullopt;
    write(model, results ? &*results : nullptr, picture, order, console);
    return ExitStatus::Done;
}

} // namespace

std::string line_in_words(const Model& model, const InfluenceLineDefinition& definition,
                          const femoop::influence::InfluenceLine& line, const drawing::DrawOptions& options)
{
    const drawing::InfluencePicture picture{
        .path = femoop::influence::lay_out(model, femoop::influence::members_of(model, definition.path)),
        .load = femoop::influence::unit_load(model.analysis, definition.load),
        .line = line};
    return influence_words(model, options, picture);
}

void warn_of_zero_by_support(const Model& model, const MovingEffect& effect, const std::string& file,
                             const Console& console)
{
    const ui::Catalogue& tr = console.tr();
    const std::string component = femoop::influence::component_name(model.analysis, effect);
    const auto warn = [&](const std::string& sentence) {
        console.message(file + ": " + tr("warning") + ": " + sentence);
    };
    if (femoop::influence::is_unheld_reaction(model, effect))
        warn(tr("the support of node {node} does not hold {component}, so that this reaction is zero wherever the load "
                "stands; ask for a component that it holds",
                {{"node", model[*effect.node].id}, {"component", component}}));
    if (const auto node = femoop::influence::holding_support(model, effect))
        warn(tr("the support of node {node} holds {component}, so that this displacement is zero wherever the load "
                "stands; ask for one that it leaves free",
                {{"node", model[*node].id}, {"component", component}}));
}

std::string train_in_words(const Model& model, const femoop::Train& train, const TrainTold& told,
                           const drawing::DrawOptions& options, const std::string& file, const Console& console)
{
    TrainDrawing drawing(model, train, file, console);
    const Standing standing = drawing.standing(told.effect, {}, options);
    const std::string words = drawing.words(standing, options);
    return told.is_proved ? words + drawing.proof(standing, options) : words;
}

std::string envelope_in_words(const Model& model, const femoop::MovingEnvelope& envelope,
                              const std::optional<MovingEffect>& asked, const drawing::DrawOptions& options,
                              const std::string& file, const Console& console)
{
    TrainAnalysis analysis(model);
    femoop::influence::TrainResults results{.id = envelope.id, .is_envelope = true};
    const auto add = [&](const MovingEffect& effect) {
        if (effect.quantity == ExpectedQuantity::Extreme)
            results.extremes.push_back(analysis.extreme(envelope, effect));
        else results.effects.push_back(analysis.effects(envelope, {{effect}}).front());
    };
    if (asked) add(*asked);
    else {
        for (const MovingEffect& extreme : femoop::influence::default_extremes(model)) add(extreme);
        for (std::size_t i = 0; i < model.nodes.size(); ++i)
            for (const MovingEffect& reaction : femoop::influence::reactions_at(model, femoop::NodeId(i)))
                if (!femoop::influence::is_unheld_reaction(model, reaction)) add(reaction);
    }
    const ui::Catalogue& tr = console.tr();
    std::string words = range_words(
        model, options, results,
        tr("Envelope {name}: {loads}", {{"name", envelope.id}, {"loads", load_name(model, options, envelope)}}));
    if (envelope.with && results.effects.size() == 1) {
        const MovingEffect& effect = results.effects.front().effect;
        const std::string value =
            display_units(model, options).text(analysis.permanent(envelope, effect), drawing::measure_of(effect));
        words += "  " +
                 tr("{case} alone brings {value}",
                    {{"case", model.case_name(*envelope.with)}, {"value", drawing::with_minus(value)}}) +
                 ".\n";
    }
    console.report(file, analysis.warnings());
    return words;
}

void MovingPicture::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("--influence", line_, tr("draw this influence line on the structure, with ordinates and areas"))
        .option_text("ID");
    options
        .add_option("--train", train_,
                    tr("draw this train where it is worst, and the structure under it: for the effect that --member or "
                       "--node asks for, else for the largest bending moment on its path (of a truss, for the largest "
                       "force)"))
        .option_text("ID");
    options.add_option("--at-position", position_, tr("draw the train with its leading axle at this place of its path"))
        .option_text("S");
    effect_.declare(options, tr);
}

void MovingPicture::require_sensible(const ui::Catalogue& tr) const
{
    if (line_ && train_) throw ask_for_different_things("--influence", "--train", tr);
    const auto needs_train = [&](std::string_view option) {
        if (!train_) throw needs_too(option, "--train", tr);
    };
    if (position_) needs_train("--at-position");
    if (effect_.is_asked()) needs_train(effect_.option());
    effect_.require_sensible(tr, AskedEffect::Place::Optional);
}

ExitStatus MovingPicture::draw(const Model& model, const std::string& file, PictureOrder order, bool shows_own,
                               const Console& console) const
{
    try {
        if (line_)
            return draw_line(model, line_named(model, *line_, console.tr()), std::move(order), shows_own, file,
                             console);
        std::optional<MovingEffect> asked;
        if (effect_.is_asked()) asked = effect_.sound_effect(model, console.tr());
        TrainDrawing drawing(model, train_named(model, *train_, console.tr()), file, console);
        const Standing standing = drawing.standing(asked, position_, order.view);
        return drawing.draw(standing, std::move(order), shows_own);
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, file, console);
    }
}

} // namespace cli
