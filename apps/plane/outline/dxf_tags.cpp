#include "apps/plane/outline/dxf_tags.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "apps/plane/outline/gathering.h"
#include "femoop/model/fault/translator.h"
#include "topology/text/line_error.h"
#include "topology/text/words.h"

namespace outline {

using femoop::translatable;
using topology::LineError;

namespace {

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

void require_text(std::string_view text)
{
    if (text.starts_with("AutoCAD Binary DXF"))
        throw LineError(translatable("it is a binary DXF file; save it as DXF in text (ASCII)"), {});
    if (text.starts_with("AC10")) throw LineError(translatable("it is a DWG file; save it as DXF in text (ASCII)"), {});
}

int group_code(const topology::Lines& lines)
{
    const std::string_view word = trimmed(lines.line());
    int code = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), code);
    if (word.empty() || error != std::errc() || end != word.data() + word.size())
        throw LineError(translatable("a DXF file has the number of a group here; found \"{0}\""),
                        {std::string(word.substr(0, 40))})
            .at(lines.number(), lines.line());
    return code;
}

} // namespace

std::vector<DxfTag> dxf_tags(std::string_view text)
{
    require_text(text);
    std::vector<DxfTag> tags;
    topology::Lines lines(text);
    while (lines.next()) {
        const int code = group_code(lines);
        if (!lines.next()) break;
        tags.push_back({code, trimmed(lines.line()), lines.number()});
        if (code == 0 && tags.back().value == "EOF") return tags;
    }
    throw LineError(translatable("the file ends before its EOF; it is not whole"), {});
}

double number(const DxfTag& tag)
{
    try {
        return number(tag.value);
    } catch (const LineError& fault) {
        throw fault.at(tag.line, tag.value);
    }
}

const DxfTag* DxfEntity::find(int code) const
{
    const auto tag = std::ranges::find(tags, code, &DxfTag::code);
    return tag != tags.end() ? &*tag : nullptr;
}

std::string_view DxfEntity::text(int code) const
{
    const DxfTag* const tag = find(code);
    return tag != nullptr ? tag->value : std::string_view();
}

double DxfEntity::number(int code, double absent) const
{
    const DxfTag* const tag = find(code);
    return tag != nullptr ? outline::number(*tag) : absent;
}

int DxfEntity::flags(int code) const
{
    const double value = number(code, 0.0);
    return std::abs(value) < 1e9 ? static_cast<int>(value) : 0;
}

Place DxfEntity::place(int code) const { return {number(code, 0.0), number(code + 10, 0.0)}; }

std::vector<double> DxfEntity::numbers(int code) const
{
    std::vector<double> all;
    for (const DxfTag& tag : tags)
        if (tag.code == code) all.push_back(outline::number(tag));
    return all;
}

std::vector<Place> DxfEntity::places(int code) const
{
    std::vector<Place> all;
    for (const DxfTag& tag : tags) {
        if (tag.code == code) all.emplace_back(outline::number(tag), 0.0);
        if (tag.code == code + 10 && !all.empty()) all.back().y() = outline::number(tag);
    }
    return all;
}

} // namespace outline
