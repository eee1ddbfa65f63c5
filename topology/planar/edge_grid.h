#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/geometry/curve.h"

namespace topology {

/// Cells of equal size over a part of the plane, each with the numbers of what is in it: so that what is near is found
/// without a look at all. A number may stand where its thing no longer is; it never lacks where it is.
class EdgeGrid {
public:
    EdgeGrid() = default;
    /// \param n  about how many things there will be
    EdgeGrid(const FlatBox& box, std::size_t n);

    const FlatBox& box() const { return box_; }
    bool covers(const FlatBox& box) const;

    void put_at(const FlatPoint& p, std::uint32_t number) { put(column(p.x) + row(p.y) * n_columns_, number); }
    /// In all cells that the span of a curve crosses, and those as far as `reach` from it.
    void put_along(const Curve& curve, Span span, double reach, std::uint32_t number)
    {
        walk(curve, span, reach, [&](std::size_t cell) { put(cell, number); });
    }

    /// Calls see(number) for what is in those cells; what is in several of them is seen several times.
    template <class See> void along(const Curve& curve, Span span, double reach, const See& see) const
    {
        walk(curve, span, reach, [&](std::size_t cell) { each(cell, see); });
    }
    /// Cells from p to the right: calls see(number), until is_enough(x where a cell ends).
    template <class See, class IsEnough>
    void to_the_right(const FlatPoint& p, const See& see, const IsEnough& is_enough) const
    {
        const std::size_t start = row(p.y) * n_columns_;
        for (std::size_t i = column(p.x); i < n_columns_; ++i) {
            each(start + i, see);
            if (is_enough(box_.low.x + static_cast<double>(i + 1) * width_)) return;
        }
    }

private:
    static constexpr std::uint32_t none = ~0U;
    /// Of the list of a cell. All lists share one store: cells are made anew whenever there are twice as many things,
    /// and a store of its own for each would have to be found and given back.
    struct Entry {
        std::uint32_t number, next;
    };

    void put(std::size_t cell, std::uint32_t number)
    {
        std::uint32_t& first = firsts_[cell];
        if (first != none && entries_[first].number == number) return;
        entries_.push_back({number, first});
        first = static_cast<std::uint32_t>(entries_.size() - 1);
    }
    template <class See> void each(std::size_t cell, const See& see) const
    {
        for (std::uint32_t i = firsts_[cell]; i != none; i = entries_[i].next) see(entries_[i].number);
    }

    template <class Use> void walk(const Curve& curve, Span span, double reach, const Use& use) const
    {
        if (curve.is_straight()) return walk(curve.at(span.from), curve.at(span.to), reach, use);
        constexpr int most_parts = 64;
        const double size = curve.box(span).diagonal();
        int n_parts = 4;
        while (n_parts < most_parts && size > n_parts * (width_ + height_)) n_parts *= 2;
        for (int i = 0; i < n_parts; ++i) {
            const Span part{span.at(static_cast<double>(i) / n_parts), span.at(static_cast<double>(i + 1) / n_parts)};
            walk(curve.box(part).grown(reach), use);
        }
    }

    template <class Use> void walk(const FlatBox& box, const Use& use) const
    {
        const std::size_t left = column(box.low.x), right = column(box.high.x);
        for (std::size_t j = row(box.low.y), top = row(box.high.y); j <= top; ++j)
            for (std::size_t i = left; i <= right; ++i) use(i + j * n_columns_);
    }

    /// Row by row, those columns that the line may touch.
    template <class Use> void walk(FlatPoint a, FlatPoint b, double reach, const Use& use) const
    {
        if (b.y < a.y) std::swap(a, b);
        const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0.0;
        const auto x_at = [&](double y) { return a.x + (std::clamp(y, a.y, b.y) - a.y) * slope; };
        for (std::size_t j = row(a.y - reach), top = row(b.y + reach); j <= top; ++j) {
            const double low = box_.low.y + static_cast<double>(j) * height_ - reach,
                         high = low + height_ + 2.0 * reach;
            double x0 = x_at(low), x1 = x_at(high);
            if (b.y == a.y) {
                x0 = a.x;
                x1 = b.x;
            }
            // what rounding makes of the row's edges moves them by less than a hundredth of a cell
            const double margin = reach + 0.01 * width_;
            const std::size_t left = column(std::min(x0, x1) - margin), right = column(std::max(x0, x1) + margin);
            for (std::size_t i = left; i <= right; ++i) use(i + j * n_columns_);
        }
    }

    static std::size_t place(double along, std::size_t n)
    {
        if (!(along > 0.0)) return 0;
        const auto i = static_cast<std::size_t>(along);
        return i < n ? i : n - 1;
    }
    std::size_t column(double x) const { return place((x - box_.low.x) / width_, n_columns_); }
    std::size_t row(double y) const { return place((y - box_.low.y) / height_, n_rows_); }

    FlatBox box_;
    std::size_t n_columns_ = 0, n_rows_ = 0;
    double width_ = 1.0, height_ = 1.0; ///< of a cell
    std::vector<std::uint32_t> firsts_; ///< of each cell, its newest entry
    std::vector<Entry> entries_;
};

} // namespace topology
