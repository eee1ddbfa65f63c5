#include "femoop/methods/funicular/funicular.h"

#include <algorithm>
#include <cmath>

namespace femoop::funicular {

namespace {

constexpr double nothing = 1e-9; // of the span, or of the largest moment

bool passes(const Funicular& funicular, const Eigen::Vector2d& place, const Chain& chain)
{
    return std::abs(funicular.height(place.x()) - place.y()) <= nothing * chain.span();
}

} // namespace

double Funicular::closing(double x) const
{
    return std::lerp(closing_line.left, closing_line.right, (x - span.from()) / span.length());
}

double thrust_of_rise(const SimpleSpan& span, double rise) { return span.largest_moment().value / rise; }

std::optional<double> thrust_through(const SimpleSpan& span, const ClosingLine& line, const Eigen::Vector2d& point)
{
    const Funicular any{span, line};
    const double f = point.y() - any.closing(point.x()), M = span.moment(point.x());
    const bool is_nothing = std::abs(f) <= nothing * span.length() ||
                            std::abs(M) <= nothing * std::abs(span.largest_moment().value);
    return is_nothing ? std::nullopt : std::optional(M / f);
}

double usual_thrust(const Chain& chain, const SimpleSpan& span)
{
    constexpr double usual_share = 0.2;
    const std::optional<Eigen::Vector2d> crown = chain.crown();
    const auto H = crown ? thrust_through(span, {chain.left().y(), chain.right().y()}, *crown) : std::nullopt;
    return H.value_or(std::abs(span.largest_moment().value) / (usual_share * span.length()));
}

GivenRise given_rise(const Funicular& funicular, const Chain& chain)
{
    using Place = GivenRise::Place;
    const Extreme& most = funicular.span.largest_moment();
    const auto at = [&](Place place, double x) {
        return GivenRise{place, x, funicular.span.moment(x), funicular.ordinate(x)};
    };
    const auto has_moment = [&](double x) {
        return std::abs(funicular.span.moment(x)) > nothing * std::abs(most.value);
    };
    if (chain.hinge && has_moment(chain.hinge->x()) && passes(funicular, *chain.hinge, chain))
        return at(Place::Hinge, chain.hinge->x());
    if (funicular.led_through) return at(Place::Point, *funicular.led_through);
    const std::optional<Eigen::Vector2d> crown = chain.crown();
    const bool is_over_crown = crown && has_moment(crown->x()) && passes(funicular, *crown, chain);
    return is_over_crown ? at(Place::Point, crown->x()) : at(Place::LargestMoment, most.x);
}

bool is_line_of_thrust(const Funicular& funicular, const Chain& chain)
{
    const auto is_on = [&](const Eigen::Vector2d& place) { return passes(funicular, place, chain); };
    return chain.is_three_hinged_arch && is_on(chain.left()) && is_on(chain.right()) && is_on(*chain.hinge);
}

ForcePolygon force_polygon(const Funicular& funicular)
{
    ForcePolygon polygon;
    for (const PointForce& force : funicular.span.loads().forces) polygon.loads.push_back({force.x, force.P});
    for (const Stretch& part : funicular.span.loads().stretches) polygon.loads.push_back({part.place(), part.total()});
    std::ranges::stable_sort(polygon.loads, {}, &ForcePolygon::Load::x);
    polygon.levels = {0.0};
    for (const ForcePolygon::Load& load : polygon.loads) polygon.levels.push_back(polygon.levels.back() - load.P);
    const ClosingLine& line = funicular.closing_line;
    const double slope = (line.right - line.left) / funicular.span.length();
    polygon.closing_level = -funicular.span.left_reaction();
    polygon.pole = {-funicular.H, polygon.closing_level - funicular.H * slope};
    return polygon;
}

std::vector<Eigen::Vector2d> ForcePolygon::corners(const Funicular& funicular) const
{
    std::vector<Eigen::Vector2d> found{{funicular.span.from(), funicular.closing_line.left}};
    const auto go_on_to = [&](double x, double level) {
        const double slope = (pole.y() - level) / pole.x();
        found.emplace_back(x, found.back().y() + slope * (x - found.back().x()));
    };
    for (std::size_t i = 0; i < loads.size(); ++i) go_on_to(loads[i].x, levels[i]);
    go_on_to(funicular.span.to(), levels.back());
    return found;
}

} // namespace femoop::funicular
