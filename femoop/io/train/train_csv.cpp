#include "femoop/io/train/train_csv.h"

#include <string_view>

#include "femoop/geometry/member_geometry.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/tabular/separated.h"

namespace femoop::influence {

namespace {

void write_placing(tabular::SeparatedText& csv, const Placing& placing, const Train& train)
{
    csv << placing.value;
    if (placing.position) csv << *placing.position;
    else csv << "";
    csv << (placing.position && placing.reversed ? "yes" : "") << train.id;
}

void write_part(tabular::SeparatedText& csv, const Model& model, const MovingEffect& effect)
{
    if (!effect.member) {
        csv << "node" << model[*effect.node].id << "";
        return;
    }
    csv << "member" << model[*effect.member].id << along(*effect.at, geometry_of(model, model[*effect.member]).length);
}

} // namespace

std::string trains_csv(const Model& model, std::span<const TrainEffect> effects)
{
    const std::string length = " [" + unit_text(dimension::length, model.units) + "]";
    tabular::SeparatedText csv;
    csv << "part"
        << "id"
        << "x" + length << "component"
        << "unit";
    for (const std::string which : {"max", "min"})
        csv << which << "s of " + which + length << which + " reversed"
            << "train of " + which;
    csv.end_row();
    for (const TrainEffect& effect : effects) {
        write_part(csv, model, effect.effect);
        csv << component_name(model.analysis, effect.effect) << unit_text(dimension_of(effect.effect), model.units);
        write_placing(csv, effect.max, *effect.max_train);
        write_placing(csv, effect.min, *effect.min_train);
        csv.end_row();
    }
    return csv.take();
}

} // namespace femoop::influence
