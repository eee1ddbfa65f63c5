#include "femoop/element/span_load.h"

#include <algorithm>
#include <cmath>

namespace femoop {

void SpanLoading::assign(double L, std::span<const Scaled> terms, double longest, double settling)
{
    length_ = L;
    last_jump_ = {};
    strain_ = curvature_ = 0.0;
    zero_ = true;
    cut(terms, longest, settling);
    for (const Scaled& term : terms)
        for (const SpanLoad& load : term.loads) add(load, term.factor);
}

SpanLoading SpanLoading::without_strain() const
{
    SpanLoading loading = *this;
    loading.strain_ = loading.curvature_ = 0.0;
    return loading;
}

void SpanLoading::cut(std::span<const Scaled> terms, double longest, double settling)
{
    places_.clear();
    places_.push_back(0.0);
    places_.push_back(length_);
    for (const Scaled& term : terms)
        for (const SpanLoad& load : term.loads) {
            if (load.kind == SpanLoad::Kind::Strain) continue;
            if (load.from > 0.0 && load.from < length_) places_.push_back(load.from);
            if (load.kind == SpanLoad::Kind::Distributed && load.to < length_) places_.push_back(load.to);
        }
    if (places_.size() > 2) {
        std::sort(places_.begin(), places_.end());
        places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    }
    pieces_.clear();
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
        const double begin = places_[i], end = places_[i + 1];
        const std::size_t first = pieces_.size();
        if (end - begin > 2.0 * (settling + longest)) {
            cut(begin, begin + settling, longest);
            SpanPiece& middle = pieces_.emplace_back();
            middle.begin = begin + settling;
            middle.end = end - settling;
            middle.is_settled = true;
            cut(end - settling, end, longest);
        } else cut(begin, end, longest);
        for (std::size_t k = first + 1; k < pieces_.size(); ++k) pieces_[k].begins_at_load = false;
    }
}

void SpanLoading::cut(double begin, double end, double longest)
{
    const double stretch = end - begin;
    const auto n = stretch > longest ? static_cast<std::size_t>(std::ceil(stretch / longest)) : 1;
    const double step = stretch / static_cast<double>(n);
    for (std::size_t k = 0; k < n; ++k) {
        SpanPiece& piece = pieces_.emplace_back();
        piece.begin = begin + step * static_cast<double>(k);
        piece.end = k + 1 == n ? end : begin + step * static_cast<double>(k + 1);
    }
}

void SpanLoading::add(const SpanLoad& load, double factor)
{
    zero_ = false;
    const std::size_t axis = index(load.axis);
    switch (load.kind) {
    case SpanLoad::Kind::Strain:
        strain_ += factor * load.start;
        curvature_ += factor * load.end;
        return;
    case SpanLoad::Kind::Point:
        if (load.from >= length_) {
            last_jump_[axis] += factor * load.start;
            return;
        }
        for (SpanPiece& piece : pieces_)
            if (piece.begin == std::max(load.from, 0.0)) piece.jump[axis] += factor * load.start;
        return;
    case SpanLoad::Kind::Distributed: break;
    }
    const double slope = load.to > load.from ? (load.end - load.start) / (load.to - load.from) : 0.0;
    for (SpanPiece& piece : pieces_) {
        if (piece.begin < load.from || piece.end > load.to) continue;
        piece.value[axis] += factor * (load.start + slope * (piece.begin - load.from));
        piece.slope[axis] += factor * slope;
    }
}

} // namespace femoop
