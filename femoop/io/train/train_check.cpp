#include "femoop/io/train/train_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "femoop/geometry/member_geometry.h"
#include "femoop/io/train/train_block.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/train/train_analysis.h"

namespace femoop::influence {

namespace {

constexpr double usual_rtol = 1e-6;
constexpr double same_section = 1e-5; // of the path's length

class TrainBlockCheck {
public:
    TrainBlockCheck(const Model& model, const TrainBlock& block, const Translator& tr)
        : model_(model), block_(block), tr_(tr), analysis_(model), path_length_(analysis_.path(block.train).length())
    {}

    std::vector<CheckOutcome> run()
    {
        for (const TrainCheck& check : block_.checks)
            if (check.effect.quantity == ExpectedQuantity::Extreme) check_extreme(check);
            else check_effect(check);
        return std::move(outcomes_);
    }

private:
    void check_effect(const TrainCheck& check)
    {
        const TrainEffect effect = analysis_.effects(block_.train, {&check.effect, 1}).front();
        check_value(check, check.which == ExtremeKind::Max ? effect.max.value : effect.min.value);
    }

    void check_extreme(const TrainCheck& check)
    {
        const TrainExtreme extreme = analysis_.extreme(block_.train, check.effect);
        const WorstSection& worst = check.which == ExtremeKind::Max ? extreme.max : extreme.min;
        check_value(check, worst.placing.value);
        if (!check.sections.empty()) check_sections(check, worst.sections);
    }

    std::string what(const TrainCheck& check) const
    {
        const std::string which = check.which == ExtremeKind::Max ? "max" : "min";
        return fill(tr_("train {0}: {1} {2}"), {block_.train.id, which, effect_name(model_, check.effect, tr_)});
    }

    void add(std::string what, double wanted, double found, double tolerance)
    {
        outcomes_.push_back(compared(std::move(what), wanted, found, tolerance));
    }

    void check_value(const TrainCheck& check, double found)
    {
        const double wanted = check.value.value();
        add(what(check), wanted, found,
            std::max(check.atol ? check.atol->value() : 0.0, check.rtol.value_or(usual_rtol) * std::abs(wanted)));
    }

    void check_sections(const TrainCheck& check, const std::vector<double>& found)
    {
        const double length = geometry_of(model_, model_[*check.effect.member]).length;
        for (const Position& section : check.sections) {
            const double wanted = along(section, length);
            const double nearest = *std::ranges::min_element(found, {}, [&](double x) { return std::abs(x - wanted); });
            add(fill(tr_("{0}: section"), {what(check)}), wanted, nearest, same_section * path_length_);
        }
        if (found.size() != check.sections.size())
            add(fill(tr_("{0}: number of sections"), {what(check)}), static_cast<double>(check.sections.size()),
                static_cast<double>(found.size()), 0.0);
    }

    const Model& model_;
    const TrainBlock& block_;
    const Translator& tr_;
    TrainAnalysis analysis_;
    double path_length_;
    std::vector<CheckOutcome> outcomes_;
};

} // namespace

std::vector<CheckOutcome> check_train_block(const Model& model, const Translator& tr)
{
    const std::optional<TrainBlock> block = train_block_of(model);
    return block ? TrainBlockCheck(model, *block, tr).run() : std::vector<CheckOutcome>();
}

} // namespace femoop::influence
