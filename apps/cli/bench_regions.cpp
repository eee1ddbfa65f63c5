#include "apps/cli/bench_regions.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace cli {

namespace {

using topology::FlatPoint;

constexpr double square = 1048576.0; // 2^20
constexpr double usual_snap = 1e-9;  // of its diagonal

/// [Steele2014: splitmix64]
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t number() ///< 0 to 2^20 - 1
    {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return (z ^ (z >> 31U)) % (1U << 20U);
    }

private:
    std::uint64_t state_;
};

/// From one place to a second number, which is a place of its own or an offset.
double end_of(double start, std::uint64_t number, bool is_long)
{
    constexpr std::uint64_t reach = 20000;
    if (is_long) return static_cast<double>(number);
    return start + static_cast<double>(number % (2 * reach + 1)) - static_cast<double>(reach);
}

} // namespace

std::vector<topology::Segment> segments_of(const RegionLines& lines)
{
    Dice dice(lines.seed);
    std::vector<topology::Segment> segments;
    for (std::size_t i = 0; i < lines.n; ++i) {
        const auto x = static_cast<double>(dice.number()), y = static_cast<double>(dice.number());
        const std::uint64_t along = dice.number(), up = dice.number();
        const FlatPoint a{x, y}, b{end_of(x, along, lines.is_long), end_of(y, up, lines.is_long)};
        if (!(a == b)) segments.push_back({a, b});
    }
    return segments;
}

RegionBench bench_regions(const RegionLines& lines, bool one_by_one)
{
    using Clock = std::chrono::steady_clock;
    const std::vector<topology::Segment> segments = segments_of(lines);
    topology::PlanarSubdivision plane(usual_snap * std::sqrt(2.0) * square);
    RegionBench bench;
    std::size_t n_regions = 0;
    const Clock::time_point begin = Clock::now();
    Clock::time_point last = begin;
    for (const topology::Segment& segment : segments) {
        if (plane.insert(segment, {segment.a, segment.b})) throw std::logic_error("bench regions: a line is refused");
        if (one_by_one) n_regions = std::max(n_regions, plane.n_regions());
        const Clock::time_point now = Clock::now();
        bench.slowest_insertion = std::max(bench.slowest_insertion, std::chrono::duration<double>(now - last).count());
        last = now;
    }
    bench.seconds = std::chrono::duration<double>(last - begin).count();
    bench.counts = plane.counts();
    if (one_by_one && n_regions != bench.counts.regions) throw std::logic_error("bench regions: a region was lost");
    return bench;
}

} // namespace cli
