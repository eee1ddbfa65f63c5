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

Message angle_sentence()
{
    return translatable("a single angle bends out of its plane; choose a section that is symmetric about y′ or z′");
}

std::variant<femoop::mohr::SectionFigure, Message> figure_of(const femoop::Profile& profile)
{
    if (profile.family == femoop::ProfileFamily::L) return angle_sentence();
    return femoop::mohr::SectionFigure(profile, newtons_and_mm);
}

std::variant<femoop::mohr::SectionFigure, Message> figure_of(const SectionShape& shape)
{
    if (shape.kind == femoop::SectionShapeKind::L) return angle_sentence();
    if (const auto fault = femoop::why_not(shape))
        return Message(translatable("the shape cannot be: {reason}"), {{"reason", shape_sentence(*fault)}});
    return femoop::mohr::SectionFigure(shape);
}

} // namespace

std::variant<femoop::mohr::SectionFigure, Message> section_figure(std::string_view text)
{
    if (const femoop::Profile* const profile = femoop::find_profile(text)) return figure_of(*profile);
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
    return figure_of(shape);
}

} // namespace mohr
