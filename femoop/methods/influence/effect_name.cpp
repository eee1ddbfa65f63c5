#include "femoop/methods/influence/effect_name.h"

#include <algorithm>
#include <variant>

#include "femoop/geometry/member_geometry.h"
#include "femoop/model/quantity/six_digits.h"

namespace femoop::influence {

namespace {

std::string place_text(const Model& model, const MovingEffect& effect, const Translator& tr)
{
    if (const auto* percent = std::get_if<Percent>(&*effect.at)) return six_digits(percent->value, tr) + "%";
    const Quantity& at = std::get<Quantity>(*effect.at);
    const bool has_unit = at.text().find_last_not_of("0123456789.+-eE") != std::string_view::npos;
    if (has_unit) return std::string(at.text());
    return six_digits(told_place(model, *effect.member, at), tr) + " " + unit_text(dimension::length, model.units);
}

} // namespace

double told_place(const Model& model, MemberId member, double x)
{
    constexpr double hair = 2e-6; // of the length
    const double length = geometry_of(model, model[member]).length;
    if (x < hair * length) return std::min(x, 0.0);
    return x > (1.0 - hair) * length ? std::max(x, length) : x;
}

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
           (effect.at ? ", " + place_text(model, effect, tr) : "") + ")";
}

} // namespace femoop::influence
