#include "apps/plane/tools/readings.h"

#include "topology/geometry/flat_point.h"

namespace plane {

using Kind = ReadingPart::Kind;
using topology::distance;

namespace {

std::vector<ReadingPart> all_parts(const Readings& readings)
{
    std::vector<ReadingPart> parts;
    for (std::size_t i = 0; i < readings.probes.size(); ++i) parts.push_back({Kind::Probe, i});
    for (std::size_t i = 0; i < readings.cuts.size(); ++i) {
        parts.push_back({Kind::CutStart, i});
        parts.push_back({Kind::CutEnd, i});
    }
    return parts;
}

} // namespace

std::optional<std::size_t> Readings::told_probe() const
{
    if (probes.empty()) return std::nullopt;
    return last && last->kind == Kind::Probe ? last->index : probes.size() - 1;
}

void Readings::select(const ReadingPart& part)
{
    last = part;
    is_selected = true;
}

void Readings::add_probe(const FlatPoint& at)
{
    probes.push_back(at);
    select({Kind::Probe, probes.size() - 1});
}

void Readings::add_cut(const FlatPoint& start, const FlatPoint& end)
{
    cuts.push_back({start, end});
    select({Kind::CutEnd, cuts.size() - 1});
}

FlatPoint Readings::place(const ReadingPart& part) const
{
    if (part.kind == Kind::Probe) return probes.at(part.index);
    return cuts.at(part.index)[part.kind == Kind::CutStart ? 0 : 1];
}

void Readings::move(const ReadingPart& part, const FlatPoint& to)
{
    select(part);
    if (part.kind == Kind::Probe) {
        probes.at(part.index) = to;
        return;
    }
    auto& ends = cuts.at(part.index);
    const std::size_t end = part.kind == Kind::CutStart ? 0 : 1;
    if (distance(ends[1 - end], to) > 0.0) ends[end] = to;
}

void Readings::remove(const ReadingPart& part)
{
    const auto index = static_cast<std::ptrdiff_t>(part.index);
    if (part.kind == Kind::Probe) probes.erase(probes.begin() + index);
    else cuts.erase(cuts.begin() + index);
    last.reset();
    is_selected = false;
    const std::vector<ReadingPart> left = all_parts(*this);
    if (!left.empty()) last = left.back();
}

std::optional<ReadingPart> Readings::at(const FlatPoint& where, double reach) const
{
    std::optional<ReadingPart> nearest;
    for (const ReadingPart& part : all_parts(*this)) {
        const double away = distance(place(part), where);
        if (away > reach) continue;
        nearest = part;
        reach = away;
    }
    return nearest;
}

} // namespace plane
