#include "apps/frame/document/train_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "femoop/methods/influence/train/train_library.h"

namespace frame {

using femoop::Quantity;
using femoop::SpacingRange;
using femoop::Train;

namespace {

auto range_at(Train& train, std::size_t spacing)
{
    return std::ranges::find(train.spacing_ranges, spacing, &SpacingRange::spacing);
}

void erase_spacing(Train& train, std::size_t spacing)
{
    std::erase_if(train.spacing_ranges, [&](const SpacingRange& range) { return range.spacing == spacing; });
    for (SpacingRange& range : train.spacing_ranges)
        if (range.spacing > spacing) --range.spacing;
    train.spacings.erase(train.spacings.begin() + static_cast<std::ptrdiff_t>(spacing));
}

double one_digit(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    return std::round(value / power) * power;
}

} // namespace

Train usual_train(const femoop::Units& units, femoop::LoadPathReference path)
{
    constexpr std::array axles{100.0, 100.0};
    constexpr std::array spacings{2.0};
    const femoop::influence::LibraryTrain pair{
        .name = "T1",
        .source = {},
        .units = {.length = femoop::LengthUnit::m, .force = femoop::ForceUnit::kN},
        .axles = axles,
        .spacings = spacings};
    Train train = train_from(pair, units, std::move(path));
    for (Quantity& axle : train.axles) axle = one_digit(axle);
    for (Quantity& spacing : train.spacings) spacing = one_digit(spacing);
    return train;
}

void add_axle(Train& train, const femoop::Units& units)
{
    const Train usual = usual_train(units, {});
    const Quantity force = train.axles.empty() ? usual.axles.front() : train.axles.back();
    const Quantity spacing = train.spacings.empty() ? usual.spacings.front() : train.spacings.back();
    if (!train.axles.empty()) train.spacings.push_back(spacing);
    train.axles.push_back(force);
}

void erase_axle(Train& train, std::size_t axle)
{
    const bool is_between = axle > 0 && axle + 1 < train.axles.size();
    train.axles.erase(train.axles.begin() + static_cast<std::ptrdiff_t>(axle));
    if (train.spacings.empty()) return;
    if (!is_between) return erase_spacing(train, axle == 0 ? 0 : axle - 1);
    const auto before = spacing_range(train, axle - 1), behind = spacing_range(train, axle);
    const double most = (before ? before->max.value() : train.spacings[axle - 1].value()) +
                        (behind ? behind->max.value() : train.spacings[axle].value());
    const double least = train.spacings[axle - 1].value() + train.spacings[axle].value();
    erase_spacing(train, axle);
    set_spacing(train, axle - 1, least);
    set_longest_spacing(train, axle - 1, most);
}

void set_spacing(Train& train, std::size_t axle, const Quantity& spacing)
{
    train.spacings.at(axle) = spacing;
    const auto range = range_at(train, axle);
    if (range == train.spacing_ranges.end()) return;
    range->min = spacing;
    if (range->max.value() <= spacing.value()) train.spacing_ranges.erase(range);
}

void set_longest_spacing(Train& train, std::size_t axle, const Quantity& longest)
{
    const auto range = range_at(train, axle);
    const bool is_there = range != train.spacing_ranges.end();
    const Quantity least = is_there ? range->min : train.spacings.at(axle);
    if (longest.value() > least.value()) {
        if (is_there) range->max = longest;
        else train.spacing_ranges.push_back({axle, least, longest});
    } else if (is_there) {
        train.spacings.at(axle) = least;
        train.spacing_ranges.erase(range);
    }
}

std::optional<SpacingRange> spacing_range(const Train& train, std::size_t axle)
{
    const auto range = std::ranges::find(train.spacing_ranges, axle, &SpacingRange::spacing);
    return range != train.spacing_ranges.end() ? std::optional(*range) : std::nullopt;
}

double place_of_axle(const Train& train, std::size_t axle)
{
    double place = 0.0;
    for (std::size_t i = 0; i < axle; ++i) {
        const auto range = spacing_range(train, i);
        place += range ? range->min.value() : train.spacings[i].value();
    }
    return place;
}

void erase_train(femoop::MovingLoads& loads, femoop::TrainId train)
{
    loads.trains.erase(loads.trains.begin() + static_cast<std::ptrdiff_t>(train.index));
    for (femoop::MovingEnvelope& envelope : loads.envelopes) {
        std::erase(envelope.trains, train);
        for (femoop::TrainId& other : envelope.trains)
            if (other.index > train.index) other = femoop::TrainId(other.index - 1);
    }
    std::erase_if(loads.envelopes, [](const femoop::MovingEnvelope& envelope) { return envelope.trains.empty(); });
}

} // namespace frame
