#include "apps/cross/view/sheet_bays.h"

#include <algorithm>
#include <cmath>

namespace cross {

namespace {

constexpr double one_place = 1e-9; // of the beam's length: nodes nearer to each other are one place

std::vector<double> places_along(const drawing::StructureShape& shape)
{
    std::vector<double> places;
    for (const Eigen::Vector3d& node : shape.nodes) places.push_back(node.x());
    std::ranges::sort(places);
    const double least = places.empty() ? 0.0 : one_place * (places.back() - places.front());
    const auto are_one = [least](double a, double b) { return b - a <= least; };
    places.erase(std::unique(places.begin(), places.end(), are_one), places.end());
    return places;
}

std::vector<double> lengths_of(const std::vector<Bay>& bays, double scale)
{
    std::vector<double> lengths;
    for (const Bay& bay : bays) lengths.push_back(scale * (bay.end - bay.start));
    return lengths;
}

std::vector<double> needs_of(const std::vector<Bay>& bays, const ColumnNeeds& needs, double type)
{
    std::vector<double> all;
    for (const Bay& bay : bays) all.push_back(breadth_needed(bay, needs, type));
    return all;
}

double breadth_of(const std::vector<double>& values)
{
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

BayScale scale_of(const std::vector<Bay>& bays, const std::vector<double>& breadths_drawn, double scale)
{
    std::vector<double> places{bays.front().start}, drawn{bays.front().start};
    for (std::size_t i = 0; i < bays.size(); ++i) {
        places.push_back(bays[i].end);
        drawn.push_back(drawn.back() + breadths_drawn[i] / scale);
    }
    return {std::move(places), std::move(drawn)};
}

/// A member that is longer than the span stands there with none of its ends, or one.
bool is_filled_by(const Bay& bay, const drawing::MemberShape& member)
{
    const auto [low, high] = std::minmax(member.start_node.x(), member.end_node.x());
    const double near = 0.01 * (bay.end - bay.start);
    return std::abs(low - bay.start) < near && std::abs(high - bay.end) < near;
}

} // namespace

std::vector<Bay> bays_of(const drawing::StructureShape& shape, const femoop::cross::Problem& problem,
                         const std::vector<femoop::cross::EndId>& ends)
{
    const std::vector<double> places = places_along(shape);
    std::vector<Bay> bays;
    for (std::size_t i = 1; i < places.size(); ++i) bays.push_back({.start = places[i - 1], .end = places[i]});
    for (const femoop::cross::EndId end : ends) {
        if (!problem[end].member) continue;
        const drawing::MemberShape& member = shape[*problem[end].member];
        for (Bay& bay : bays) {
            if (!is_filled_by(bay, member)) continue;
            ++bay.n_columns;
            bay.is_overhang = problem.members[problem[end].member->index].is_overhang;
        }
    }
    return bays;
}

double breadth_needed(const Bay& bay, const ColumnNeeds& needs, double type)
{
    if (bay.n_columns == 0) return 0.0;
    const double gap = 0.55 * type; // then in steps of half the type
    const double steps = std::max(0.0, std::ceil((needs.support + 1.0 - gap) / (0.5 * type)));
    const double by_support = gap + 0.5 * steps * type, between = 0.2 * type;
    const double beside = by_support + (bay.is_overhang ? gap : by_support);
    const std::size_t in_row = (bay.n_columns + needs.n_rows - 1) / needs.n_rows;
    return static_cast<double>(in_row) * needs.ems * type + beside + between;
}

double breadth_needed(const std::vector<Bay>& bays, const ColumnNeeds& needs, double type)
{
    return breadth_of(needs_of(bays, needs, type));
}

BayScale bay_scale_for(const std::vector<Bay>& bays, const Panel& sheet, const ColumnNeeds& needs)
{
    constexpr double smaller = 0.95;
    if (bays.empty() || breadth_needed(bays, needs, needs.least_type) <= 0.0) return {};
    const double scale = sheet.camera.scale();
    const std::vector<double> lengths = lengths_of(bays, scale);
    for (double type = needs.largest_type; type >= needs.least_type; type *= smaller) {
        const std::vector<double> needed = needs_of(bays, needs, type);
        if (breadth_of(needed) > breadth_of(lengths)) continue;
        const bool is_wide_enough = std::ranges::equal(needed, lengths, std::less_equal<>());
        return is_wide_enough ? BayScale() : scale_of(bays, breadths(lengths, needed, breadth_of(lengths)), scale);
    }
    std::vector<double> shares = needs_of(bays, needs, needs.least_type);
    const double smaller_by = breadth_of(lengths) / breadth_of(shares);
    for (double& share : shares) share *= smaller_by;
    return scale_of(bays, shares, scale);
}

std::vector<Stretch> cut_into_pages(const Panel& whole, const std::vector<Bay>& bays, double page)
{
    std::vector<double> cuts;
    for (const Bay& bay : bays) cuts.push_back(whole.at({0.5 * (bay.start + bay.end), 0.0, 0.0}).x);
    cuts.push_back(whole.box.max.x);
    std::vector<Stretch> pages;
    double left = 0.0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        if (cuts[i + 1] - left > page && cuts[i] > left) {
            pages.push_back({left, cuts[i]});
            left = cuts[i];
        }
    pages.push_back({left, whole.box.max.x});
    return pages;
}

} // namespace cross
