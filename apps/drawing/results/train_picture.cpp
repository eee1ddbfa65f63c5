#include "apps/drawing/results/train_picture.h"

#include "apps/drawing/results/line_motion.h"
#include "apps/drawing/results/moving_words.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/methods/influence/train/standing_train.h"
#include "femoop/result/magnitudes.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace drawing {

namespace {

/// What is said of one train.
class TrainSentences {
public:
    TrainSentences(const femoop::Model& model, const DrawOptions& options, const InfluencePicture& picture,
                   const StandingTrain& standing)
        : model_(model),
          options_(options),
          picture_(picture),
          standing_(standing),
          units_(display_units(model, options))
    {}

    std::string value() const
    {
        const ui::Catalogue& tr = options_.tr;
        const femoop::MovingEffect& effect = picture_.line.effect;
        std::string said = tr("{effect} = {value} under {train}",
                              {{"effect", effect_text(model_, units_, effect)},
                               {"value", text(standing_.placing.value, measure_of(effect))},
                               {"train", standing_.name}});
        if (standing_.is_worst)
            said += ", " +
                    (standing_.kind == femoop::ExtremeKind::Max ? tr("its largest value") : tr("its least value"));
        return said;
    }

    std::string leading_axle() const
    {
        const femoop::influence::Placing& placing = standing_.placing;
        return placing.position ? leading_axle_words(options_, units_, *placing.position, placing.reversed) : "";
    }

    std::string value_and_places() const
    {
        const femoop::influence::MovingTrain& train = standing_.train;
        return with_places(value(), options_, units_, standing_.placing, !train.axles.empty(), train.uniform != 0.0);
    }

    /// Nothing where it is too long to read.
    std::string sum() const
    {
        constexpr std::size_t most_terms = 12;
        const double ordinate = ordinate_unit(units_, picture_).factor;
        const double area = units_.unit(measure_of(picture_.line.effect)).factor /
                            units_.unit(ui::Measure::ForcePerLength).factor;
        std::vector<std::string> terms;
        for (const auto& force : picture_.forces)
            terms.push_back(product(force.force, ui::Measure::Force, force.ordinate * ordinate));
        for (const double covered : covered_areas(standing_.placing, picture_.line.ordinates))
            terms.push_back(product(standing_.train.uniform, ui::Measure::ForcePerLength, covered * area));
        if (terms.empty() || terms.size() > most_terms) return {};
        std::string sum;
        for (const std::string& term : terms) sum += (sum.empty() ? "= " : " + ") + term;
        return sum;
    }

private:
    std::string text(double value, ui::Measure measure) const { return with_minus(units_.text(value, measure)); }

    std::string product(double load, ui::Measure measure, double factor) const
    {
        const std::string second = with_minus(units_.number(factor, ui::Measure::Plain));
        return with_minus(units_.number(load, measure)) + " × " + (factor < 0.0 ? "(" + second + ")" : second);
    }

    const femoop::Model& model_;
    const DrawOptions& options_;
    const InfluencePicture& picture_;
    const StandingTrain& standing_;
    ui::DisplayUnits units_;
};

} // namespace

void stand_on(InfluencePicture& picture, const StandingTrain& standing)
{
    picture.forces = standing_forces(standing.train, standing.placing, picture.line.ordinates, standing.kind);
    const double largest = picture.line.ordinates.largest();
    for (auto& force : picture.forces) force.ordinate = femoop::without_rounding(force.ordinate, largest);
}

std::string train_sentence(const femoop::Model& model, const DrawOptions& options, const InfluencePicture& picture,
                           const StandingTrain& standing)
{
    return TrainSentences(model, options, picture, standing).value_and_places();
}

std::vector<std::string> train_sentences(const femoop::Model& model, const DrawOptions& options,
                                         const InfluencePicture& picture, const StandingTrain& standing)
{
    const TrainSentences said(model, options, picture, standing);
    const std::string leading = said.leading_axle();
    std::vector<std::string> sentences{leading.empty() ? said.value() : said.value() + ": " + leading};
    if (std::string sum = said.sum(); !sum.empty()) sentences.push_back(std::move(sum));
    return sentences;
}

std::vector<std::string> trace_sentences(const femoop::Model& model, const DrawOptions& options,
                                         const InfluencePicture& picture)
{
    const ui::DisplayUnits units = display_units(model, options);
    const femoop::influence::StandingForce& load = picture.forces.front();
    std::vector<std::string> sentences{
        options.tr("{effect} under a unit load at s = {place}: η = {ordinate}",
                   {{"effect", effect_text(model, units, picture.line.effect)},
                    {"place", with_minus(units.text(load.s, ui::Measure::Length))},
                    {"ordinate", ordinate_text(units, ordinate_unit(units, picture), load.ordinate)}})};
    if (picture.traced)
        sentences.push_back(options.tr("Move the load along the path: it draws the line, place by place."));
    else std::ranges::move(motion_sentences(model, picture, options.tr), std::back_inserter(sentences));
    return sentences;
}

} // namespace drawing
