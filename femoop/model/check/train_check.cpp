#include <algorithm>
#include <string>
#include <utility>

#include "femoop/model/check/check.h"
#include "femoop/model/check/checker.h"
#include "femoop/model/quantity/dof_dimension.h"

namespace femoop {

namespace {

std::string with_key(std::string_view key, std::size_t number)
{
    return std::string(key) + ' ' + std::to_string(number);
}

} // namespace

void Checker::check_trains()
{
    const MovingLoads& moving = model_.moving_loads;
    for (std::size_t i = 0; i < moving.trains.size(); ++i) {
        is_partial_ = flag(unreadable_.trains, i);
        check_train(moving.trains[i], {"trains", i, moving.trains[i].id});
    }
    for (std::size_t i = 0; i < moving.envelopes.size(); ++i) {
        is_partial_ = flag(unreadable_.moving_envelopes, i);
        check_envelope(moving.envelopes[i], {"moving_envelopes", i, moving.envelopes[i].id});
    }
}

void Checker::check_train(const Train& train, const Entry& place)
{
    check_moving_load(train.path, train.load, place);
    if (train.axles.empty() && !train.uniform) add(FaultKind::TrainWithoutLoad, place, {});
    for (std::size_t i = 0; i < train.axles.size(); ++i) require_finite(place, with_key("axle", i + 1), train.axles[i]);
    check_spacings(train, place);
    require_not_negative(place, "impact", Quantity(train.impact), dimension::none);
    if (train.uniform) require_finite(place, "uniform", *train.uniform);
    if (train.gap) require_not_negative(place, "gap", *train.gap, dimension::length);
    for (const ConcentratedForce& force : train.concentrated) {
        require_finite(place, "concentrated", force.for_moments);
        if (force.for_others) require_finite(place, "concentrated", *force.for_others);
    }
}

void Checker::check_spacings(const Train& train, const Entry& place)
{
    const std::size_t n = train.spacings.size(), n_wanted = train.axles.empty() ? 0 : train.axles.size() - 1;
    if (n != n_wanted)
        add(FaultKind::AxlesAndSpacings, place,
            {std::to_string(train.axles.size()), std::to_string(n), std::to_string(n_wanted)});
    for (std::size_t i = 0; i < n; ++i)
        require_not_negative(place, with_key("spacing", i + 1), train.spacings[i], dimension::length);
    for (const SpacingRange& range : train.spacing_ranges) {
        const std::string key = with_key("spacing", range.spacing + 1);
        if (range.spacing >= std::max(n, n_wanted)) // one that is wanted is told to be missing already
            add(FaultKind::RangeOfNoSpacing, place, {std::to_string(range.spacing + 1), std::to_string(n)});
        require_not_negative(place, key, range.min, dimension::length);
        require_not_negative(place, key, range.max, dimension::length);
        if (range.min > range.max)
            faults_.push_back(
                {FaultKind::RangeReversed,
                 {Entry{place.list, place.index, {}}.text() + ".spacing_ranges." + std::to_string(range.spacing + 1),
                  shown(range.min, dimension::length), shown(range.max, dimension::length)}});
    }
}

void Checker::check_envelope(const MovingEnvelope& envelope, const Entry& place)
{
    if (envelope.trains.empty()) add(FaultKind::EnvelopeWithoutTrains, place, {});
    for (const TrainId train : envelope.trains)
        require_entry(place, "trains", train.index, model_.moving_loads.trains.size());
    if (envelope.with) require_entry(place, "cases", envelope.with->index, model_.n_cases());
    require_not_negative(place, "factor", Quantity(envelope.factor), dimension::none);
}

std::vector<Fault> Checker::run_train(const Train& train, const Entry& place)
{
    check_train(train, place);
    return std::move(faults_);
}

std::vector<Fault> Checker::run_effect(const MovingEffect& effect, const Entry& place)
{
    check_effect(effect, place);
    return std::move(faults_);
}

std::vector<Fault> check_train(const Model& model, const Train& train, const PartName& part)
{
    const Unreadable nothing;
    return Checker(model, nothing).run_train(train, {part.list, part.index, {}});
}

std::vector<Fault> check_effect(const Model& model, const MovingEffect& effect, const PartName& part)
{
    const Unreadable nothing;
    return Checker(model, nothing).run_effect(effect, {part.list, part.index, {}});
}

} // namespace femoop
