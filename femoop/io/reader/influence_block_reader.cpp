#include <charconv>
#include <string>
#include <utility>

#include "femoop/io/reader/model_reader.h"

namespace femoop {

namespace {

constexpr Keys<4> block_keys{{"lines", "path", "load", "positions"}, 1};
constexpr Keys<16> check_keys{{"quantity", "node", "member", "component", "at", "side", "id", "path", "load",
                               "positions", "values", "max", "min", "rtol", "atol", "source"},
                              1};
constexpr Keys<2> extreme_keys{{"value", "position"}, 0};

} // namespace

influence::Block ModelReader::influence_block(JsonValue value)
{
    const Place top;
    const Place here = top.key("influence");
    const auto [lines, path, load, positions] = reader_.fields(value, block_keys, here);
    influence::LineCheck common;
    common.line.path = path_reference(path, here);
    common.line.load = unit_load(load, here);
    common.positions = path_positions(positions, here);
    influence::Block block;
    for_each(lines, here, [&](JsonValue line, const Place& place) {
        block.lines.push_back(line_check(line, common, place));
        block.lines.back().line.id = std::to_string(block.lines.size());
    });
    return block;
}

influence::LineCheck ModelReader::line_check(JsonValue value, const influence::LineCheck& common, const Place& place)
{
    const auto [quantity, node, member, component, at, side, id, path, load, positions, values, max, min, rtol, atol,
                source] = reader_.fields(value, check_keys, place);
    influence::LineCheck check = common;
    check.line.effect = moving_effect({quantity, node, member, component, at, side}, ExpectedQuantity::SectionForce,
                                      place);
    reader_.text(id, place);
    reader_.text(source, place);
    if (path.is_present()) check.line.path = path_reference(path, place);
    if (load.is_present()) check.line.load = unit_load(load, place);
    if (positions.is_present()) check.positions = path_positions(positions, place);
    check.values = numbers(values, place);
    check.max = extreme_check(max, place);
    check.min = extreme_check(min, place);
    check.rtol = reader_.number(rtol, place).value_or(check.rtol);
    check.atol = reader_.number(atol, place).value_or(check.atol);
    return check;
}

std::vector<influence::PathPosition> ModelReader::path_positions(JsonValue list, const Place& place)
{
    std::vector<influence::PathPosition> positions;
    if (!reader_.is_list(list, place)) return positions;
    const Place here = place.key(list.key());
    std::size_t i = 0;
    for (const JsonValue value : list)
        if (auto position = path_position(value, here.entry(i++))) positions.push_back(std::move(*position));
    return positions;
}

// "4-", "4+", 4, or "400 cm"
std::optional<influence::PathPosition> ModelReader::path_position(JsonValue value, const Place& place)
{
    if (value.is(JsonKind::Number))
        return influence::PathPosition{.s = value.number(), .side = std::nullopt, .text = compact_json(value)};
    if (value.is(JsonKind::String)) {
        std::string_view digits = value.text();
        influence::PathPosition position{.s = 0.0, .side = std::nullopt, .text = std::string(digits)};
        const char last = digits.empty() ? '\0' : digits.back();
        if (last == '-' || last == '+') {
            position.side = last == '-' ? Side::Before : Side::After;
            digits.remove_suffix(1);
        }
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), position.s);
        if (error == std::errc() && end == digits.data() + digits.size()) return position;
        if (!position.side) {
            const auto length = reader_.quantity(value, dimension::length, place);
            position.s = length.value_or(no_number);
            return position;
        }
    }
    reader_.add({FaultKind::BadPathPosition, {place.text(), compact_json(value)}});
    return std::nullopt;
}

std::optional<influence::ExtremeCheck> ModelReader::extreme_check(JsonValue value, const Place& place)
{
    if (!reader_.is_object(value, place)) return std::nullopt;
    const Place here = place.key(value.key());
    const auto [number, position] = reader_.fields(value, extreme_keys, here);
    influence::ExtremeCheck check;
    check.value = reader_.number(number, here);
    if (position.is(JsonKind::Number)) check.positions = {position.number()};
    else if (position.is_present()) check.positions = numbers(position, here);
    return check;
}

std::vector<double> ModelReader::numbers(JsonValue list, const Place& place)
{
    std::vector<double> found;
    if (!reader_.is_list(list, place)) return found;
    const Place here = place.key(list.key());
    std::size_t i = 0;
    for (const JsonValue value : list) found.push_back(reader_.number(value, here.entry(i++)).value_or(no_number));
    return found;
}

} // namespace femoop
