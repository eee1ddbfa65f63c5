#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "femoop/io/reader/model_reader.h"
#include "femoop/io/reader/names.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/model/quantity/dof_dimension.h"

namespace femoop {

namespace {

constexpr Keys<12> train_keys{{"id", "path", "axles", "spacings", "spacing_ranges", "both_directions", "impact",
                               "uniform", "uniform_extent", "gap", "concentrated", "load"},
                              2};
constexpr Keys<13> train_block_keys{{"path", "name", "axles", "spacings", "spacing_ranges", "both_directions", "impact",
                                     "uniform", "uniform_extent", "gap", "concentrated", "load", "expected"},
                                    1};
constexpr Keys<4> envelope_keys{{"id", "trains", "with", "factor"}, 2};
constexpr Keys<2> force_keys{{"moment", "shear"}, 2};
constexpr Keys<12> train_check_keys{
    {"quantity", "component", "which", "value", "node", "member", "at", "side", "position", "rtol", "atol", "source"},
    4};

/// "1" .. "n" as an index.
std::optional<std::size_t> spacing_number(std::string_view text)
{
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_number = error == std::errc() && end == text.data() + text.size() && number > 0;
    return is_number ? std::optional(number - 1) : std::nullopt;
}

} // namespace

Train ModelReader::train(JsonValue value, const Place& place)
{
    const auto [id, path, axles, spacings, ranges, both_directions, impact, uniform, extent, gap, concentrated,
                load] = reader_.fields(value, train_keys, place);
    Train train;
    train.id = reader_.id(id, place);
    read_train({path, axles, spacings, ranges, both_directions, impact, uniform, extent, gap, concentrated, load},
               train, place);
    return train;
}

void ModelReader::read_train(const TrainFields& fields, Train& train, const Place& place)
{
    train.path = path_reference(fields.path, place);
    train.load = unit_load(fields.load, place);
    const Dof along = train.load.empty() ? Dof::uy : train.load.front().dof;
    train.axles = quantities(fields.axles, force_dimension(along), place);
    train.spacings = quantities(fields.spacings, dimension::length, place);
    read_ranges(fields.ranges, train, place);
    train.both_directions = reader_.boolean(fields.both_directions, place);
    train.impact = reader_.number(fields.impact, place).value_or(train.impact);
    train.uniform = reader_.quantity(fields.uniform, line_load_dimension(along), place);
    if (const auto extent = reader_.choice(fields.extent, names::uniform_extents, place))
        train.uniform_extent = *extent + 1 < names::uniform_extents.size() ? static_cast<UniformExtent>(*extent)
                                                                           : UniformExtent::Adverse;
    train.gap = reader_.quantity(fields.gap, dimension::length, place);
    read_concentrated(fields.concentrated, force_dimension(along), train, place);
}

std::vector<Quantity> ModelReader::quantities(JsonValue list, Dimension dimension, const Place& place)
{
    std::vector<Quantity> values;
    for_each(list, place, [&](JsonValue value, const Place& own_place) {
        values.push_back(reader_.quantity(value, dimension, own_place).value_or(no_number));
    });
    return values;
}

void ModelReader::read_ranges(JsonValue ranges, Train& train, const Place& place)
{
    if (!reader_.is_object(ranges, place)) return;
    const Place here = place.key(ranges.key());
    for (const JsonValue range : ranges) {
        const std::optional<std::size_t> spacing = spacing_number(range.key());
        if (!spacing)
            reader_.add({FaultKind::RangeOfNoSpacing,
                         {here.text(), std::string(range.key()), std::to_string(train.spacings.size())}});
        if (!reader_.is_list(range, here)) continue;
        if (range.size() != 2) {
            reader_.add({FaultKind::WrongRangeSize, {here.text(range.key()), std::to_string(range.size())}});
            continue;
        }
        std::vector<Quantity> ends = quantities(range, dimension::length, here);
        if (spacing) train.spacing_ranges.push_back({*spacing, std::move(ends[0]), std::move(ends[1])});
    }
}

void ModelReader::read_concentrated(JsonValue value, Dimension dimension, Train& train, const Place& place)
{
    if (!value.is_present()) return;
    if (!value.is(JsonKind::Array)) {
        train.concentrated.push_back(concentrated_force(value, dimension, place));
        return;
    }
    for_each(value, place, [&](JsonValue force, const Place& own_place) {
        train.concentrated.push_back(concentrated_force(force, dimension, own_place));
    });
}

ConcentratedForce ModelReader::concentrated_force(JsonValue value, Dimension dimension, const Place& place)
{
    ConcentratedForce force{.for_moments = no_number, .for_others = std::nullopt};
    if (!value.is(JsonKind::Object)) {
        force.for_moments = reader_.quantity(value, dimension, place).value_or(no_number);
        return force;
    }
    const Place here = value.key().empty() ? place : place.key(value.key());
    const auto [moment, shear] = reader_.fields(value, force_keys, here);
    force.for_moments = reader_.quantity(moment, dimension, here).value_or(no_number);
    force.for_others = reader_.quantity(shear, dimension, here).value_or(no_number);
    return force;
}

MovingEnvelope ModelReader::moving_envelope(JsonValue value, const Place& place)
{
    const auto [id, trains, with, factor] = reader_.fields(value, envelope_keys, place);
    MovingEnvelope envelope;
    envelope.id = reader_.id(id, place);
    for_each(trains, place, [&](JsonValue train, const Place& own_place) {
        envelope.trains.emplace_back(reference(train, trains_, own_place));
    });
    if (with.is_present()) envelope.with = CaseId(reference(with, cases_, place));
    envelope.factor = reader_.number(factor, place).value_or(envelope.factor);
    return envelope;
}

influence::TrainBlock ModelReader::train_block(JsonValue value)
{
    influence::TrainBlock block;
    const Place top, place = top.key("train");
    if (!reader_.is_object(value, place)) return block;
    const auto [path, name, axles, spacings, ranges, both_directions, impact, uniform, extent, gap, concentrated, load,
                expected] = reader_.fields(value, train_block_keys, place);
    block.train.id = reader_.text(name, place).value_or("train");
    read_train({path, axles, spacings, ranges, both_directions, impact, uniform, extent, gap, concentrated, load},
               block.train, place);
    for_each(expected, place,
             [&](JsonValue check, const Place& own_place) { block.checks.push_back(train_check(check, own_place)); });
    return block;
}

influence::TrainCheck ModelReader::train_check(JsonValue value, const Place& place)
{
    const auto [quantity, component, which, wanted, node, member, at, side, section, rtol, atol,
                source] = reader_.fields(value, train_check_keys, place);
    influence::TrainCheck check;
    check.place = place.text();
    check.effect = moving_effect({quantity, node, member, component, at, side}, ExpectedQuantity::Extreme, place);
    if (const auto kind = reader_.choice(which, names::extremes, place)) check.which = static_cast<ExtremeKind>(*kind);
    const Dimension dimension = influence::dimension_of(check.effect);
    check.value = reader_.quantity(wanted, dimension, place).value_or(no_number);
    check.rtol = reader_.number(rtol, place);
    reader_.text(source, place);
    check.atol = reader_.quantity(atol, dimension, place);
    if (!section.is(JsonKind::Array)) {
        if (auto one = position(section, place)) check.sections.push_back(std::move(*one));
        return check;
    }
    for_each(section, place, [&](JsonValue one, const Place& own_place) {
        if (auto read = position(one, own_place)) check.sections.push_back(std::move(*read));
    });
    return check;
}

} // namespace femoop
