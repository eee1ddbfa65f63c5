#include "femoop/methods/influence/train/position_function.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <utility>

#include "femoop/methods/influence/piecewise_line.h"
#include "femoop/methods/influence/polynomial_terms.h"

namespace femoop::influence {

namespace {

using Trial = PositionFunction::Candidate;
using Piece = PositionFunction::Piece;

Polynomial constant(double value) { return {value}; }

/// A sum of polynomials, each about a place of its own, and times a factor.
class PolynomialSum {
public:
    /// factor * p(t + by)
    void add(const Polynomial& p, double by, double factor)
    {
        if (p.n_terms() > n_usual) return add(p.shifted(by), factor);
        std::array<double, n_usual> c{}; // most lines are cubics: a polynomial of its own would take longer to copy
        for (std::size_t i = 0; i < p.n_terms(); ++i) c[i] = p[i];
        shift_coefficients(std::span(c).first(p.n_terms()), by);
        for (; n_ < p.n_terms(); ++n_) sum_[n_] = 0.0;
        for (std::size_t i = 0; i < p.n_terms(); ++i) sum_[i] += factor * c[i];
    }
    void add(double value, double factor)
    {
        if (n_ == 0) sum_[n_++] = 0.0;
        sum_[0] += factor * value;
    }
    Polynomial polynomial() const
    {
        Polynomial p;
        for (std::size_t k = 0; k < n_; ++k) p.append(sum_[k]);
        return p;
    }

private:
    void add(const Polynomial& p, double factor)
    {
        for (; n_ < p.n_terms(); ++n_) sum_[n_] = 0.0;
        for (std::size_t i = 0; i < p.n_terms(); ++i) sum_[i] += factor * p[i];
    }

    static constexpr std::size_t n_usual = 4;
    std::array<double, Polynomial::max_terms> sum_; // only the first n_ mean anything
    std::size_t n_ = 0;
};

/// Walks over a function from left to right and hands out its polynomial about any place.
class Walker {
public:
    explicit Walker(const PositionFunction& of) : of_(of) {}

    /// In t = x - start, on the stretch around `middle`, which never goes back.
    Polynomial polynomial_about(double start, double middle)
    {
        if (const Piece* piece = piece_at(middle)) return piece->value.shifted(start - piece->from);
        return constant(is_before_ ? of_.before() : of_.after());
    }
    /// Adds the same to a sum.
    void add_about(double start, double middle, double factor, PolynomialSum& sum)
    {
        if (const Piece* piece = piece_at(middle)) sum.add(piece->value, start - piece->from, factor);
        else sum.add(is_before_ ? of_.before() : of_.after(), factor);
    }
    /// Whose polynomial was handed out last: a piece from 1, 0 before the first, one more behind the last.
    std::size_t piece() const { return next_ == 0 && is_before_ ? 0 : next_ + 1; }

private:
    /// Null before the first one and behind the last.
    const Piece* piece_at(double middle)
    {
        const std::vector<Piece>& pieces = of_.pieces();
        while (next_ < pieces.size() && pieces[next_].to < middle) ++next_;
        is_before_ = next_ == 0 && !pieces.empty() && middle < pieces.front().from;
        return next_ == pieces.size() || is_before_ ? nullptr : &pieces[next_];
    }

    const PositionFunction& of_;
    std::size_t next_ = 0;
    bool is_before_ = false;
};

void add_breaks(std::vector<double>& breaks, const PositionFunction& of, double shift)
{
    for (const Piece& piece : of.pieces()) breaks.push_back(piece.from + shift);
    if (!of.pieces().empty()) breaks.push_back(of.pieces().back().to + shift);
}

/// Roots of the quadratic a + b t + c t^2 within (0, end), ascending, each handed to `keep`.
template <class Keep> void visit_quadratic_roots(double a, double b, double c, double end, const Keep& keep)
{
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    std::array<double, 2> roots{};
    std::size_t n = 0;
    if (q != 0.0) roots[n++] = a / q;
    if (c != 0.0) roots[n++] = q / c;
    if (n == 2 && roots[1] < roots[0]) std::swap(roots[0], roots[1]);
    for (std::size_t i = 0; i < n; ++i)
        if (roots[i] > 0.0 && roots[i] < end) keep(roots[i]);
}

/// As `stationary_places`, one by one: most pieces have none, and no list is made of them.
template <class Keep> void visit_stationary_places(const Polynomial& p, double end, const Keep& keep)
{
    if (p.n_terms() < 3) return;
    if (p.n_terms() <= 4) return visit_quadratic_roots(p[1], 2.0 * p[2], 3.0 * p[3], end, keep);
    for (const double root : p.derivative().roots(end))
        if (root > 0.0 && root < end) keep(root);
}

/// Its first coefficient outweighs all the others up to the end; most stretches are too short for a zero.
bool keeps_sign(const Polynomial& p, double end)
{
    double others = 0.0;
    for (std::size_t k = p.n_terms(); k-- > 1;) others = end * (others + std::abs(p[k]));
    return std::abs(p[0]) > others;
}

/// Where the two are equal within (0, end).
void add_crossings(std::vector<double>& places, const Polynomial& p, const Polynomial& q, double end)
{
    Polynomial difference;
    for (std::size_t i = 0; i < std::max(p.n_terms(), q.n_terms()); ++i) difference.append(p[i] - q[i]);
    if (keeps_sign(difference, end)) return;
    for (const double root : difference.roots(end)) places.push_back(root);
}

/// What may be largest in a moving window.
struct Branch {
    enum class Of : std::uint8_t { NearEnd, FarEnd, Within };
    Of of = Of::Within;
    std::size_t piece = 0; ///< of the function, at an end of the window
    Polynomial value;

    /// Goes on as one polynomial where the other ends.
    bool continues(const Branch& other) const
    {
        return of == other.of && (of == Of::Within ? value[0] == other.value[0] : piece == other.piece);
    }
};

/// The upper envelope of branches, put together from left to right. A piece ends only where another branch or another
/// polynomial is the largest, so that what a chain of windows looks at grows with their number, not by powers of it.
class UpperEnvelope {
public:
    explicit UpperEnvelope(double shortest) : shortest_(shortest) {}

    void append(const std::vector<Branch>& branches, double from, double to)
    {
        std::vector<double> cuts{0.0, to - from};
        for (std::size_t i = 0; i < branches.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) add_crossings(cuts, branches[i].value, branches[j].value, to - from);
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i + 1] - cuts[i] <= shortest_) continue;
            const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
            const auto best = std::max_element(branches.begin(), branches.end(), [&](const auto& p, const auto& q) {
                return p.value(middle) < q.value(middle);
            });
            add(*best, cuts[i], {from + cuts[i], from + cuts[i + 1], {}});
        }
    }

    std::vector<Piece> pieces() { return std::move(pieces_); }

private:
    void add(const Branch& branch, double within, Piece piece)
    {
        const bool goes_on = !pieces_.empty() && branch.continues(last_) && piece.from - pieces_.back().to <= shortest_;
        last_ = branch;
        if (goes_on) {
            pieces_.back().to = piece.to;
            return;
        }
        piece.value = branch.value.shifted(within);
        pieces_.push_back(std::move(piece));
    }

    double shortest_;
    std::vector<Piece> pieces_;
    Branch last_;
};

/// Of candidates in ascending order, the largest value within a window that moves on: those that a later and larger one
/// outlives are let go.
class WindowMaximum {
public:
    explicit WindowMaximum(const std::vector<Trial>& candidates) : candidates_(candidates) {}

    /// \pre neither end goes back
    double between(double from, double to)
    {
        for (; next_ < candidates_.size() && candidates_[next_].x <= to; ++next_) {
            while (!alive_.empty() && alive_.back()->value <= candidates_[next_].value) alive_.pop_back();
            alive_.push_back(&candidates_[next_]);
        }
        while (!alive_.empty() && alive_.front()->x < from) alive_.pop_front();
        return alive_.empty() ? -std::numeric_limits<double>::infinity() : alive_.front()->value;
    }

private:
    const std::vector<Trial>& candidates_;
    std::size_t next_ = 0;
    std::deque<const Trial*> alive_; ///< ascending, their values descending
};

} // namespace

std::vector<double> stationary_places(const Polynomial& p, double end)
{
    std::vector<double> places;
    visit_stationary_places(p, end, [&](double t) { places.push_back(t); });
    return places;
}

PositionFunction::PositionFunction(const PiecewiseLine& line)
{
    pieces_.reserve(line.pieces.size());
    for (const LinePiece& piece : line.pieces)
        if (piece.to > piece.from) pieces_.push_back({piece.from, piece.to, polynomial_of(piece.coefficients)});
}

PositionFunction::PositionFunction(std::vector<Piece> pieces, double before, double after)
    : pieces_(std::move(pieces)), before_(before), after_(after)
{}

PositionFunction PositionFunction::sum(const std::vector<Term>& terms, double shortest)
{
    std::vector<double> breaks;
    std::vector<Walker> walkers;
    PositionFunction sum;
    std::size_t n_breaks = 0;
    for (const Term& term : terms) n_breaks += term.of->pieces().size() + 1;
    breaks.reserve(n_breaks);
    walkers.reserve(terms.size());
    sum.pieces_.reserve(n_breaks);
    for (const Term& term : terms) {
        add_breaks(breaks, *term.of, term.shift);
        walkers.emplace_back(*term.of);
        sum.before_ += term.factor * term.of->before_;
        sum.after_ += term.factor * term.of->after_;
    }
    std::sort(breaks.begin(), breaks.end());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double from = breaks[i], to = breaks[i + 1], middle = 0.5 * (from + to);
        if (to - from <= shortest) continue;
        PolynomialSum here;
        for (std::size_t k = 0; k < terms.size(); ++k)
            walkers[k].add_about(from - terms[k].shift, middle - terms[k].shift, terms[k].factor, here);
        sum.pieces_.push_back({from, to, here.polynomial()});
    }
    return sum;
}

PositionFunction PositionFunction::mirrored(double length) const
{
    PositionFunction mirror({}, after_, before_);
    mirror.pieces_.reserve(pieces_.size());
    for (std::size_t i = pieces_.size(); i-- > 0;) {
        const Piece& piece = pieces_[i];
        const Polynomial about_end = piece.value.shifted(piece.to - piece.from);
        Piece& turned = mirror.pieces_.emplace_back(Piece{length - piece.to, length - piece.from, {}});
        for (std::size_t k = 0; k < about_end.n_terms(); ++k)
            turned.value.append(k % 2 == 0 ? about_end[k] : -about_end[k]);
    }
    return mirror;
}

PositionFunction PositionFunction::negated() const
{
    PositionFunction negative({}, -before_, -after_);
    negative.pieces_.reserve(pieces_.size());
    for (const Piece& piece : pieces_)
        negative.pieces_.push_back({piece.from, piece.to, influence::negated(piece.value)});
    return negative;
}

PositionFunction PositionFunction::integral() const
{
    PositionFunction integral;
    integral.pieces_.reserve(pieces_.size());
    double so_far = 0.0;
    for (const Piece& piece : pieces_) {
        Piece& sum = integral.pieces_.emplace_back(Piece{piece.from, piece.to, {so_far}});
        for (std::size_t k = 0; k < piece.value.n_terms(); ++k)
            sum.value.append(piece.value[k] / static_cast<double>(k + 1));
        so_far = sum.value(piece.to - piece.from);
    }
    integral.after_ = so_far;
    return integral;
}

PositionFunction PositionFunction::largest_within(double least, double most, double shortest) const
{
    const std::vector<Trial> inner = candidates();
    std::vector<double> cuts;
    for (const Trial& candidate : inner) {
        cuts.push_back(candidate.x + least);
        cuts.push_back(candidate.x + most);
    }
    std::sort(cuts.begin(), cuts.end());
    UpperEnvelope envelope(shortest);
    WindowMaximum inside(inner);
    Walker near(*this), far(*this);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double from = cuts[i], to = cuts[i + 1], middle = 0.5 * (from + to);
        if (to - from <= shortest) continue;
        const Polynomial at_near = near.polynomial_about(from - least, middle - least);
        const Polynomial at_far = far.polynomial_about(from - most, middle - most);
        std::vector<Branch> branches{{Branch::Of::NearEnd, near.piece(), at_near},
                                     {Branch::Of::FarEnd, far.piece(), at_far}};
        const double within = inside.between(middle - most, middle - least);
        if (std::isfinite(within)) branches.push_back({Branch::Of::Within, 0, constant(within)});
        envelope.append(branches, from, to);
    }
    return {envelope.pieces(), before_, after_};
}

std::vector<Trial> PositionFunction::candidates() const
{
    std::vector<Trial> all;
    if (pieces_.empty()) return all;
    all.reserve(3 * pieces_.size() + 2);
    all.push_back({pieces_.front().from, before_, Trial::Kind::BreakBefore});
    for (const Piece& piece : pieces_) {
        const double length = piece.to - piece.from;
        all.push_back({piece.from, piece.value[0], Trial::Kind::BreakAfter});
        visit_stationary_places(piece.value, length, [&](double t) {
            all.push_back({piece.from + t, piece.value(t), Trial::Kind::Root});
        });
        all.push_back({piece.to, piece.value(length), Trial::Kind::BreakBefore});
    }
    all.push_back({pieces_.back().to, after_, Trial::Kind::BreakAfter});
    return all;
}

double PositionFunction::value(double x, Side side, double shortest) const
{
    const double inside = side == Side::After ? x + shortest : x - shortest;
    return Walker(*this).polynomial_about(x, inside)[0];
}

double PositionFunction::largest_magnitude() const
{
    double largest = std::max(std::abs(before_), std::abs(after_));
    for (const Piece& piece : pieces_) {
        double sum = 0.0;
        for (std::size_t k = piece.value.n_terms(); k-- > 0;)
            sum = sum * (piece.to - piece.from) + std::abs(piece.value[k]);
        largest = std::max(largest, sum);
    }
    return largest;
}

} // namespace femoop::influence
