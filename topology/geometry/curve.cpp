#include "topology/geometry/curve.h"

#include <numbers>

namespace topology {

namespace {

constexpr double pi = std::numbers::pi;

FlatPoint place(const Segment& s, double t) { return t == 1.0 ? s.b : s.a + t * (s.b - s.a); }
FlatVector velocity(const Segment& s, double /*t*/) { return s.b - s.a; }
FlatVector acceleration(const Segment& /*s*/, double /*t*/) { return {}; }

FlatPoint place(const EllipticArc& arc, double t)
{
    const double w = arc.angle(t);
    return arc.center + (std::cos(w) * arc.p + std::sin(w) * arc.q);
}
FlatVector velocity(const EllipticArc& arc, double t)
{
    const double w = arc.angle(t);
    return arc.sweep * (std::cos(w) * arc.q - std::sin(w) * arc.p);
}
FlatVector acceleration(const EllipticArc& arc, double t)
{
    return -arc.sweep * arc.sweep * (place(arc, t) - arc.center);
}

FlatPoint place(const CubicBezier& c, double t)
{
    const double s = 1.0 - t;
    const auto& [a, b, d, e] = c.points;
    return {s * s * s * a.x + 3.0 * s * t * (s * b.x + t * d.x) + t * t * t * e.x,
            s * s * s * a.y + 3.0 * s * t * (s * b.y + t * d.y) + t * t * t * e.y};
}
FlatVector velocity(const CubicBezier& c, double t)
{
    const double s = 1.0 - t;
    const auto& p = c.points;
    return 3.0 * (s * s * (p[1] - p[0]) + 2.0 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
}
FlatVector acceleration(const CubicBezier& c, double t)
{
    const auto& p = c.points;
    return 6.0 * ((1.0 - t) * ((p[2] - p[1]) - (p[1] - p[0])) + t * ((p[3] - p[2]) - (p[2] - p[1])));
}

/// Roots of a t^2 + b t + c, ascending; none if all terms vanish.
std::vector<double> quadratic_roots(double a, double b, double c)
{
    const double size = std::abs(a) + std::abs(b) + std::abs(c);
    if (std::abs(a) <= 1e-14 * size) {
        if (std::abs(b) <= 1e-14 * size) return {};
        return {-c / b};
    }
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return {};
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b)); // no cancellation
    if (q == 0.0) return {0.0};
    double first = q / a, second = c / q;
    if (first > second) std::swap(first, second);
    return {first, second};
}

/// Parameters where the component of the velocity along `axis` vanishes.
std::vector<double> turns(const CubicBezier& c, const FlatVector& axis)
{
    const auto& p = c.points;
    const double d0 = dot(axis, p[1] - p[0]), d1 = dot(axis, p[2] - p[1]), d2 = dot(axis, p[3] - p[2]);
    return quadratic_roots(d0 - 2.0 * d1 + d2, 2.0 * (d1 - d0), d0);
}
std::vector<double> turns(const EllipticArc& arc, const FlatVector& axis)
{
    const double w = std::atan2(dot(axis, arc.q), dot(axis, arc.p));
    const double low = std::min(arc.start, arc.start + arc.sweep), high = std::max(arc.start, arc.start + arc.sweep);
    std::vector<double> found;
    for (double turn = w + pi * std::ceil((low - w) / pi); turn <= high; turn += pi)
        found.push_back((turn - arc.start) / arc.sweep);
    return found;
}
std::vector<double> turns(const Segment& /*s*/, const FlatVector& /*axis*/) { return {}; }

void keep_inside(std::vector<double>& parameters, Span span)
{
    const double low = std::min(span.from, span.to), high = std::max(span.from, span.to);
    std::erase_if(parameters, [&](double t) { return !(low < t && t < high); });
    std::ranges::sort(parameters);
    if (span.from > span.to) std::ranges::reverse(parameters);
}

/// Gauss's rule of 3 points, exact to degree 5, on -1 to 1.
constexpr std::array<std::array<double, 2>, 3> gauss_3{
    {{-0.7745966692414834, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {0.7745966692414834, 5.0 / 9.0}}};
/// Of 7 points.
constexpr std::array<std::array<double, 2>, 7> gauss_7{{{-0.9491079123427585, 0.1294849661688697},
                                                        {-0.7415311855993945, 0.2797053914892767},
                                                        {-0.4058451513773972, 0.3818300505051189},
                                                        {0.0, 0.4179591836734694},
                                                        {0.4058451513773972, 0.3818300505051189},
                                                        {0.7415311855993945, 0.2797053914892767},
                                                        {0.9491079123427585, 0.1294849661688697}}};

template <std::size_t n, class Function>
double integral(const std::array<std::array<double, 2>, n>& rule, Span span, const Function& f)
{
    const double half = 0.5 * (span.to - span.from);
    double sum = 0.0;
    for (const auto& [at, weight] : rule) sum += weight * f(span.middle() + half * at);
    return half * sum;
}

/// By halves until they add up to the whole, to the tolerance; a cusp is left after so many halvings.
double speed_integral(const Curve& curve, Span span, double tolerance, int n_halvings)
{
    const auto speed = [&](double t) { return length(curve.derivative(t)); };
    const Span first{span.from, span.middle()}, second{span.middle(), span.to};
    const double whole = integral(gauss_7, span, speed);
    const double halves = integral(gauss_7, first, speed) + integral(gauss_7, second, speed);
    if (n_halvings == 0 || std::abs(whole - halves) <= tolerance) return halves;
    return speed_integral(curve, first, tolerance, n_halvings - 1) +
           speed_integral(curve, second, tolerance, n_halvings - 1);
}

double area_of(const Segment& s, Span span, const FlatPoint& origin)
{
    return 0.5 * cross(place(s, span.from) - origin, place(s, span.to) - origin);
}
double area_of(const EllipticArc& arc, Span span, const FlatPoint& origin)
{
    const FlatVector chord = place(arc, span.to) - place(arc, span.from);
    return 0.5 * (cross(arc.center - origin, chord) + cross(arc.p, arc.q) * arc.sweep * (span.to - span.from));
}
double area_of(const CubicBezier& c, Span span, const FlatPoint& origin)
{
    return 0.5 * integral(gauss_3, span, [&](double t) { return cross(place(c, t) - origin, velocity(c, t)); });
}

/// Newton's steps to where the distance to p is least, from a good guess.
double polished(const Curve& curve, const FlatPoint& p, double t, Span within)
{
    const double low = std::min(within.from, within.to), high = std::max(within.from, within.to);
    for (int i = 0; i < 20; ++i) {
        const FlatVector away = curve.at(t) - p, d = curve.derivative(t);
        const double slope = dot(away, d), bend = dot(d, d) + dot(away, curve.second_derivative(t));
        if (!(bend > 0.0)) break;
        const double next = std::clamp(t - slope / bend, low, high);
        if (std::abs(next - t) <= 1e-15) return next;
        t = next;
    }
    return t;
}

} // namespace

bool Curve::is_circular() const
{
    if (arc() == nullptr) return false;
    const double p = topology::length(arc()->p), q = topology::length(arc()->q);
    return std::abs(p - q) <= 1e-12 * p && std::abs(dot(arc()->p, arc()->q)) <= 1e-12 * p * q;
}

FlatPoint Curve::at(double t) const
{
    return std::visit([&](const auto& shape) { return place(shape, t); }, shape_);
}
FlatVector Curve::derivative(double t) const
{
    return std::visit([&](const auto& shape) { return velocity(shape, t); }, shape_);
}
FlatVector Curve::second_derivative(double t) const
{
    return std::visit([&](const auto& shape) { return acceleration(shape, t); }, shape_);
}

double Curve::most_bent(Span span) const
{
    if (const EllipticArc* of = arc())
        return of->sweep * of->sweep * std::max(topology::length(of->p), topology::length(of->q));
    return std::max(topology::length(second_derivative(span.from)), topology::length(second_derivative(span.to)));
}

FlatVector Curve::direction(Span span) const
{
    const FlatVector d = (span.to < span.from ? -1.0 : 1.0) * derivative(span.from);
    const double speed = topology::length(d);
    const FlatVector chord = at(span.at(1e-3)) - at(span.from);
    const double advance = topology::length(chord);
    if (speed * std::abs(span.to - span.from) * 1e-3 > 0.1 * advance && speed > 0.0) return 1.0 / speed * d;
    return 1.0 / advance * chord;
}

FlatBox Curve::box(Span span) const
{
    FlatBox box;
    box.add(at(span.from));
    box.add(at(span.to));
    for (const FlatVector& axis : {FlatVector{1.0, 0.0}, FlatVector{0.0, 1.0}}) {
        std::vector<double> extremes = std::visit([&](const auto& shape) { return turns(shape, axis); }, shape_);
        keep_inside(extremes, span);
        for (const double t : extremes) box.add(at(t));
    }
    return box;
}

double Curve::length(Span span) const
{
    const double share = std::abs(span.to - span.from);
    if (const Segment* s = segment()) return share * distance(s->a, s->b);
    if (is_circular()) return share * std::abs(arc()->sweep) * topology::length(arc()->p);
    constexpr int most_halvings = 30;
    const double about = integral(gauss_7, span, [&](double t) { return topology::length(derivative(t)); });
    return std::abs(speed_integral(*this, span, 1e-13 * std::abs(about), most_halvings));
}

double Curve::at_share(Span span, double share) const
{
    if (is_straight() || is_circular() || share <= 0.0 || share >= 1.0) return span.at(std::clamp(share, 0.0, 1.0));
    const double whole = length(span);
    double t = span.at(share);
    Span bracket = span;
    constexpr int most_steps = 60;
    for (int i = 0; i < most_steps; ++i) { // Newton's method, kept between places that are too near and too far
        const double off = length({span.from, t}) - share * whole;
        if (std::abs(off) <= 1e-12 * whole) break;
        (off > 0.0 ? bracket.to : bracket.from) = t;
        const double speed = topology::length(derivative(t));
        const double next = speed > 0.0 ? t - std::copysign(off / speed, off * (span.to - span.from)) : span.from;
        const bool is_between = (next - bracket.from) * (bracket.to - next) > 0.0;
        t = is_between ? next : bracket.middle();
    }
    return t;
}

double Curve::turning(Span span) const
{
    if (is_straight()) return 0.0;
    constexpr int n_parts = 32;
    double turned = 0.0;
    FlatVector before = direction(span);
    for (int i = 1; i <= n_parts; ++i) {
        const double t = span.at(static_cast<double>(i) / n_parts);
        const FlatVector now = -direction({t, span.from});
        turned += std::abs(std::atan2(cross(before, now), dot(before, now)));
        before = now;
    }
    return turned;
}

double Curve::area(Span span, const FlatPoint& origin) const
{
    return std::visit([&](const auto& shape) { return area_of(shape, span, origin); }, shape_);
}

double Curve::nearest(const FlatPoint& p, Span span) const
{
    const double low = std::min(span.from, span.to), high = std::max(span.from, span.to);
    if (const Segment* s = segment()) {
        const FlatVector along = s->b - s->a;
        const double square = dot(along, along);
        return square > 0.0 ? std::clamp(dot(p - s->a, along) / square, low, high) : low;
    }
    constexpr int n_guesses = 16;
    const double step = (high - low) / n_guesses;
    std::array<double, n_guesses + 1> away{};
    for (int i = 0; i <= n_guesses; ++i) away[static_cast<std::size_t>(i)] = distance(at(low + i * step), p);
    double best = low, least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < away.size(); ++i) { // from every guess that is nearer than its neighbours
        if ((i > 0 && away[i - 1] < away[i]) || (i + 1 < away.size() && away[i + 1] < away[i])) continue;
        const double guess = low + static_cast<double>(i) * step;
        const double t = polished(*this, p, guess, {std::max(low, guess - step), std::min(high, guess + step)});
        for (const double each : {guess, t})
            if (const double d = distance(at(each), p); d < least) {
                least = d;
                best = each;
            }
    }
    return best;
}

std::vector<double> Curve::turns_of_y(Span span) const
{
    if (is_straight()) return {};
    std::vector<double> found = std::visit([](const auto& shape) { return turns(shape, {0.0, 1.0}); }, shape_);
    keep_inside(found, span);
    return found;
}

double Curve::at_height(double y, Span monotone) const
{
    double low = monotone.from, high = monotone.to;
    const bool is_rising = at(high).y > at(low).y;
    double t = 0.5 * (low + high);
    for (int i = 0; i < 200 && low != high; ++i) {
        const double off = at(t).y - y;
        if (off == 0.0) return t;
        (off > 0.0) == is_rising ? high = t : low = t;
        const double slope = derivative(t).y, newton = t - off / slope;
        const bool is_inside = std::isfinite(newton) && (newton - low) * (newton - high) < 0.0;
        const double next = is_inside ? newton : 0.5 * (low + high);
        if (next == t || std::abs(next - t) < 1e-16) return next;
        t = next;
    }
    return t;
}

std::vector<double> Curve::self_crossing() const
{
    const CubicBezier* c = cubic();
    if (c == nullptr) return {};
    // with r(t) = a t^3 + b t^2 + c t + d and r(t) = r(s): a (t^2 + t s + s^2) + b (t + s) + c = 0
    const auto& p = c->points;
    const FlatVector c1 = 3.0 * (p[1] - p[0]), b = 3.0 * ((p[2] - p[1]) - (p[1] - p[0]));
    const FlatVector a = (p[3] - p[0]) - 3.0 * (p[2] - p[1]);
    const double across = cross(b, a), square = dot(a, a);
    const double size = dot(b, b) + square + dot(c1, c1);
    if (std::abs(across) <= 1e-12 * size || square <= 1e-24 * size) return {};
    const double sum = -cross(c1, a) / across;
    const double product = sum * sum + dot(sum * b + c1, a) / square;
    const double discriminant = sum * sum - 4.0 * product;
    if (!(discriminant > 1e-18)) return {};
    const double half = 0.5 * std::sqrt(discriminant);
    const double low = 0.5 * sum - half, high = 0.5 * sum + half;
    if (low < 0.0 || high > 1.0) return {};
    return {low, high};
}

} // namespace topology
