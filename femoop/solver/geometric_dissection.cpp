#include "femoop/solver/geometric_dissection.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "femoop/solver/index.h"
#include "femoop/solver/multifrontal/team.h"

namespace femoop {

namespace {

constexpr std::size_t smallest_part = 4; // such few blocks are eliminated as they come
constexpr double slanted = 0.97;
constexpr std::size_t worth_threads = 10000;      // blocks, whose halves are then cut at the same time
constexpr std::int32_t first_of_others = 1 << 29; // cut of a second half

/// The mean distance of neighbours along each axis, of those that differ in it: bays and storeys count alike.
Eigen::Vector3d mean_steps(const BlockAdjacency& adjacency, std::span<const Eigen::Vector3d> positions)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d count = Eigen::Vector3d::Zero();
    for (std::size_t a = 0; a < positions.size(); ++a)
        for (const std::int32_t b : adjacency.of(static_cast<std::int32_t>(a))) {
            const Eigen::Vector3d step = (positions[at(b)] - positions[a]).cwiseAbs();
            const double negligible = 1e-6 * step.maxCoeff();
            for (int axis = 0; axis < 3; ++axis)
                if (step[axis] > negligible) {
                    sum[axis] += step[axis];
                    count[axis] += 1.0;
                }
        }
    return sum.cwiseQuotient(count.cwiseMax(1.0));
}

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
    Space(const BlockAdjacency& of_blocks, std::span<const Eigen::Vector3d> positions)
        : adjacency(of_blocks), mark(positions.size(), -1)
    {
        const Eigen::Vector3d steps = mean_steps(adjacency, positions);
        directions = femoop::directions(steps);
        places.reserve(positions.size());
        const Eigen::Vector3d scale = steps.unaryExpr([](double step) { return step > 0.0 ? 1.0 / step : 0.0; });
        for (const Eigen::Vector3d& position : positions)
            places.push_back((position - positions.front()).cwiseProduct(scale).cast<float>());
    }

    /// Two halves ask of each other's blocks at the same time; a mark of the other half is never one of their own.
    std::atomic_ref<std::int32_t> mark_of(std::int32_t block) { return std::atomic_ref(mark[at(block)]); }

    const BlockAdjacency& adjacency;
    std::vector<Eigen::Vector3f> places; ///< in steps
    std::vector<Eigen::Vector3f> directions;
    std::vector<std::int32_t> mark; ///< of each block: 2 x cut + side
};

class Dissector {
public:
    Dissector(Space& space, std::int32_t first_cut) : space_(space), n_cuts_(first_cut) {}

    Dissection run()
    {
        std::vector<std::int32_t> blocks;
        result_.order.reserve(space_.places.size());
        for (std::int32_t block = 0; block < static_cast<std::int32_t>(space_.places.size()); ++block)
            (space_.adjacency.of(block).empty() ? result_.order : blocks).push_back(block);
        add_part(0, 0, false);
        dissect(blocks, 0);
        return std::move(result_);
    }

private:
    /// A plane: blocks with direction . place < value lie below it.
    struct Cut {
        Eigen::Vector3f direction;
        float value = 0.0F;
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
        const std::optional<Cut> cut = blocks.size() > smallest_part ? best_cut(blocks) : std::nullopt;
        if (!cut) {
            result_.order.insert(result_.order.end(), blocks.begin(), blocks.end());
            add_part(result_.order.size() - blocks.size(), level, false);
            return;
        }
        mark(blocks, *cut);
        const std::int32_t along = 2 * n_cuts_ + (cut->separator_is_below ? 0 : 1);
        const auto is_separator = [&](std::int32_t b) { return marked(b) == along && touches_other_side(b); };
        const auto is_below = [&](std::int32_t b) { return marked(b) % 2 == 0; };
        const auto separator = std::stable_partition(blocks.begin(), blocks.end(), std::not_fn(is_separator));
        const auto above = std::stable_partition(blocks.begin(), separator, is_below);
        if (level == 0) result_.first_cut = static_cast<std::size_t>(blocks.end() - separator);
        if (level == 0 && blocks.size() >= worth_threads) {
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
    std::optional<Cut> best_cut(std::span<const std::int32_t> blocks)
    {
        Cut best;
        for (const Eigen::Vector3f& direction : space_.directions) {
            Cut cut = middle_cut(blocks, direction);
            if (direction.squaredNorm() > 1.5F) cut.cost *= slanted; // of equal cuts the slanted one leaves lozenges
            if (cut.cost < best.cost) best = cut;
        }
        if (std::isinf(best.cost)) return std::nullopt;
        return best;
    }

    Cut middle_cut(std::span<const std::int32_t> blocks, const Eigen::Vector3f& direction)
    {
        const std::size_t n = blocks.size();
        values_.resize(n);
        for (std::size_t i = 0; i < n; ++i) values_[i] = direction.dot(space_.places[at(blocks[i])]);
        const auto middle = values_.begin() + static_cast<std::ptrdiff_t>(n / 2);
        std::nth_element(values_.begin(), middle, values_.end());
        Cut cut{.direction = direction, .value = *middle - tolerance * std::abs(*middle) - tolerance};
        if (*std::min_element(values_.begin(), middle) >= cut.value) return cut; // none would lie below

        const std::size_t n_below = mark(blocks, cut);
        std::array<std::size_t, 2> touching{0, 0};
        for (const std::int32_t block : blocks)
            if (touches_other_side(block)) ++touching[at(marked(block) % 2)];
        cut.separator_is_below = touching[0] <= touching[1];
        const double imbalance = static_cast<double>(std::max(n_below, n - n_below)) / static_cast<double>(n);
        cut.cost = static_cast<double>(std::min(touching[0], touching[1])) * imbalance;
        return cut;
    }

    /// Marks each block with its side of a new cut, even below, odd above; returns how many are below.
    std::size_t mark(std::span<const std::int32_t> blocks, const Cut& cut)
    {
        ++n_cuts_;
        std::size_t n_below = 0;
        for (const std::int32_t block : blocks) {
            const bool is_below = cut.direction.dot(space_.places[at(block)]) < cut.value;
            n_below += is_below ? 1 : 0;
            space_.mark_of(block).store(2 * n_cuts_ + (is_below ? 0 : 1), std::memory_order_relaxed);
        }
        return n_below;
    }

    bool touches_other_side(std::int32_t block) const
    {
        const std::int32_t other = marked(block) ^ 1;
        const auto neighbours = space_.adjacency.of(block);
        return std::any_of(neighbours.begin(), neighbours.end(), [&](std::int32_t b) { return marked(b) == other; });
    }

    std::int32_t marked(std::int32_t block) const { return space_.mark_of(block).load(std::memory_order_relaxed); }

    static constexpr float tolerance = 1e-5F; // coordinates that differ by less are the same

    Space& space_;
    std::int32_t n_cuts_;
    std::vector<float> values_;
    Dissection result_;
};

} // namespace

Dissection geometric_dissection(const BlockAdjacency& adjacency, std::span<const Eigen::Vector3d> positions)
{
    Space space(adjacency, positions);
    return Dissector(space, 0).run();
}

} // namespace femoop
