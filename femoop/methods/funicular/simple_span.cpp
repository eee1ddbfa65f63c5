#include "femoop/methods/funicular/simple_span.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace femoop::funicular {

namespace {

/// How the loads change at a place.
struct Event {
    double x;
    double P = 0.0; ///< a force there
    double q = 0.0; ///< what joins the distributed load
    double k = 0.0; ///< and its slope
};

std::vector<Event> events_of(const VerticalLoads& loads)
{
    std::vector<Event> events;
    for (const PointForce& force : loads.forces) events.push_back({.x = force.x, .P = force.P});
    for (const Stretch& part : loads.stretches) {
        const double k = (part.end - part.start) / (part.to - part.from);
        events.push_back({.x = part.from, .q = part.start, .k = k});
        events.push_back({.x = part.to, .q = -part.end, .k = -k});
    }
    std::ranges::stable_sort(events, {}, &Event::x);
    return events;
}

} // namespace

SimpleSpan::SimpleSpan(double from, double to, VerticalLoads loads) : from_(from), to_(to), loads_(std::move(loads))
{
    const auto support = [&](double load, double place) {
        right_ += load * (place - from_) / length();
        left_ += load * (to_ - place) / length();
    };
    for (const PointForce& force : loads_.forces) support(force.P, force.x);
    for (const Stretch& part : loads_.stretches) support(part.total(), part.place());
    make_pieces();
    find_largest();
}

// From the left, each piece begun with the moment, shear and load that the one before ends with.
void SimpleSpan::make_pieces()
{
    double x = from_, M = 0.0, V = left_, q = 0.0, k = 0.0;
    const auto go_on_to = [&](double end) {
        if (end <= x) return;
        const double t = end - x;
        pieces_.push_back({x, end, {M, V, -0.5 * q, -k / 6.0}});
        M = pieces_.back().M(t);
        V -= q * t + 0.5 * k * t * t;
        q += k * t;
        x = end;
    };
    for (const Event& event : events_of(loads_)) {
        go_on_to(std::min(event.x, to_));
        V -= event.P;
        q += event.q;
        k += event.k;
    }
    go_on_to(to_);
}

void SimpleSpan::find_largest()
{
    largest_ = {from_, 0.0};
    const auto consider = [&](double x, double M) {
        constexpr double clearly = 1.0 + 1e-12;
        if (std::abs(M) > clearly * std::abs(largest_.value)) largest_ = {x, M};
    };
    for (const Piece& piece : pieces_) {
        for (const double t : piece.M.derivative().roots(piece.to - piece.from)) consider(piece.from + t, piece.M(t));
        if (piece.to < to_) consider(piece.to, piece.M(piece.to - piece.from));
    }
}

double SimpleSpan::moment(double x) const
{
    if (x <= from_ || x >= to_) return 0.0;
    const auto after = std::ranges::upper_bound(pieces_, x, {}, &Piece::from);
    const Piece& piece = *(after - 1);
    return piece.M(x - piece.from);
}

std::vector<double> SimpleSpan::breaks() const
{
    std::vector<double> places{from_};
    for (const Piece& piece : pieces_) places.push_back(piece.to);
    return places;
}

} // namespace femoop::funicular
