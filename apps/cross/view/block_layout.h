#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "femoop/methods/cross/problem.h"
#include "ui/paint/geometry.h"

namespace cross {

/// Of a beam, where its column is to stand.
enum class BeamSide : std::uint8_t { Either, Below, Above };

/// One member end on the sheet, looking for room for its column of numbers.
struct EndPlace {
    femoop::cross::EndId end;
    ui::Point joint;
    ui::Point along;         ///< unit vector from the joint into the member
    double length = 0.0;     ///< of the member on the sheet
    std::size_t n_spare = 0; ///< lines that its column has less than the longest
    bool has_box = true;     ///< room for that of the factor, between name and numbers
    BeamSide side = BeamSide::Either;
};

/// Where the columns stand.
struct BlockLayout {
    std::vector<std::optional<ui::Box>> boxes; ///< of every place; nothing where there was no room, or the
                                               ///< place lies beyond it
    double type = 13.0;                        ///< size of the numbers
    std::size_t n_lines = 0;                   ///< between the box of the factor and the sum
    double clarity = 0.5; ///< 1 where every column stands beside its member end: worth larger type elsewhere
};

struct BlockRequest {
    std::vector<EndPlace> places;
    std::vector<ui::Box> obstacles;
    std::vector<ui::Box> walls{}; ///< members: a column farther out has none between it and its own
    ui::Box room;
    ui::Point middle;             ///< of the structure: columns keep to its outside
    double largest_type = 13.0;   ///< of the numbers, where there is room
    std::size_t most_lines = 16;  ///< between factor and sum
    std::size_t fewest_lines = 4; ///< likewise: with fewer, type gets smaller instead
    std::size_t last_resort = 3;  ///< likewise, where not all find room: a moment, what left, the last number
    double least_type = 9.0;
    std::size_t n_rows = 1;       ///< of columns one below another, where those beside the members have no room
    double hardly_smaller = 0.85; ///< of the largest type: rather so than in several rows
    std::function<double(double)> width_of; ///< of a column at a size of type
};

inline constexpr double line_height = 1.32;      ///< of the size of type
inline constexpr double column_gap = 0.55;       ///< between a joint and its columns
inline constexpr double head_height = 2.75;      ///< name and box of the factor
inline constexpr double bare_head_height = 1.15; ///< name alone
inline constexpr double total_height = 1.55;     ///< the sum

/// As large and as long as they all find room beside their member ends; where even the smallest do not, the first ones
/// get it.
BlockLayout laid_out(const BlockRequest& request);

bool is_whole(const BlockLayout& layout); ///< every place has its box
/// More columns find room, each where it belongs, or in clearly larger type. \pre both are of the same places
bool is_better(const BlockLayout& a, const BlockLayout& b);

} // namespace cross
