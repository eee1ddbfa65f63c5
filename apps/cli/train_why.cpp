#include "apps/cli/train_why.h"

#include <cmath>
#include <utility>

#include "apps/cli/picture.h"
#include "apps/drawing/results/influence_words.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/methods/derivation/derivation.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/train/standing_train.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"

namespace cli {

namespace {

using femoop::ExtremeKind;
using femoop::Model;
using femoop::MovingEffect;
using femoop::influence::Placing;
using femoop::influence::StandingForce;
using femoop::influence::TrainAnalysis;

/// The largest and the least number, which train makes each, and where.
struct Governing {
    const femoop::Train* train;
    ExtremeKind kind;
    double value; ///< with what stays
};

class TrainWhy {
public:
    TrainWhy(const Model& model, const TrainNumber& number) : model_(model), number_(number), analysis_(model)
    {
        if (number_.effect.quantity == femoop::ExpectedQuantity::Extreme) settle_section();
        governing_ = governing();
        line_.emplace(analysis_.line(*governing_.train, number_.effect));
        path_ = analysis_.path(*governing_.train);
        worst_ = analysis_.search(*governing_.train, number_.effect).worst();
        standing_ = {.name = governing_.train->id,
                     .train = femoop::influence::moving_train(*governing_.train, number_.effect),
                     .placing = is_max() ? worst_.max : worst_.min,
                     .kind = governing_.kind};
        permanent_ = number_.envelope != nullptr ? analysis_.permanent(*number_.envelope, number_.effect) : 0.0;
        loaded_ = analysis_.unloaded();
        load_ = femoop::influence::unit_load(model.analysis, governing_.train->load);
        loaded_.load_cases = {
            standing_train(standing_.name, path_, load_, standing_.train, standing_.placing, *line_, standing_.kind)};
        loaded_.combinations.clear();
    }

    std::string text(const ui::Catalogue& tr) const
    {
        const drawing::DrawOptions options = draw_options(tr);
        drawing::InfluencePicture picture{.path = path_, .load = load_, .line = *line_};
        stand_on(picture, standing_);
        std::string words = title(tr) + train_words(model_, options, picture, standing_, worst_);
        if (number_.envelope != nullptr) words += sum(tr);
        return words + "\n" + tr("The same by an analysis with the train standing there:") + "\n\n" +
               derivation_text(derivation(), loaded_, tr);
    }

    std::string json(const ui::Catalogue& tr) const
    {
        femoop::JsonWriter json;
        begin_output(json, model_.units);
        json.key("standing").begin_object(femoop::JsonWriter::Layout::Block);
        json.member("train", governing_.train->id).member("which", is_max() ? "max" : "min");
        if (standing_.placing.position) json.member("position", *standing_.placing.position);
        json.member("reversed", standing_.placing.reversed);
        write_forces(json);
        write_areas(json);
        json.member("sum", standing_.placing.value);
        json.end();
        if (number_.envelope != nullptr)
            json.member("permanent", permanent_).member("factor", number_.envelope->factor);
        json.member("value", governing_.value);
        write_why(json, derivation(), loaded_, tr);
        json.end();
        return json.take();
    }

    const std::vector<femoop::Fault>& warnings() const { return analysis_.warnings(); }

private:
    bool is_max() const { return governing_.kind == ExtremeKind::Max; }

    /// That where it is worst along the member.
    void settle_section()
    {
        const auto found = number_.train != nullptr ? analysis_.extreme(*number_.train, number_.effect)
                                                    : analysis_.extreme(*number_.envelope, number_.effect);
        const bool is_max = std::abs(found.max.placing.value) >= std::abs(found.min.placing.value);
        const femoop::influence::WorstSection& worst = is_max ? found.max : found.min;
        const double length = femoop::geometry_of(model_, model_[*number_.effect.member]).length;
        number_.effect = femoop::influence::at_section(number_.effect, worst.inside, length);
    }

    Governing governing()
    {
        const auto found = number_.train != nullptr ? analysis_.effects(*number_.train, {{number_.effect}}).front()
                                                    : analysis_.effects(*number_.envelope, {{number_.effect}}).front();
        if (std::abs(found.max.value) >= std::abs(found.min.value))
            return {found.max_train, ExtremeKind::Max, found.max.value};
        return {found.min_train, ExtremeKind::Min, found.min.value};
    }

    femoop::derivation::Derivation derivation() const
    {
        return femoop::derivation::derive(loaded_, femoop::analyse(loaded_), femoop::CaseId(0), number_.effect);
    }

    std::string number(double value, const ui::Catalogue& tr) const
    {
        const std::string unit = femoop::printed_unit(femoop::influence::dimension_of(number_.effect), model_.units);
        return femoop::six_digits(value, tr) + " " + unit;
    }

    std::string title(const ui::Catalogue& tr) const
    {
        const std::string text = tr(
            "{effect} = {value} under {loads}: where it comes from",
            {{"effect", femoop::influence::effect_name(model_, number_.effect, tr)},
             {"value", number(governing_.value, tr)},
             {"loads", number_.envelope != nullptr ? number_.envelope->id : governing_.train->id}});
        return text + "\n" + tr("Train {train} governs.", {{"train", governing_.train->id}}) + "\n";
    }

    /// "G: 55.8; 1.35 × 712.7; together 1374.3 kip·ft"
    std::string sum(const ui::Catalogue& tr) const
    {
        const femoop::MovingEnvelope& envelope = *number_.envelope;
        const std::string trains = femoop::six_digits(envelope.factor, tr) + " × (" +
                                   femoop::six_digits(standing_.placing.value, tr) + ")";
        if (!envelope.with) return trains + " = " + number(governing_.value, tr) + "\n";
        return tr("{case} has {value}; with the train:",
                  {{"case", model_.case_name(*envelope.with)}, {"value", number(permanent_, tr)}}) +
               "\n  " + femoop::six_digits(permanent_, tr) + " + " + trains + " = " + number(governing_.value, tr) +
               "\n";
    }

    void write_forces(femoop::JsonWriter& json) const
    {
        json.key("forces").begin_array(femoop::JsonWriter::Layout::Block);
        const auto forces = standing_forces(standing_.train, standing_.placing, line_->ordinates, governing_.kind);
        for (const StandingForce& force : forces)
            json.begin_object()
                .member("s", force.s)
                .member("force", force.force)
                .member("ordinate", force.ordinate)
                .end();
        json.end();
    }

    void write_areas(femoop::JsonWriter& json) const
    {
        json.key("uniform").begin_array(femoop::JsonWriter::Layout::Block);
        const std::vector<double> areas = covered_areas(standing_.placing, line_->ordinates);
        for (std::size_t i = 0; i < areas.size(); ++i) {
            const auto& [from, to] = standing_.placing.uniform[i];
            json.begin_object().member("from", from).member("to", to).member("area", areas[i]);
            json.member("load", standing_.train.uniform).end();
        }
        json.end();
    }

    const Model& model_;
    TrainNumber number_;
    TrainAnalysis analysis_;
    Governing governing_{};
    femoop::influence::PathLayout path_;
    femoop::NodeVector load_;
    femoop::influence::WorstPlacings worst_;
    std::optional<femoop::influence::InfluenceLine> line_;
    drawing::StandingTrain standing_;
    double permanent_ = 0.0;
    Model loaded_; ///< with that train as its only load
};

} // namespace

std::string train_why(const Model& model, const TrainNumber& number, bool is_json, const Console& console)
{
    const TrainWhy why(model, number);
    console.report(number.envelope != nullptr ? number.envelope->id : number.train->id, why.warnings());
    return is_json ? why.json(console.tr()) : why.text(console.tr());
}

} // namespace cli
