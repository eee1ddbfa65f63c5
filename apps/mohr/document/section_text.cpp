#include "apps/mohr/document/section_text.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "femoop/model/quantity/quantity_parser.h"
#include "femoop/section/profile.h"
#include "femoop/section/shape.h"
#include "ui/text/catalogue.h"
#include "ui/text/number_format.h"

namespace mohr {

using femoop::SectionShape;
using ui::Message;
using ui::translatable;

namespace {

Message unknown(std::string_view text)
{
    return {translatable("there is no section \"{text}\"; write a profile, "
                         "such as IPE 300, or a shape with its dimensions, such as rectangle b=90mm h=210mm"),
            {{"text", std::string(text)}}};
}

/// "b=90mm", or why not.
std::optional<Message> take_dimension(SectionShape& shape, const std::string& word)
{
    const auto equals = word.find('=');
    const std::string key = word.substr(0, equals), text = equals == std::string::npos ? "" : word.substr(equals + 1);
    for (const femoop::ShapeDimension& dimension : femoop::shape_dimensions()) {
        if (dimension.key != key) continue;
        const bool is_bare = text.find_first_not_of("0123456789.e+-") == std::string::npos;
        const auto value = femoop::parse_quantity(is_bare ? text + " mm" : text, femoop::dimension::length,
                                                  newtons_and_mm);
        if (!std::holds_alternative<double>(value))
            return Message(translatable("\"{word}\" is no dimension; write it like h=210mm"), {{"word", word}});
        shape.*dimension.value = std::get<double>(value);
        return std::nullopt;
    }
    return Message(translatable("\"{word}\" is no dimension; write it like h=210mm"), {{"word", word}});
}

Message shape_sentence(const femoop::ShapeFault& fault)
{
    const Message::Argument key{"key", std::string(fault.key)};
    switch (fault.flaw) {
    case femoop::ShapeFlaw::Missing: return {translatable("{key} is missing"), {key}};
    case femoop::ShapeFlaw::Unneeded: return {translatable("{key} is no dimension of this shape"), {key}};
    case femoop::ShapeFlaw::NotPositive: return {translatable("{key} must be a positive length"), {key}};
    case femoop::ShapeFlaw::TooLarge: break;
    }
    return {translatable("{key} must be less than {limit} = {value}"),
            {key, {"limit", std::string(fault.limit_key)}, {"value", ui::number_text(fault.limit) + " mm"}}};
}

/// Why its stresses are not those of plain bending.
std::optional<Message> why_not_figure(const femoop::Section& section)
{
    const femoop::Profile* const profile = section.profile ? femoop::find_profile(*section.profile) : nullptr;
    const bool is_rolled_angle = profile != nullptr && profile->family == femoop::ProfileFamily::L;
    const bool is_angle = section.shape && section.shape->kind == femoop::SectionShapeKind::L;
    if (is_angle || is_rolled_angle)
        return translatable("a single angle bends out of its plane; choose a section that is symmetric about y′ or z′");
    const auto fault = section.shape ? femoop::why_not(*section.shape) : std::nullopt;
    if (!fault) return std::nullopt;
    return Message(translatable("the shape cannot be: {reason}"), {{"reason", shape_sentence(*fault)}});
}

/// "i h=300mm bf=150mm tf=12mm tw=8mm", or why it is none.
std::variant<SectionShape, Message> shape_of(std::string_view text)
{
    std::istringstream words{std::string(text)};
    std::string kind;
    words >> kind;
    const auto kinds = femoop::section_shape_kinds();
    const auto found = std::ranges::find_if(kinds, [&](femoop::SectionShapeKind k) { return name(k) == kind; });
    if (found == kinds.end()) return unknown(text);
    SectionShape shape;
    shape.kind = *found;
    for (std::string word; words >> word;)
        if (const auto reason = take_dimension(shape, word)) return *reason;
    return shape;
}

/// In mm, or why it is none.
std::variant<femoop::Section, Message> parsed_section(std::string_view text)
{
    constexpr std::string_view turned = " turned";
    femoop::Section section;
    section.turned = text.ends_with(turned);
    if (section.turned) text.remove_suffix(turned.size());
    if (femoop::find_profile(text) != nullptr) {
        section.profile = std::string(text);
        return section;
    }
    auto shape = shape_of(text);
    if (auto* const reason = std::get_if<Message>(&shape)) return std::move(*reason);
    section.shape = std::get<SectionShape>(std::move(shape));
    return section;
}

} // namespace

std::variant<femoop::mohr::SectionFigure, Message> section_figure(std::string_view text)
{
    const auto section = parsed_section(text);
    if (const auto* const reason = std::get_if<Message>(&section)) return *reason;
    if (auto reason = why_not_figure(std::get<femoop::Section>(section))) return std::move(*reason);
    return femoop::mohr::SectionFigure(std::get<femoop::Section>(section), newtons_and_mm);
}

} // namespace mohr
