#include "femoop/methods/influence/effect_name.h"

#include <variant>

#include "femoop/model/quantity/six_digits.h"

namespace femoop::influence {

namespace {

std::string place_text(const Position& at, const Units& units, const Translator& tr)
{
    if (const auto* percent = std::get_if<Percent>(&at)) return six_digits(percent->value, tr) + "%";
    const Quantity& length = std::get<Quantity>(at);
    const bool has_unit = length.text().find_last_not_of("0123456789.+-eE") != std::string_view::npos;
    return has_unit ? std::string(length.text()) : six_digits(length, tr) + " " + unit_text(dimension::length, units);
}

} // namespace

std::string component_name(AnalysisKind kind, const MovingEffect& effect)
{
    if (effect.component) return std::string(name(*effect.component, kind));
    if (is_resultant(effect)) return "R";
    if (!effect.dof) return {};
    return std::string(effect.quantity == ExpectedQuantity::Reaction ? force_name(*effect.dof) : name(*effect.dof));
}

Dimension dimension_of(const MovingEffect& effect)
{
    Expected asked;
    asked.quantity = effect.quantity;
    asked.dof = effect.dof;
    asked.component = effect.component;
    return femoop::dimension_of(asked);
}

std::string effect_name(const Model& model, const MovingEffect& effect, const Translator& tr)
{
    const std::string& part = effect.member ? model[*effect.member].id : model[*effect.node].id;
    return component_name(model.analysis, effect) + "(" + part +
           (effect.at ? ", " + place_text(*effect.at, model.units, tr) : "") + ")";
}

} // namespace femoop::influence
