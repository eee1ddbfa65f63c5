#pragma once

#include "ui/paint/geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace drawing {

/// Which labels choose their place first.
enum class Rank : std::uint8_t { Name, Minor, Value, Extreme, Load, Largest };
inline constexpr std::size_t n_ranks = static_cast<std::size_t>(Rank::Largest) + 1;

/// How many captions ask for a place in each square of a sheet. Where a thousand members stand close together nearly
/// all of theirs find none; to know it beforehand spares to write, measure and try them.
class CaptionCrowd {
public:
    explicit CaptionCrowd(const ui::Box& room);

    /// As many as could ever stand there, of this rank or of ranks that choose before it, ask already.
    bool is_full(ui::Point target, Rank rank) const;
    void add(ui::Point target, Rank rank);

private:
    using Counts = std::array<std::uint16_t, n_ranks>;

    std::size_t index(ui::Point target) const;

    ui::Point corner_;
    int n_columns_, n_rows_;
    std::vector<Counts> squares_;
};

} // namespace drawing
