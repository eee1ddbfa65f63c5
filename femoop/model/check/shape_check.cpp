#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/check/checker.h"
#include "femoop/model/check/suggestion.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/section/profile.h"
#include "femoop/section/shape.h"

namespace femoop {

namespace {

std::string keys_of(SectionShapeKind kind)
{
    std::string text;
    for (const ShapeDimension& dimension : dimensions(kind))
        text += (text.empty() ? "" : " ") + std::string(dimension.key);
    return text;
}

bool needs(SectionShapeKind kind, std::string_view key)
{
    const auto keys = dimensions(kind);
    return std::any_of(keys.begin(), keys.end(), [&](const ShapeDimension& dimension) { return dimension.key == key; });
}

} // namespace

void Checker::check_shape(const SectionShape& shape, const Entry& place)
{
    const std::string kind(name(shape.kind)), keys = keys_of(shape.kind);
    bool can_be_drawn = true;
    for (const auto& [key, member] : shape_dimensions()) {
        const auto& value = shape.*member;
        const bool is_needed = needs(shape.kind, key);
        if (is_needed && !value) add(FaultKind::ShapeSizeMissing, place, {kind, keys, std::string(key)});
        if (!is_needed && value) add(FaultKind::ShapeSizeUnwanted, place, {kind, std::string(key), keys});
        if (is_needed && value) require_positive(place, key, *value, dimension::length);
        can_be_drawn = can_be_drawn && is_needed == value.has_value();
    }
    const auto flaw = can_be_drawn ? why_not(shape) : std::nullopt;
    if (flaw && flaw->flaw == ShapeFlaw::TooLarge)
        add(FaultKind::ShapeTooThick, place,
            {std::string(flaw->key), quantity_text(flaw->value, dimension::length, model_.units),
             std::string(flaw->limit_key), quantity_text(flaw->limit, dimension::length, model_.units)});
    const bool is_unsymmetric = shape.kind == SectionShapeKind::L || shape.kind == SectionShapeKind::C ||
                                shape.kind == SectionShapeKind::T;
    if (is_unsymmetric && !is_truss(model_.analysis)) add(FaultKind::IyzLeftOut, place, {kind});
}

void Checker::check_profile(const std::string& profile, const Entry& place)
{
    if (const Profile* const found = find_profile(profile)) {
        const bool is_unsymmetric = found->family == ProfileFamily::L;
        if (is_unsymmetric && !is_truss(model_.analysis)) add(FaultKind::IyzLeftOut, place, {"l"});
        return;
    }
    const std::vector<std::string_view> near = near_profiles(profile, 1);
    if (!near.empty()) add(FaultKind::UnknownProfileNear, place, {profile, std::string(near.front())});
    else add(FaultKind::UnknownProfile, place, {profile});
}

} // namespace femoop
