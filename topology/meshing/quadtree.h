#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/geometry/flat_point.h"

namespace topology {

/// Squares, each cut into four equal ones or not, from one around all. Places in it are whole numbers of the smallest
/// step there can be.
///
///      +-------+---+---+      level 0 is the square around all
///      |       |   |   |      level 1 its quarters, at (0, 0), (half, 0), (0, half), (half, half)
///      |       +---+---+      ...
///      |       |   |   |      a square without quarters is a leaf
///      +-------+---+---+
class Quadtree {
public:
    using Index = std::uint32_t;
    using Step = std::uint64_t;
    static constexpr int deepest = 40; ///< level

    struct Square {
        Step x = 0, y = 0; ///< of its lower left corner
        int level = 0;
        Index first_quarter = 0; ///< the other three follow; 0 of a leaf
        bool is_leaf() const { return first_quarter == 0; }
        Step side() const { return Step{1} << static_cast<unsigned>(deepest - level); }
    };

    Quadtree(const FlatPoint& low, double side) : low_(low), step_(side / static_cast<double>(Step{1} << deepest)) {}

    /// Cuts a leaf. \pre it is not at the deepest level
    void quarter(Index leaf);
    /// The leaf that holds a place; of those that meet there the one to the upper right. \pre it is inside
    Index leaf_at(Step x, Step y) const;
    /// Whether a place is in the square around all, its upper and right side left out.
    static bool has(Step x, Step y) { return x < (Step{1} << deepest) && y < (Step{1} << deepest); }

    std::size_t size() const { return squares_.size(); }
    const Square& operator[](Index square) const { return squares_[square]; }
    FlatPoint place(Step x, Step y) const
    {
        return {low_.x + step_ * static_cast<double>(x), low_.y + step_ * static_cast<double>(y)};
    }
    double side(Index square) const { return step_ * static_cast<double>(squares_[square].side()); }
    FlatBox box(Index square) const;

private:
    FlatPoint low_;
    double step_;
    std::vector<Square> squares_{Square{}};
};

} // namespace topology
