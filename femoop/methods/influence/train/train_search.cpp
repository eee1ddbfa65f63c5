#include "femoop/methods/influence/train/train_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "femoop/methods/influence/polynomial_terms.h"
#include "femoop/methods/influence/train/train_run.h"
#include "femoop/result/magnitudes.h"

namespace femoop::influence {

namespace {

using Trial = PositionFunction::Candidate;
using Piece = PositionFunction::Piece;

constexpr double shortest_piece = 1e-9; ///< of the path: breaks that are nearer are one
constexpr double zero_ordinate = 1e-13; ///< of the largest ordinate: what is nearer to zero is zero
constexpr double equal_values = 1e-10;  ///< of the largest effect: values that are one
constexpr double one_place = 1e-5;      ///< of the path: candidates that may be one maximum

/// The uniform load where it lies, as long as no axle takes it away.
struct LaidLoad {
    double effect = 0.0;
    std::vector<Stretch> stretches;
    PositionFunction covered; ///< integral of its effect from the path's beginning
};

void append(std::vector<Stretch>& stretches, const Stretch& next, double shortest)
{
    if (next.to - next.from <= shortest) return;
    if (!stretches.empty() && next.from - stretches.back().to <= shortest) stretches.back().to = next.to;
    else stretches.push_back(next);
}

/// The function where it is positive, and 0 elsewhere.
std::vector<Piece> positive_parts(const PositionFunction& of)
{
    const double zero = zero_ordinate * of.largest_magnitude();
    std::vector<Piece> parts;
    for (const Piece& piece : of.pieces()) {
        const double length = piece.to - piece.from;
        std::vector<double> cuts = piece.value.roots(length);
        cuts.insert(cuts.begin(), 0.0);
        cuts.push_back(length);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i + 1] <= cuts[i]) continue;
            const bool is_positive = piece.value(0.5 * (cuts[i] + cuts[i + 1])) > zero;
            parts.push_back({piece.from + cuts[i], piece.from + cuts[i + 1],
                             is_positive ? piece.value.shifted(cuts[i]) : Polynomial{0.0}});
        }
    }
    return parts;
}

bool is_nothing(const Piece& piece) { return piece.value.n_terms() == 1 && piece.value[0] == 0.0; }

/// Over the places of one search: a line, times the sign of what is sought, so that the largest is wanted.
class LargestEffect {
public:
    /// \param opposite  the same with the other sign, if it is at hand
    LargestEffect(const PiecewiseLine& line, const std::vector<double>& ends, const MovingTrain& train, double sign,
                  const LargestEffect* opposite = nullptr)
        : train_(train), ends_(ends), length_(ends.back()), shortest_(shortest_piece * length_), sign_(sign)
    {
        const PositionFunction plain(line);
        line_ = PositionFunction::sum({{&plain, sign, 0.0}}, 0.0);
        scale_ = largest_force() * line_.largest_magnitude();
        lay_uniform();
        stand_concentrated();
        if (train.axles.empty()) return;
        if (opposite != nullptr && opposite->forwards_->is_linear()) {
            forwards_ = opposite->forwards_->negated();
            if (train.both_directions) reversed_ = opposite->reversed_->negated();
            return;
        }
        forwards_.emplace(ground(line_, uniform_.covered), train_);
        if (!train.both_directions) return;
        mirrored_line_ = line_.mirrored(length_);
        mirrored_cover_ = mirrored_cover();
        reversed_.emplace(ground(mirrored_line_, mirrored_cover_), train_);
    }
    LargestEffect(const LargestEffect&) = delete;
    LargestEffect& operator=(const LargestEffect&) = delete;

    Placing placing() const
    {
        Placing placing = resting();
        placing.value = uniform_.effect + concentrated_;
        if (train_.axles.empty()) return signed_value(std::move(placing));
        const std::vector<Trial> along = candidates(*forwards_),
                                 back = reversed_ ? candidates(*reversed_) : std::vector<Trial>();
        if (const auto found = best_of(along, back))
            stand(placing, found->reversed ? *reversed_ : *forwards_, found->candidate, found->reversed);
        return signed_value(std::move(placing));
    }

    Placing at(double position, bool is_reversed) const
    {
        const TrainRun& run = is_reversed ? *reversed_ : *forwards_;
        const double x = is_reversed ? length_ - position : position;
        Placing placing = resting();
        const double before = run.largest().value(x, Side::Before, shortest_);
        const double after = run.largest().value(x, Side::After, shortest_);
        const bool is_after = after >= before;
        stand(placing, run,
              {x, is_after ? after : before, is_after ? Trial::Kind::BreakAfter : Trial::Kind::BreakBefore},
              is_reversed);
        return signed_value(std::move(placing));
    }

    PositionFunction over_positions(bool is_reversed) const
    {
        const PositionFunction& run = (is_reversed ? *reversed_ : *forwards_).largest();
        const double rest = sign_ * (uniform_.effect + concentrated_);
        const PositionFunction resting({}, rest, rest);
        const PositionFunction sum = PositionFunction::sum({{&run, sign_, 0.0}, {&resting, 1.0, 0.0}}, 0.0);
        return is_reversed ? sum.mirrored(length_) : sum;
    }

    SearchProof proof() const
    {
        SearchProof proof;
        proof.uniform = cleaned(sign_ * uniform_.effect);
        proof.concentrated = cleaned(sign_ * concentrated_);
        proof.scale = scale_;
        const std::vector<Trial> along = forwards_ ? candidates(*forwards_) : std::vector<Trial>(),
                                 back = reversed_ ? candidates(*reversed_) : std::vector<Trial>();
        for (const Trial& candidate : along) proof.entries.push_back(told({candidate, false}));
        for (const Trial& candidate : back) proof.entries.push_back(told({candidate, true}));
        if (const auto found = best_of(along, back)) proof.best = told(*found);
        return proof;
    }

private:
    bool is_outside() const { return train_.extent == UniformExtent::Outside && train_.uniform != 0.0; }

    TrainRun::Ground ground(const PositionFunction& line, const PositionFunction& covered) const
    {
        return {.line = &line, .covered = is_outside() ? &covered : nullptr, .gap = train_.gap, .shortest = shortest_};
    }

    PositionFunction mirrored_cover() const
    {
        const PositionFunction turned = uniform_.covered.mirrored(length_);
        const PositionFunction whole({}, uniform_.effect, uniform_.effect);
        return PositionFunction::sum({{&whole, 1.0, 0.0}, {&turned, -1.0, 0.0}}, 0.0);
    }

    void lay_uniform()
    {
        if (train_.uniform == 0.0) return;
        const PositionFunction effect = PositionFunction::sum({{&line_, train_.uniform, 0.0}}, 0.0);
        if (train_.extent == UniformExtent::Everywhere) lay(effect.integral().after(), {0.0, length_});
        else if (train_.extent == UniformExtent::WholeSpans) lay_on_members(effect.integral());
        else lay_where_it_adds(effect);
    }

    void lay(double effect, const Stretch& on)
    {
        uniform_.effect += effect;
        append(uniform_.stretches, on, shortest_);
    }

    void lay_on_members(const PositionFunction& integral)
    {
        const double zero = zero_ordinate * integral.largest_magnitude();
        for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
            const double effect = integral.value(ends_[i + 1], Side::Before, 0.0) -
                                  integral.value(ends_[i], Side::After, 0.0);
            if (effect > zero) lay(effect, {ends_[i], ends_[i + 1]});
        }
    }

    void lay_where_it_adds(const PositionFunction& effect)
    {
        const std::vector<Piece> parts = positive_parts(effect);
        for (const Piece& part : parts)
            if (!is_nothing(part)) append(uniform_.stretches, {part.from, part.to}, shortest_);
        uniform_.covered = PositionFunction(parts, 0.0, 0.0).integral();
        uniform_.effect = uniform_.covered.after();
    }

    void stand_concentrated()
    {
        for (const double force : train_.concentrated) {
            Trial best;
            std::vector<Trial> places = line_.candidates();
            for (Trial& place : places) place.value *= force;
            const double most = largest_of(places);
            const double zero = zero_ordinate * std::abs(force) * line_.largest_magnitude();
            standing_.emplace_back();
            if (!(most > zero)) continue;
            const double margin = most - equal_values * std::abs(force) * line_.largest_magnitude();
            best = first(places, margin).value();
            standing_.back() = std::clamp(best.x, 0.0, length_);
            concentrated_ += best.value;
        }
    }

    /// Of a run: the places that the contract of a train allows.
    std::vector<Trial> candidates(const TrainRun& run) const
    {
        std::vector<Trial> all = run.largest().candidates();
        double last = length_;
        for (const MovingTrain::Spacing& spacing : train_.spacings) last += spacing.most;
        std::erase_if(all, [&](const Trial& c) { return c.x < -shortest_ || c.x > last + shortest_; });
        return all;
    }

    /// Of those that are largest together the first forwards, else the first reversed; nothing where all are below 0.
    std::optional<SearchProof::Entry> best_of(const std::vector<Trial>& along, const std::vector<Trial>& back) const
    {
        const double most = std::max({largest_of(along), largest_of(back), 0.0});
        const double margin = most - equal_values * scale_;
        if (const auto found = first(along, margin)) return SearchProof::Entry{*found, false};
        if (const auto found = first(back, margin)) return SearchProof::Entry{*found, true};
        return std::nullopt;
    }

    /// With its place along the path and the sign of the line.
    SearchProof::Entry told(SearchProof::Entry entry) const
    {
        if (entry.reversed) entry.candidate.x = length_ - entry.candidate.x;
        entry.candidate.value = cleaned(sign_ * entry.candidate.value);
        return entry;
    }

    static double largest_of(const std::vector<Trial>& candidates)
    {
        double most = -std::numeric_limits<double>::infinity();
        for (const Trial& candidate : candidates) most = std::max(most, candidate.value);
        return most;
    }

    /// Of the candidates that are not below the margin the first, or what is larger right beside it.
    std::optional<Trial> first(const std::vector<Trial>& candidates, double margin) const
    {
        std::optional<Trial> best;
        const double noticeable = zero_ordinate * scale_;
        for (const Trial& candidate : candidates) {
            if (candidate.value < margin) continue;
            if (best && candidate.x - best->x > one_place * length_) break;
            if (!best || candidate.value > best->value + noticeable) best = candidate;
        }
        return best;
    }

    double largest_force() const
    {
        double forces = std::abs(train_.uniform) * length_;
        for (const double axle : train_.axles) forces += std::abs(axle);
        for (const double force : train_.concentrated) forces = std::max(forces, std::abs(force));
        return forces;
    }

    /// Where the effects of several loads cancel, 0; never -0.
    double cleaned(double value) const { return without_rounding(value, scale_) + 0.0; }

    /// Without axles.
    Placing resting() const
    {
        Placing placing;
        placing.uniform = uniform_.stretches;
        placing.concentrated = standing_;
        return placing;
    }

    void stand(Placing& placing, const TrainRun& run, const Trial& found, bool is_reversed) const
    {
        const Side side = found.kind == Trial::Kind::BreakBefore ? Side::Before : Side::After;
        placing.value = found.value + uniform_.effect + concentrated_;
        placing.position = is_reversed ? length_ - found.x : found.x;
        placing.reversed = is_reversed;
        placing.spacings = run.spacings(found.x, side);
        if (!is_outside()) return;
        double last = found.x;
        for (const double spacing : placing.spacings) last -= spacing;
        Stretch bare{last - train_.gap, found.x + train_.gap};
        if (is_reversed) bare = {length_ - bare.to, length_ - bare.from};
        placing.uniform = without(placing.uniform, bare);
    }

    std::vector<Stretch> without(const std::vector<Stretch>& stretches, const Stretch& bare) const
    {
        std::vector<Stretch> left;
        for (const Stretch& stretch : stretches) {
            append(left, {stretch.from, std::min(stretch.to, bare.from)}, shortest_);
            append(left, {std::max(stretch.from, bare.to), stretch.to}, shortest_);
        }
        return left;
    }

    Placing signed_value(Placing placing) const
    {
        placing.value = cleaned(sign_ * placing.value);
        return placing;
    }

    const MovingTrain& train_;
    const std::vector<double>& ends_;
    double length_, shortest_, sign_;
    double scale_ = 0.0; ///< what all loads together may come to
    PositionFunction line_, mirrored_line_, mirrored_cover_;
    LaidLoad uniform_;
    std::vector<std::optional<double>> standing_;
    double concentrated_ = 0.0;
    std::optional<TrainRun> forwards_, reversed_;
};

double sign_of(ExtremeKind kind) { return kind == ExtremeKind::Max ? 1.0 : -1.0; }

} // namespace

double SearchProof::sum(const Entry& entry) const
{
    return without_rounding(entry.candidate.value + uniform + concentrated, scale);
}

bool SearchProof::is_best(const Entry& entry) const
{
    return std::abs(entry.candidate.value - (best ? best->candidate.value : 0.0)) <= equal_values * scale;
}

TrainSearch::TrainSearch(const PiecewiseLine& line, std::vector<double> ends, MovingTrain train)
    : line_(line), ends_(std::move(ends)), train_(std::move(train))
{}

WorstPlacings TrainSearch::worst() const
{
    const LargestEffect largest(line_, ends_, train_, 1.0);
    return {largest.placing(), LargestEffect(line_, ends_, train_, -1.0, &largest).placing()};
}

Placing TrainSearch::largest() const { return LargestEffect(line_, ends_, train_, 1.0).placing(); }
Placing TrainSearch::least() const { return LargestEffect(line_, ends_, train_, -1.0).placing(); }

Placing TrainSearch::at(const Stand& stand, ExtremeKind kind) const
{
    MovingTrain fixed = train_;
    fixed.both_directions = stand.reversed;
    for (std::size_t i = 0; i < stand.spacings.size(); ++i) fixed.spacings[i] = {stand.spacings[i], stand.spacings[i]};
    return LargestEffect(line_, ends_, fixed, sign_of(kind)).at(stand.position, stand.reversed);
}

PositionFunction TrainSearch::over_positions(ExtremeKind kind, bool reversed) const
{
    MovingTrain running = train_;
    running.both_directions = reversed;
    return LargestEffect(line_, ends_, running, sign_of(kind)).over_positions(reversed);
}

Stretch TrainSearch::positions(bool reversed) const
{
    double length = 0.0;
    for (const MovingTrain::Spacing& spacing : train_.spacings) length += spacing.most;
    return reversed ? Stretch{-length, ends_.back()} : Stretch{0.0, ends_.back() + length};
}

SearchProof TrainSearch::proof(ExtremeKind kind) const
{
    return LargestEffect(line_, ends_, train_, sign_of(kind)).proof();
}

} // namespace femoop::influence
