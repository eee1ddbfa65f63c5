#include <algorithm>
#include <string_view>

#include "femoop/model/quantity/number_text.h"
#include "femoop/plane/check/plane_checker.h"
#include "femoop/plane/mesh/cut.h"

namespace femoop::plane {

namespace {

bool is_at_place(PlaneQuantity quantity)
{
    return quantity == PlaneQuantity::Displacement || quantity == PlaneQuantity::Stress ||
           quantity == PlaneQuantity::Strain;
}

bool is_of_a_case(const PlaneExpected& check)
{
    return check.analysis != ExpectedAnalysis::Modal && check.quantity != PlaneQuantity::Count &&
           check.quantity != PlaneQuantity::Area && check.quantity != PlaneQuantity::Frequency;
}

std::string place_text(const std::vector<Quantity>& at, const Units& units)
{
    return "(" + number_text(at[0]) + ", " + number_text(at[1]) + ") " + std::string(name(units.length));
}

} // namespace

void PlaneChecker::check_expected()
{
    for (std::size_t i = 0; i < model_.expected.size(); ++i) {
        is_partial_ = flag(unreadable_.expected, i);
        check_expected(model_.expected[i], {"expected", i, {}});
    }
}

void PlaneChecker::check_expected(const PlaneExpected& check, const Entry& place)
{
    if (check.load_case) require_entry(place, "cases", check.load_case->index, model_.n_cases());
    if (!check.load_case && is_of_a_case(check) && model_.n_cases() != 1)
        add(FaultKind::ExpectedWithoutCase, place, {std::to_string(model_.n_cases())});
    check_asked(check, place);
    require_finite(place, "value", check.value);
    if (check.rtol) require_not_negative(place, "rtol", *check.rtol, dimension::none);
    if (check.atol) require_not_negative(place, "atol", *check.atol, dimension_of(check));
}

std::vector<std::string_view> PlaneChecker::missing_keys(const PlaneExpected& check) const
{
    std::vector<std::string_view> missing;
    const auto need = [&](bool is_there, std::string_view key) {
        if (!is_there) missing.push_back(key);
    };
    switch (check.quantity) {
    case PlaneQuantity::Energy:
    case PlaneQuantity::Area: return missing;
    case PlaneQuantity::Frequency: need(check.rank.has_value(), "which"); return missing;
    case PlaneQuantity::Count: need(!check.counted.empty(), "component"); return missing;
    case PlaneQuantity::Extreme: need(check.extreme.has_value(), "which"); break;
    case PlaneQuantity::Resultant: need(!check.cut.empty(), "cut"); break;
    default: break;
    }
    need(check.component.has_value(), "component");
    return missing;
}

void PlaneChecker::check_asked(const PlaneExpected& check, const Entry& place)
{
    for (const std::string_view key : missing_keys(check))
        add(FaultKind::ExpectedKeyMissing, place, {std::string(name(check.quantity)), std::string(key)});
    if (is_partial_) return;
    const bool has_place = check.point.has_value() != !check.at.empty();
    if (is_at_place(check.quantity) && !has_place) {
        add(FaultKind::CheckPlace, place, {std::string(name(check.quantity))});
        return;
    }
    if (check.quantity == PlaneQuantity::Stress && check.read == StressReading::Gauss)
        add(FaultKind::CheckGaussPlace, place, {});
    if (check.quantity == PlaneQuantity::Resultant && model_.analysis == StressState::Axisymmetric)
        add(FaultKind::CutOfRevolution, place, {});
    if (check.quantity == PlaneQuantity::Count || check.quantity == PlaneQuantity::Area) check_face_asked(check, place);
    if (!supports_ || model_.elements.empty()) return;
    if (is_at_place(check.quantity)) check_place(check, place);
    if (check.quantity == PlaneQuantity::Resultant) check_cut(check, place);
    if (check.quantity == PlaneQuantity::Reaction) check_reaction(check, place);
    if (check.quantity == PlaneQuantity::Extreme) check_extreme(check, place);
}

const Locator& PlaneChecker::locator()
{
    if (!locator_) locator_.emplace(model_);
    return *locator_;
}

std::vector<RegionId> PlaneChecker::regions_at(const PlaneExpected& check)
{
    if (check.point) return regions_of_point_->of(*check.point);
    std::vector<RegionId> regions;
    for (const Location& location : locator().find({check.at[0], check.at[1]}))
        if (const RegionId region = model_[location.element].region;
            std::ranges::find(regions, region) == regions.end())
            regions.push_back(region);
    return regions;
}

void PlaneChecker::check_place(const PlaneExpected& check, const Entry& place)
{
    const std::vector<RegionId> regions = regions_at(check);
    const bool needs_side = check.quantity != PlaneQuantity::Displacement;
    if (regions.empty() && check.point) add(FaultKind::PointWithoutElements, place, {model_[*check.point].id});
    else if (regions.empty()) add(FaultKind::CheckOutside, place, {place_text(check.at, model_.units)});
    else if (check.region && std::ranges::find(regions, *check.region) == regions.end())
        add(FaultKind::CheckRegionElsewhere, place, {model_[*check.region].id});
    else if (!check.region && regions.size() > 1 && needs_side) {
        std::vector<std::string> names;
        for (const RegionId region : regions) names.push_back(model_[region].id);
        add(FaultKind::CheckRegionNeeded, place, {listed(names)});
    }
}

void PlaneChecker::check_cut(const PlaneExpected& check, const Entry& place)
{
    if (check.cut.empty()) return;
    const Cut cut{{check.cut[0], check.cut[1]}, {check.cut[2], check.cut[3]}};
    if (pieces_along(model_, locator(), cut).empty()) add(FaultKind::CutOutside, place, {});
}

/// Of a region along a curve that it does not touch there is nothing to be read.
void PlaneChecker::check_extreme(const PlaneExpected& check, const Entry& place)
{
    if (!check.curve || !check.region) return;
    const auto is_in_region = [&](const CurveNode& each) {
        const std::vector<RegionId> regions = regions_of_point_->of(each.node);
        return std::ranges::find(regions, *check.region) != regions.end();
    };
    if (std::ranges::none_of(curves_->geometry[check.curve->index].nodes(), is_in_region))
        add(FaultKind::CheckRegionElsewhere, place, {model_[*check.region].id});
}

void PlaneChecker::check_reaction(const PlaneExpected& check, const Entry& place)
{
    bool is_held = !check.point && !check.curve;
    if (check.point) is_held = (*supports_)[*check.point].is_held();
    if (check.curve)
        for (const CurveNode& node : curves_->geometry[check.curve->index].nodes())
            is_held = is_held || (*supports_)[node.node].is_held();
    if (!is_held) add(FaultKind::CheckNotSupported, place, {});
}

} // namespace femoop::plane
