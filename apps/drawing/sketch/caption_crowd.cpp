#include "apps/drawing/sketch/caption_crowd.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drawing {

namespace {

constexpr double square_side = 48.0; // [px]
constexpr int most_captions = 6;     // of which a square holds three or four
constexpr double most_squares = 512.0;

int n_squares(double length)
{
    return static_cast<int>(std::clamp(std::ceil(length / square_side), 1.0, most_squares));
}

} // namespace

CaptionCrowd::CaptionCrowd(const ui::Box& room)
    : corner_(room.min),
      n_columns_(n_squares(room.width())),
      n_rows_(n_squares(room.height())),
      squares_(static_cast<std::size_t>(n_columns_) * static_cast<std::size_t>(n_rows_))
{}

// What lies outside the room is counted to the squares along its border.
std::size_t CaptionCrowd::index(ui::Point target) const
{
    const auto at = [](double place, int n) {
        return static_cast<int>(std::clamp(std::floor(place / square_side), 0.0, static_cast<double>(n - 1)));
    };
    const int x = at(target.x - corner_.x, n_columns_), y = at(target.y - corner_.y, n_rows_);
    return static_cast<std::size_t>(y * n_columns_ + x);
}

bool CaptionCrowd::is_full(ui::Point target, Rank rank) const
{
    const Counts& counts = squares_[index(target)];
    return std::accumulate(counts.begin() + static_cast<std::ptrdiff_t>(rank), counts.end(), 0) >= most_captions;
}

void CaptionCrowd::add(ui::Point target, Rank rank) { ++squares_[index(target)][static_cast<std::size_t>(rank)]; }

} // namespace drawing
