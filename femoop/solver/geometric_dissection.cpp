#include "femoop/solver/geometric_dissection.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "femoop/solver/at_once.h"
#include "femoop/solver/index.h"
#include "femoop/solver/team.h"

namespace femoop {

namespace {

constexpr std::size_t smallest_part = 4; // such few blocks are eliminated as they come
constexpr double slanted = 0.97;
constexpr std::size_t blocks_measured_at_once = 20000; // by a thread
constexpr std::size_t worth_two_halves = 10000;        // blocks, whose halves are then cut at the same time
constexpr std::int32_t first_of_others = 1 << 29;      // cut of a second half

/// Distances of neighbours along each axis.
struct Steps {
    Eigen::Vector3d mean; ///< of those that differ in it: bays and storeys count alike
    Eigen::Vector3d largest;
};

/// Of the blocks of a range.
struct StepSums {
    Eigen::Vector3d largest = Eigen::Vector3d::Zero();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d count = Eigen::Vector3d::Zero();

    void add(const Eigen::Vector3d& step)
    {
        largest = largest.cwiseMax(step);
        const double negligible = 1e-6 * step.maxCoeff();
        for (int axis = 0; axis < 3; ++axis)
            if (step[axis] > negligible) {
                sum[axis] += step[axis];
                count[axis] += 1.0;
            }
    }
};

Steps steps_between(const BlockAdjacency& adjacency, std::span<const Eigen::Vector3d> positions)
{
    std::vector<StepSums> sums(positions.size() / blocks_measured_at_once + 1);
    in_ranges(positions.size(), blocks_measured_at_once, [&](std::size_t begin, std::size_t end) {
        StepSums of_range;
        for (std::size_t a = begin; a < end; ++a)
            for (const std::int32_t b : adjacency.of(static_cast<std::int32_t>(a)))
                of_range.add((positions[at(b)] - positions[a]).cwiseAbs());
        sums[begin / blocks_measured_at_once] = of_range;
    });
    StepSums all;
    for (const StepSums& each : sums) {
        all.largest = all.largest.cwiseMax(each.largest);
        all.sum += each.sum;
        all.count += each.count;
    }
    return {.mean = all.sum.cwiseQuotient(all.count.cwiseMax(1.0)), .largest = all.largest};
}

/// A normal of planes, and how far each block lies along it, in steps.
struct Direction {
    Eigen::Vector3f normal;
    std::vector<float> values;
};

/// Normals of the planes to try, in steps: along the axes that the structure extends in, and between them.
std::vector<Eigen::Vector3f> directions(const Eigen::Vector3d& steps)
{
    std::vector<Eigen::Vector3f> all;
    for (const float x : {0.0F, 1.0F})
        for (const float y : {-1.0F, 0.0F, 1.0F})
            for (const float z : {-1.0F, 0.0F, 1.0F}) {
                const Eigen::Vector3f direction(x, y, z);
                Eigen::Index first = 0;
                while (first < 3 && direction[first] == 0.0F) ++first;
                bool is_new = first < 3 && direction[first] > 0.0F; // of two opposite ones the positive
                for (int axis = 0; axis < 3; ++axis) is_new &= direction[axis] == 0.0F || steps[axis] > 0.0;
                if (is_new) all.push_back(direction);
            }
    return all;
}

/// The structure in space, as all cuts see it.
struct Space {
    static constexpr std::int32_t unmarked = -1;

    Space(const BlockAdjacency& of_blocks, std::span<const Eigen::Vector3d> positions)
        : adjacency(of_blocks), mark(positions.size(), unmarked)
    {
        const Steps steps = steps_between(adjacency, positions);
        const Eigen::Vector3d scale = steps.mean.unaryExpr([](double step) { return step > 0.0 ? 1.0 / step : 0.0; });
        largest_step = (1.001 * steps.largest.cwiseProduct(scale)).cast<float>().array() + 1e-3F; // rounding included
        for (const Eigen::Vector3f& normal : femoop::directions(steps.mean))
            directions.push_back({.normal = normal, .values = std::vector<float>(positions.size())});
        in_ranges(positions.size(), blocks_measured_at_once, [&](std::size_t begin, std::size_t end) {
            for (std::size_t block = begin; block < end; ++block) {
                const Eigen::Vector3f place = (positions[block] - positions.front()).cwiseProduct(scale).cast<float>();
                for (Direction& direction : directions) direction.values[block] = direction.normal.dot(place);
            }
        });
    }

    /// No neighbours are further apart along a direction.
    float reach(const Direction& direction) const { return direction.normal.cwiseAbs().dot(largest_step); }

    /// Two halves ask of each other's blocks at the same time; a mark of the other half is never one of their own.
    std::atomic_ref<std::int32_t> mark_of(std::int32_t block) { return std::atomic_ref(mark[at(block)]); }

    const BlockAdjacency& adjacency;
    std::vector<Direction> directions;
    Eigen::Vector3f largest_step;   ///< between neighbours, along each axis, in steps
    std::vector<std::int32_t> mark; ///< of each block: 2 x cut + side, of the last cut that parted it from others
};

/// The value in the middle of all if they were sorted. Of many, those are sorted that lie about the middle of a sample.
float median(std::span<const float> values, std::vector<float>& room)
{
    constexpr std::size_t many = 512, n_samples = 64, aside = 12;
    const std::size_t middle = values.size() / 2;
    if (values.size() >= many) {
        room.resize(values.size());
        std::array<float, n_samples> sample{};
        for (std::size_t i = 0; i < n_samples; ++i) sample[i] = values[i * values.size() / n_samples];
        std::ranges::sort(sample);
        const float low = sample[n_samples / 2 - aside], high = sample[n_samples / 2 + aside];
        std::size_t n_below = 0, n_between = 0;
        for (const float v : values) {
            n_below += v < low ? 1 : 0;
            room[n_between] = v;
            n_between += v >= low && v <= high ? 1 : 0;
        }
        if (n_below <= middle && middle < n_below + n_between) {
            const auto found = room.begin() + static_cast<std::ptrdiff_t>(middle - n_below);
            std::nth_element(room.begin(), found, room.begin() + static_cast<std::ptrdiff_t>(n_between));
            return *found;
        }
    }
    room.assign(values.begin(), values.end());
    const auto found = room.begin() + static_cast<std::ptrdiff_t>(middle);
    std::nth_element(room.begin(), found, room.end());
    return *found;
}

class Dissector {
public:
    Dissector(Space& space, std::int32_t first_cut) : space_(space), n_cuts_(first_cut) {}

    Dissection run()
    {
        std::vector<std::int32_t> blocks;
        result_.order.reserve(space_.mark.size());
        for (std::int32_t block = 0; block < static_cast<std::int32_t>(space_.mark.size()); ++block)
            (space_.adjacency.of(block).empty() ? result_.order : blocks).push_back(block);
        add_part(0, 0, false);
        dissect(blocks, 0);
        return std::move(result_);
    }

private:
    /// A plane: blocks with a smaller value along the direction lie below it.
    struct Cut {
        const Direction* direction = nullptr;
        float value = 0.0F;
        float reach = 0.0F;             ///< no block that is further away has a neighbour on the other side
        bool separator_is_below = true; ///< which side's blocks along the cut are the separator
        double cost = std::numeric_limits<double>::infinity();
    };

    /// Of what was ordered from place `first` on.
    void add_part(std::size_t first, std::int32_t level, bool is_separator)
    {
        if (first == result_.order.size()) return;
        result_.parts.push_back(
            {.first = first, .end = result_.order.size(), .level = level, .is_separator = is_separator});
    }

    void dissect(std::span<std::int32_t> blocks, std::int32_t level)
    {
        const std::optional<Cut> cut = blocks.size() > smallest_part ? best_cut(blocks, level) : std::nullopt;
        if (!cut) {
            result_.order.insert(result_.order.end(), blocks.begin(), blocks.end());
            add_part(result_.order.size() - blocks.size(), level, false);
            return;
        }
        mark(blocks, *cut);
        const std::int32_t along = 2 * n_cuts_ + (cut->separator_is_below ? 0 : 1);
        const auto is_separator = [&](std::int32_t b) {
            return marked(b) == along && is_near(value(b, *cut), *cut) && touches(b, along ^ 1);
        };
        const auto is_below = [&](std::int32_t b) { return marked(b) % 2 == 0; };
        const auto separator = std::stable_partition(blocks.begin(), blocks.end(), std::not_fn(is_separator));
        const auto above = std::stable_partition(blocks.begin(), separator, is_below);
        for (const std::int32_t block : std::span(separator, blocks.end())) set_mark(block, Space::unmarked);
        if (level == 0) result_.first_cut = static_cast<std::size_t>(blocks.end() - separator);
        if (level == 0 && blocks.size() >= worth_two_halves) {
            dissect_together({blocks.begin(), above}, {above, separator});
        } else {
            dissect({blocks.begin(), above}, level + 1);
            dissect({above, separator}, level + 1);
        }
        const std::size_t first = result_.order.size();
        result_.order.insert(result_.order.end(), separator, blocks.end());
        add_part(first, level, true);
    }

    /// The halves of the whole.
    void dissect_together(std::span<std::int32_t> below, std::span<std::int32_t> above)
    {
        std::array halves{Dissector(space_, n_cuts_), Dissector(space_, first_of_others)};
        Team(2).for_each(2, [&](std::int32_t half, int) { halves[at(half)].dissect(half == 0 ? below : above, 1); });
        for (const Dissector& half : halves) append(half.result_);
    }

    void append(const Dissection& half)
    {
        const std::size_t first = result_.order.size();
        result_.order.insert(result_.order.end(), half.order.begin(), half.order.end());
        for (Dissection::Part part : half.parts) {
            part.first += first;
            part.end += first;
            result_.parts.push_back(part);
        }
    }

    /// The narrowest cut near the middle; nothing where all blocks are in one place.
    std::optional<Cut> best_cut(std::span<const std::int32_t> blocks, std::int32_t level)
    {
        const auto n = static_cast<std::int32_t>(space_.directions.size());
        std::vector<Cut> cuts(at(n));
        const bool in_two_threads = level == 0 && blocks.size() >= worth_two_halves;
        if (in_two_threads)
            Team(2).for_each(n, [&](std::int32_t i, int) {
                std::vector<float> values, room;
                cuts[at(i)] = middle_cut(blocks, space_.directions[at(i)], values, room);
            });
        else
            for (std::int32_t i = 0; i < n; ++i)
                cuts[at(i)] = middle_cut(blocks, space_.directions[at(i)], values_, room_);
        Cut best;
        for (Cut& cut : cuts) {
            if (cut.direction->normal.squaredNorm() > 1.5F)
                cut.cost *= slanted; // of equal cuts the slanted one leaves lozenges
            if (cut.cost < best.cost) best = cut;
        }
        if (std::isinf(best.cost)) return std::nullopt;
        return best;
    }

    /// \param values, room  room for them
    Cut middle_cut(std::span<const std::int32_t> blocks, const Direction& direction, std::vector<float>& values,
                   std::vector<float>& room) const
    {
        const std::size_t n = blocks.size();
        values.resize(n);
        for (std::size_t i = 0; i < n; ++i) values[i] = direction.values[at(blocks[i])];
        const float middle = median(values, room);
        Cut cut{.direction = &direction,
                .value = middle - tolerance * std::abs(middle) - tolerance,
                .reach = space_.reach(direction)};
        const auto n_below = static_cast<std::size_t>(
            std::ranges::count_if(values, [&](float v) { return v < cut.value; }));
        if (n_below == 0) return cut;

        std::array<std::size_t, 2> touching{0, 0};
        const std::int32_t here = marked(blocks.front());
        for (std::size_t i = 0; i < n; ++i)
            if (is_near(values[i], cut) && has_neighbour_beyond(blocks[i], cut, here))
                ++touching[values[i] < cut.value ? 0 : 1];
        cut.separator_is_below = touching[0] <= touching[1];
        const double imbalance = static_cast<double>(std::max(n_below, n - n_below)) / static_cast<double>(n);
        cut.cost = static_cast<double>(std::min(touching[0], touching[1])) * imbalance;
        return cut;
    }

    float value(std::int32_t block, const Cut& cut) const { return cut.direction->values[at(block)]; }
    static bool is_near(float value, const Cut& cut) { return std::abs(value - cut.value) <= cut.reach; }

    /// Of the same piece, on the other side of a cut. \pre the blocks of the piece, and no others, are marked so
    bool has_neighbour_beyond(std::int32_t block, const Cut& cut, std::int32_t piece) const
    {
        const bool is_below = value(block, cut) < cut.value;
        const auto neighbours = space_.adjacency.of(block);
        return std::any_of(neighbours.begin(), neighbours.end(), [&](std::int32_t b) {
            return marked(b) == piece && (value(b, cut) < cut.value) != is_below;
        });
    }

    /// Marks each block with its side of a new cut, even below, odd above.
    void mark(std::span<const std::int32_t> blocks, const Cut& cut)
    {
        ++n_cuts_;
        for (const std::int32_t block : blocks) set_mark(block, 2 * n_cuts_ + (value(block, cut) < cut.value ? 0 : 1));
    }

    bool touches(std::int32_t block, std::int32_t other_mark) const
    {
        const auto neighbours = space_.adjacency.of(block);
        return std::any_of(neighbours.begin(), neighbours.end(),
                           [&](std::int32_t b) { return marked(b) == other_mark; });
    }

    std::int32_t marked(std::int32_t block) const { return space_.mark_of(block).load(std::memory_order_relaxed); }
    void set_mark(std::int32_t block, std::int32_t mark)
    {
        space_.mark_of(block).store(mark, std::memory_order_relaxed);
    }

    static constexpr float tolerance = 1e-5F; // coordinates that differ by less are the same

    Space& space_;
    std::int32_t n_cuts_;
    std::vector<float> values_, room_; ///< of the blocks along a direction
    Dissection result_;
};

} // namespace

Dissection geometric_dissection(const BlockAdjacency& adjacency, std::span<const Eigen::Vector3d> positions)
{
    Space space(adjacency, positions);
    return Dissector(space, 0).run();
}

} // namespace femoop
