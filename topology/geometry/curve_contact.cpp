#include "topology/geometry/curve_contact.h"

#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

namespace topology {

namespace {

using Places = std::vector<CurveContact>;

constexpr double two_pi = 6.283185307179586;
constexpr double end_slack = 1e-9; // of a parameter: a crossing at an end is one

bool is_within(double t) { return -end_slack <= t && t <= 1.0 + end_slack; }
double clamped(double t) { return std::clamp(t, 0.0, 1.0); }

bool precedes(const FlatPoint& a, const FlatPoint& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }
Segment ordered(const Segment& s) { return precedes(s.b, s.a) ? Segment{s.b, s.a} : s; }
bool precedes(const Segment& a, const Segment& b)
{
    return std::tie(a.a.x, a.a.y, a.b.x, a.b.y) < std::tie(b.a.x, b.a.y, b.b.x, b.b.y);
}

/// The crossing of two lines that are not parallel, the same whichever comes first.
FlatPoint crossing(Segment a, Segment b)
{
    a = ordered(a);
    b = ordered(b);
    if (precedes(b, a)) std::swap(a, b);
    const FlatVector d = a.b - a.a, e = b.b - b.a;
    return a.a + cross(b.a - a.a, e) / cross(d, e) * d;
}

bool is_along(const Segment& a, const Segment& b, double snap)
{
    const FlatVector d = a.b - a.a;
    const double reach = snap * length(d);
    return std::abs(cross(d, b.a - a.a)) <= reach && std::abs(cross(d, b.b - a.a)) <= reach;
}

Places contacts_of(const Segment& a, const Segment& b, double snap)
{
    const FlatVector d = a.b - a.a, e = b.b - b.a;
    const double denominator = cross(d, e);
    if (denominator == 0.0 || is_along(a, b, snap) || is_along(b, a, snap)) return {};
    const double t = cross(b.a - a.a, e) / denominator, u = cross(b.a - a.a, d) / denominator;
    if (!is_within(t) || !is_within(u)) return {};
    return {{clamped(t), clamped(u), crossing(a, b)}};
}

/// The parameter of an angle on an arc, or one just beyond its ends; nothing elsewhere.
double parameter(const EllipticArc& arc, double angle)
{
    double turn = std::remainder(angle - arc.start, two_pi); // -pi to pi
    if (arc.sweep > 0.0 && turn < -end_slack) turn += two_pi;
    if (arc.sweep < 0.0 && turn > end_slack) turn -= two_pi;
    return turn / arc.sweep;
}

/// cos(w) n.p + sin(w) n.q = n.(a - center): two angles, or the one where the line touches.
Places contacts_of(const Curve& line, const Curve& curve, const EllipticArc& arc, double snap)
{
    const Segment s = ordered(*line.segment());
    const FlatVector d = s.b - s.a;
    const FlatVector n = 1.0 / length(d) * FlatVector{-d.y, d.x};
    const double x = dot(n, arc.p), y = dot(n, arc.q), reach = std::hypot(x, y), k = dot(n, s.a - arc.center);
    if (std::abs(k) > reach + snap) return {};
    const double middle_angle = std::atan2(y, x);
    const bool touches = std::abs(std::abs(k) - reach) <= snap;
    const double half = touches ? (k > 0.0 ? 0.0 : 0.5 * two_pi) : std::acos(k / reach);
    Places places;
    const auto see = [&](double angle) {
        const double u = parameter(arc, angle);
        const double t = line.nearest(curve.at(clamped(u)));
        const FlatPoint on_arc = arc.center + (std::cos(angle) * arc.p + std::sin(angle) * arc.q);
        const FlatVector along = line.segment()->b - line.segment()->a;
        const double t_free = dot(on_arc - line.segment()->a, along) / dot(along, along);
        if (is_within(u) && is_within(t_free)) places.push_back({t, clamped(u), on_arc});
    };
    see(middle_angle + half);
    if (!touches) see(middle_angle - half);
    return places;
}

bool is_one_circle(const EllipticArc& a, const EllipticArc& b, double snap)
{
    return distance(a.center, b.center) <= snap && std::abs(length(a.p) - length(b.p)) <= snap;
}

double angle_of(const EllipticArc& circle, const FlatVector& direction)
{
    return std::atan2(dot(direction, circle.q), dot(direction, circle.p));
}

/// Two circles: along the line of their centres, and square to it.
Places contacts_of_circles(const Curve& a, const Curve& b, double snap)
{
    const bool is_swapped = precedes(b.arc()->center, a.arc()->center);
    const Curve &first = is_swapped ? b : a, &second = is_swapped ? a : b;
    const EllipticArc &c = *first.arc(), &e = *second.arc();
    const FlatVector between = e.center - c.center;
    const double d = length(between), r = length(c.p), s = length(e.p);
    if (is_one_circle(c, e, snap) || d > r + s + snap || d < std::abs(r - s) - snap || d == 0.0) return {};
    const FlatVector n = 1.0 / d * between;
    const bool touches = std::abs(d - (r + s)) <= snap || std::abs(d - std::abs(r - s)) <= snap;
    const double side = touches && d < std::max(r, s) && r < s ? -1.0 : 1.0; // the smaller one lies inside
    const double along = touches ? side * r : (d * d + r * r - s * s) / (2.0 * d);
    const double off = touches ? 0.0 : std::sqrt(std::max(r * r - along * along, 0.0));
    Places places;
    const auto see = [&](double across) {
        const FlatPoint at = c.center + (along * n + across * FlatVector{-n.y, n.x});
        double t = parameter(c, angle_of(c, at - c.center)), u = parameter(e, angle_of(e, at - e.center));
        if (!is_within(t) || !is_within(u)) return;
        if (is_swapped) std::swap(t, u);
        places.push_back({clamped(t), clamped(u), at});
    };
    see(off);
    if (!touches) see(-off);
    return places;
}

/// Two curves of any kind, by halves.
class ContactSearch {
public:
    ContactSearch(const Curve& a, const Curve& b, double snap) : a_(a), b_(b), snap_(snap) {}

    CurveContacts run()
    {
        look({}, {}, 0);
        if (meetings_.size() > most_meetings || !join()) return {{}, true};
        return {std::move(places_), false};
    }

private:
    /// A crossing, or where two short pieces that are as good as straight come close.
    struct Meeting {
        double t, u, gap;
        bool is_crossing = false;
    };
    static constexpr int most_halvings = 48;
    static constexpr std::size_t most_meetings = 4000; // of a touching there are some tens

    /// How far a piece may bulge from its chord, from above.
    static double bulge(const Curve& curve, Span span)
    {
        const double h = span.to - span.from;
        return 0.125 * h * h * curve.most_bent(span);
    }

    void look(Span ta, Span tb, int depth)
    {
        if (meetings_.size() > most_meetings) return;
        const FlatPoint a0 = a_.at(ta.from), a1 = a_.at(ta.to), b0 = b_.at(tb.from), b1 = b_.at(tb.to);
        const double bulge_a = bulge(a_, ta), bulge_b = bulge(b_, tb);
        if (apart(a0, a1, b0, b1, 1.25 * (bulge_a + bulge_b) + snap_)) return;
        const double length_a = distance(a0, a1), length_b = distance(b0, b1);
        const bool are_straight = bulge_a <= 0.02 * length_a && bulge_b <= 0.02 * length_b;
        if (are_straight && cross_at_an_angle(a0, a1, b0, b1, bulge_a, bulge_b)) return newton(ta, tb);
        if (depth >= most_halvings ||
            (bulge_a <= 0.1 * snap_ && bulge_b <= 0.1 * snap_ && std::max(length_a, length_b) <= longest_close())) {
            see_close(ta, tb, {a0, a1}, {b0, b1});
            return;
        }
        const bool halves_a = length_a + bulge_a >= length_b + bulge_b;
        const Span first{halves_a ? Span{ta.from, ta.middle()} : Span{tb.from, tb.middle()}};
        const Span second{halves_a ? Span{ta.middle(), ta.to} : Span{tb.middle(), tb.to}};
        look(halves_a ? first : ta, halves_a ? tb : first, depth + 1);
        look(halves_a ? second : ta, halves_a ? tb : second, depth + 1);
    }

    double longest_close() const { return std::max(1e-4 * size(), 10.0 * snap_); }
    double size() const { return std::min(a_.box({}).diagonal(), b_.box({}).diagonal()); }

    /// Whether one lies wholly on one side of the other's chord, farther than reach, or beyond its ends.
    static bool apart(const FlatPoint& a0, const FlatPoint& a1, const FlatPoint& b0, const FlatPoint& b1, double reach)
    {
        FlatBox a, b;
        a.add(a0);
        a.add(a1);
        b.add(b0);
        b.add(b1);
        return !a.grown(reach).meets(b) || is_beside(a0, a1, b0, b1, reach) || is_beside(b0, b1, a0, a1, reach);
    }
    static bool is_beside(const FlatPoint& a0, const FlatPoint& a1, const FlatPoint& b0, const FlatPoint& b1,
                          double reach)
    {
        const FlatVector d = a1 - a0;
        const double size = length(d);
        if (size == 0.0) return false;
        const double low = std::min(cross(d, b0 - a0), cross(d, b1 - a0));
        const double high = std::max(cross(d, b0 - a0), cross(d, b1 - a0));
        return low > reach * size || high < -reach * size;
    }

    /// The chords' directions differ by more than the curves turn along them.
    static bool cross_at_an_angle(const FlatPoint& a0, const FlatPoint& a1, const FlatPoint& b0, const FlatPoint& b1,
                                  double bulge_a, double bulge_b)
    {
        const FlatVector d = a1 - a0, e = b1 - b0;
        const double la = length(d), lb = length(e);
        if (la == 0.0 || lb == 0.0) return false;
        const double turn_of_both = 8.0 * (bulge_a / la + bulge_b / lb);
        return std::abs(cross(d, e)) > (2.0 * turn_of_both + 1e-9) * la * lb;
    }

    void newton(Span ta, Span tb)
    {
        double t = ta.middle(), u = tb.middle();
        for (int i = 0; i < 30; ++i) {
            const FlatVector gap = b_.at(u) - a_.at(t), d = a_.derivative(t), e = b_.derivative(u);
            const double det = cross(d, e);
            if (det == 0.0) break;
            const double dt = cross(gap, e) / det, du = cross(gap, d) / det;
            t += dt;
            u += du;
            if (std::abs(dt) + std::abs(du) < 1e-15) break;
        }
        const auto is_in = [](double at, Span span) {
            const double slack = 1e-6 * (span.to - span.from) + end_slack;
            return span.from - slack <= at && at <= span.to + slack;
        };
        if (is_in(t, ta) && is_in(u, tb)) keep(t, u);
    }

    void keep(double t, double u)
    {
        t = clamped(t);
        u = clamped(u);
        if (distance(a_.at(t), b_.at(u)) > snap_) return; // beyond an end, which is a contact if it is near enough
        for (const Meeting& known : meetings_)
            if (known.is_crossing && std::abs(known.t - t) < 1e-12) return;
        meetings_.push_back({t, u, 0.0, true});
    }

    void see_close(Span ta, Span tb, const Segment& a, const Segment& b)
    {
        Meeting best{ta.middle(), tb.middle(), std::numeric_limits<double>::infinity()};
        const auto see = [&](double t, double u) {
            if (const double gap = distance(a_.at(t), b_.at(u)); gap < best.gap) best = {t, u, gap};
        };
        const Curve chord_a(a), chord_b(b);
        for (const double s : {0.0, 1.0}) {
            see(ta.at(s), tb.at(chord_b.nearest(s == 0.0 ? a.a : a.b)));
            see(ta.at(chord_a.nearest(s == 0.0 ? b.a : b.b)), tb.at(s));
        }
        if (best.gap <= snap_) meetings_.push_back(best);
    }

    /// Meetings between which the curves stay closer than snap are one contact: a crossing if the curves change sides,
    /// else a touching, where the gap is least. Not if they are close along a stretch.
    bool join()
    {
        const double longest_touch = std::max(0.02 * size(), 8.0 * std::sqrt(snap_ * size()));
        std::ranges::sort(meetings_, {}, &Meeting::t);
        for (std::size_t i = 0; i < meetings_.size();) {
            std::size_t j = i + 1;
            while (j < meetings_.size() && stay_close(meetings_[j - 1], meetings_[j])) ++j;
            if (a_.length({meetings_[i].t, meetings_[j - 1].t}) > longest_touch) return false;
            add_contact(std::span<const Meeting>(meetings_).subspan(i, j - i));
            i = j;
        }
        return true;
    }

    /// The parameter of b that is nearest to a place of a, near a guess.
    double across(double t, double guess) const { return b_.nearest(a_.at(t), around(guess)); }
    static Span around(double guess)
    {
        constexpr double reach = 0.02;
        return {std::max(0.0, guess - reach), std::min(1.0, guess + reach)};
    }
    double gap_at(double t, double guess) const { return distance(a_.at(t), b_.at(across(t, guess))); }
    bool stay_close(const Meeting& first, const Meeting& second) const
    {
        if (std::abs(first.u - second.u) > 0.05) return false;
        const Span t{first.t, second.t}, u{first.u, second.u};
        return std::ranges::all_of(std::array{0.25, 0.5, 0.75},
                                   [&](double share) { return gap_at(t.at(share), u.at(share)) <= snap_; });
    }

    /// On which side of b the curve a is, outward from a meeting where they are no longer close; 0 where one ends first.
    int side_beyond(const Meeting& from, double direction) const
    {
        double step = 1e-7, u = from.u;
        for (double t = from.t; step < 1.0; step *= 1.5) {
            t += direction * step;
            if (t <= 0.0 || t >= 1.0) return 0;
            u = across(t, u);
            const FlatVector off = a_.at(t) - b_.at(u);
            if (u <= 0.0 || u >= 1.0) return 0;
            if (length(off) > 2.0 * snap_) return cross(b_.derivative(u), off) > 0.0 ? 1 : -1;
        }
        return 0;
    }

    /// An end of one of the curves that lies on the other, in place of a meeting from which they stay close up to it.
    Meeting drawn_to_end(const Meeting& meeting) const
    {
        std::vector<Meeting> ends;
        for (const double end : {0.0, 1.0}) {
            ends.push_back({end, across(end, meeting.u), 0.0});
            const double t = a_.nearest(b_.at(end), around(meeting.t));
            ends.push_back({t, end, 0.0});
        }
        for (const Meeting& end : ends) {
            if (distance(a_.at(end.t), b_.at(end.u)) > snap_) continue;
            const bool are_straight = distance(a_.at(meeting.t), a_.at(end.t)) <=
                                      4.0 * snap_; // close between two closes
            if (are_straight || stay_close(meeting, end)) return end;
        }
        return meeting;
    }

    void add_contact(std::span<const Meeting> together)
    {
        const auto crossing = std::ranges::find_if(together, &Meeting::is_crossing);
        const bool is_alone = together.size() == 1 && crossing != together.end();
        const Meeting least = *std::ranges::min_element(together, {}, &Meeting::gap);
        const int before = is_alone ? -1 : side_beyond(together.front(), -1.0);
        const int after = is_alone ? 1 : side_beyond(together.back(), 1.0);
        const bool changes_sides = before * after < 0;
        const Meeting chosen = drawn_to_end(changes_sides && crossing != together.end() ? *crossing : least);
        places_.push_back({chosen.t, chosen.u, middle(a_.at(chosen.t), b_.at(chosen.u))});
    }

    const Curve &a_, &b_;
    double snap_;
    std::vector<Meeting> meetings_;
    Places places_;
};

/// Where the same pair always has its first one first.
bool is_in_order(const Curve& a, const Curve& b)
{
    const FlatPoint p = a.at(0.0), q = a.at(1.0), r = b.at(0.0), s = b.at(1.0);
    return std::tie(p.x, p.y, q.x, q.y) <= std::tie(r.x, r.y, s.x, s.y);
}

CurveContacts any_contacts(const Curve& a, const Curve& b, double snap)
{
    if (is_in_order(a, b)) return ContactSearch(a, b, snap).run();
    CurveContacts found = ContactSearch(b, a, snap).run();
    for (CurveContact& contact : found.places) std::swap(contact.t, contact.u);
    return found;
}

CurveContacts unordered_contacts(const Curve& a, const Curve& b, double snap)
{
    if (a.is_straight() && b.is_straight()) return {contacts_of(*a.segment(), *b.segment(), snap)};
    if (a.is_straight() && b.arc() != nullptr) return {contacts_of(a, b, *b.arc(), snap)};
    if (b.is_straight() && a.arc() != nullptr) {
        Places places = contacts_of(b, a, *a.arc(), snap);
        for (CurveContact& contact : places) std::swap(contact.t, contact.u);
        return {std::move(places)};
    }
    if (a.is_circular() && b.is_circular()) return {contacts_of_circles(a, b, snap)};
    return any_contacts(a, b, snap);
}

} // namespace

CurveContacts contacts(const Curve& a, const Curve& b, double snap)
{
    CurveContacts found = unordered_contacts(a, b, snap);
    std::erase_if(found.places, [&](const CurveContact& contact) { // beyond an end by rounding, and too far
        return distance(a.at(contact.t), contact.at) > snap || distance(b.at(contact.u), contact.at) > snap;
    });
    std::ranges::sort(found.places, {}, &CurveContact::t);
    return found;
}

} // namespace topology
