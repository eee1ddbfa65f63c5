#include "apps/frame/document/named_effect.h"

#include <algorithm>

#include "femoop/geometry/member_geometry.h"

namespace frame {

NamedEffect::NamedEffect(const femoop::Model& model, const femoop::MovingEffect& of)
    : node(of.node ? model[*of.node].id : ""), member(of.member ? model[*of.member].id : ""), effect(of)
{}

std::optional<femoop::MovingEffect> effect_in(const femoop::Model& model, const NamedEffect& named)
{
    femoop::MovingEffect effect = named.effect;
    if (!named.node.empty()) {
        effect.node = model.find_node(named.node);
        return effect.node ? std::optional(effect) : std::nullopt;
    }
    effect.member = model.find_member(named.member);
    if (!effect.member) return std::nullopt;
    const auto* const x = effect.at ? std::get_if<femoop::Quantity>(&*effect.at) : nullptr;
    const double length = femoop::geometry_of(model, model[*effect.member]).length;
    if (x != nullptr && x->value() > length) effect.at = femoop::Quantity(length);
    return effect;
}

} // namespace frame
