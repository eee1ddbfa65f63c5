#include "femoop/methods/influence/train/train_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "femoop/methods/influence/train/standing_train.h"
#include "tests/femoop/methods/train/random_train.h"

using namespace femoop;
using namespace femoop::influence;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop train");

namespace {

constexpr double L = 100.0; // ft

/// Of the moment at x on a simple span.
PiecewiseLine moment_line(double x) { return {{{0.0, x, {0.0, (L - x) / L}}, {x, L, {x * (L - x) / L, -x / L}}}}; }

/// Of the shear at x.
PiecewiseLine shear_line(double x) { return {{{0.0, x, {0.0, -1.0 / L}}, {x, L, {1.0 - x / L, -1.0 / L}}}}; }

/// The HS20-44 truck, kip and ft.
MovingTrain one_way_truck() { return {.axles = {8.0, 32.0, 32.0}, .spacings = {{14.0, 14.0}, {14.0, 14.0}}}; }

Placing largest(const PiecewiseLine& line, const MovingTrain& train)
{
    return TrainSearch(line, {0.0, line.pieces.back().to}, train).largest();
}

Placing least(const PiecewiseLine& line, const MovingTrain& train)
{
    return TrainSearch(line, {0.0, line.pieces.back().to}, train).least();
}

/// The line with the path turned.
PiecewiseLine turned(const PiecewiseLine& line)
{
    PiecewiseLine mirror;
    const double end = line.pieces.back().to;
    for (std::size_t i = line.pieces.size(); i-- > 0;) {
        const LinePiece& piece = line.pieces[i];
        const double h = piece.to - piece.from;
        const std::vector<double>& c = piece.coefficients;
        mirror.pieces.push_back({end - piece.to,
                                 end - piece.from,
                                 {c[0] + h * (c[1] + h * (c[2] + h * c[3])), -c[1] - h * (2.0 * c[2] + 3.0 * h * c[3]),
                                  c[2] + 3.0 * h * c[3], -c[3]}});
    }
    return mirror;
}

} // namespace

TEST_CASE("The HS20 truck bends the middle of 100 ft most with its middle axle there")
{
    const Placing worst = largest(moment_line(50.0), one_way_truck());
    CHECK(worst.value == Approx(8.0 * 18.0 + 32.0 * 25.0 + 32.0 * 18.0));
    CHECK(worst.position.value() == Approx(64.0));
    CHECK(!worst.reversed);
    CHECK(worst.spacings == std::vector<double>{14.0, 14.0});
}

TEST_CASE("Barre: under two wheels the moment is largest where middle of span halves wheel and resultant")
{
    const double P = 32.0, Q = 20.0, d = 14.0, e = Q * d / (P + Q); // the resultant lies e behind P
    const double x = 0.5 * (L + e);
    const MovingTrain wheels{.axles = {P, Q}, .spacings = {{d, d}}};
    const Placing worst = largest(moment_line(x), wheels);
    CHECK(worst.position.value() == Approx(x));
    CHECK(worst.value == Approx((P + Q) * (L - e) * (L - e) / (4.0 * L)).epsilon(0.02));
    for (const double other : {0.9 * x, 0.99 * x, 1.01 * x, 1.1 * x})
        CHECK(largest(moment_line(other), wheels).value < worst.value);
}

TEST_CASE("At a jump the train counts from both sides, as a whole")
{
    const double x = 30.0;
    const MovingTrain two{.axles = {10.0, 7.0}, .spacings = {{70.0, 70.0}}}; // from the jump to the path's end
    CHECK(largest(shear_line(x), two).value == Approx(10.0 * 0.7));
    CHECK(least(shear_line(x), two).value == Approx(-10.0 * 0.3));
    CHECK(least(shear_line(x), two).position.value() == Approx(x));
}

TEST_CASE("Breaks that rounding parts are one: no axle is taken before a jump and the next one behind another")
{
    // Two jumps, 0.3 apart; the spacing is 0.1 + 0.2.
    const PiecewiseLine line{{{0.0, 1.0, {0.0}}, {1.0, 1.3, {5.0}}, {1.3, 3.0, {-4.0}}}};
    const MovingTrain two{.axles = {1.0, 1.0}, .spacings = {{0.1 + 0.2, 0.1 + 0.2}}};
    CHECK(largest(line, two).value == Approx(5.0));
}

TEST_CASE("Of several positions with one value the first forwards is told")
{
    MovingTrain train{.axles = {3.0, 5.0, 3.0}, .spacings = {{10.0, 10.0}, {10.0, 10.0}}, .both_directions = true};
    const Placing worst = largest(moment_line(50.0), train);
    CHECK(!worst.reversed);
    CHECK(worst.position.value() == Approx(60.0));
    train.axles = {4.0};
    train.spacings.clear();
    const PiecewiseLine two_peaks{{{0.0, 10.0, {0.0, 0.2}}, {10.0, 20.0, {2.0, -0.2}}, {20.0, 30.0, {0.0, 0.2}}}};
    CHECK(largest(two_peaks, train).position.value() == Approx(10.0));
}

TEST_CASE("Reversed the others stand at greater s, and it is told only where it is worse")
{
    MovingTrain train = one_way_truck();
    train.both_directions = true;
    CHECK(!largest(shear_line(0.0), train).reversed);
    const Placing worst = least(shear_line(L), train);
    CHECK(worst.reversed);
    CHECK(worst.position.value() == Approx(72.0));
    CHECK(worst.value == Approx(-65.28));
}

TEST_CASE("A train may be away: where it only relieves, the uniform load lies alone")
{
    const PiecewiseLine line{{{0.0, 10.0, {-1.0}}}};
    const MovingTrain train{.axles = {5.0}, .uniform = 2.0, .extent = UniformExtent::Everywhere, .concentrated = {4.0}};
    const Placing worst = largest(line, train);
    CHECK(worst.value == Approx(-20.0));
    CHECK(!worst.concentrated.at(0));
    CHECK(least(line, train).value == Approx(-20.0 - 5.0 - 4.0));
}

TEST_CASE("The uniform load lies where it adds, on whole members, everywhere, or outside the axles")
{
    const double x = 25.0;
    const PiecewiseLine line = shear_line(x);
    MovingTrain train{.axles = {}, .uniform = 2.0};
    CHECK(largest(line, train).value == Approx(2.0 * 0.5 * 0.75 * 75.0));
    CHECK(least(line, train).value == Approx(-2.0 * 0.5 * 0.25 * 25.0));
    CHECK(largest(line, train).uniform.at(0).from == Approx(x));
    train.extent = UniformExtent::WholeSpans;
    CHECK(largest(line, train).value == Approx(2.0 * (0.5 * 0.75 * 75.0 - 0.5 * 0.25 * 25.0)));
    CHECK(least(line, train).value == Approx(0.0));
    train.extent = UniformExtent::Everywhere;
    CHECK(least(line, train).value == Approx(2.0 * (0.5 * 0.75 * 75.0 - 0.5 * 0.25 * 25.0)));
}

TEST_CASE("A spacing that varies is as the effect wants it: at an end of its range, or between")
{
    // Two peaks 20 apart: the two axles want to stand there.
    const PiecewiseLine line{
        {{0.0, 30.0, {0.0, 0.1}}, {30.0, 40.0, {3.0, -0.3}}, {40.0, 50.0, {0.0, 0.3}}, {50.0, 80.0, {3.0, -0.1}}}};
    const MovingTrain between{.axles = {6.0, 4.0}, .spacings = {{14.0, 30.0}}};
    CHECK(largest(line, between).value == Approx(30.0));
    CHECK(largest(line, between).spacings.at(0) == Approx(20.0));
    const MovingTrain below{.axles = {6.0, 4.0}, .spacings = {{14.0, 18.0}}};
    CHECK(largest(line, below).spacings.at(0) == Approx(18.0));
    CHECK(largest(line, below).value == Approx(18.0 + 4.0 * 2.4));
}

TEST_CASE("With each spacing more that varies the pieces of the effect grow by about as many, not by a factor")
{
    const auto n_pieces = [](std::size_t n) {
        MovingTrain train{.axles = std::vector<double>(n + 1, 10.0), .spacings = {}};
        for (std::size_t i = 0; i < n; ++i) train.spacings.push_back({4.0 + 0.1 * static_cast<double>(i), 9.0});
        return TrainSearch(moment_line(30.0), {0.0, L}, train).over_positions(ExtremeKind::Max, false).pieces().size();
    };
    const std::size_t few = n_pieces(5), many = n_pieces(20);
    CAPTURE(few);
    CAPTURE(many);
    CHECK(many < 5 * few);
}

TEST_CASE("What a placing says adds up to its value, and no other placing goes beyond")
{
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        const RandomTrain random(seed);
        const TrainSearch search(random.line, random.ends, random.train);
        const Placing most = search.largest(), few = search.least();
        Dice dice(seed + 1000);
        for (int i = 0; i < 60; ++i) {
            const Placing other = thrown(random, dice);
            const TrainSearch::Stand stand{*other.position, other.reversed, other.spacings};
            const Placing high = search.at(stand, ExtremeKind::Max), low = search.at(stand, ExtremeKind::Min);
            CHECK(high.value == Approx(random.effect(high, ExtremeKind::Max)).epsilon(1e-9));
            CHECK(low.value == Approx(random.effect(low, ExtremeKind::Min)).epsilon(1e-9));
            CHECK(high.value <= most.value + 1e-9);
            CHECK(low.value >= few.value - 1e-9);
        }
    }
}

TEST_CASE("The value that is told comes about as near as one likes to the placing that is told")
{
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        const RandomTrain random(seed);
        const TrainSearch search(random.line, random.ends, random.train);
        const Placing most = search.largest();
        if (!most.position) continue;
        double nearest = 1e9; // beside jumps each axle may stand on the side that the spacings leave it
        Dice dice(seed);
        for (int i = 0; i < 200; ++i) {
            TrainSearch::Stand stand{*most.position + 1e-8 * dice.roll(-9, 9), most.reversed, most.spacings};
            for (double& spacing : stand.spacings) spacing += 1e-8 * dice.roll(-9, 9);
            nearest = std::min(nearest, std::abs(search.at(stand, ExtremeKind::Max).value - most.value));
        }
        CHECK(nearest < 1e-5);
    }
}

TEST_CASE("Turning the path turns the train: the same values, at L - s")
{
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        RandomTrain random(seed);
        random.train.both_directions = true;
        std::vector<double> ends;
        for (std::size_t i = random.ends.size(); i-- > 0;) ends.push_back(random.ends.back() - random.ends[i]);
        const Placing here = TrainSearch(random.line, random.ends, random.train).largest();
        const Placing there = TrainSearch(turned(random.line), ends, random.train).largest();
        CHECK(here.value == Approx(there.value).epsilon(1e-10));
    }
}

TEST_CASE(
    "Over its positions the effect is one curve, whose peak is the worst place, either way and with a uniform load")
{
    MovingTrain train = one_way_truck();
    train.spacings[1] = {14.0, 30.0};
    train.both_directions = true;
    train.uniform = 0.64;
    for (const UniformExtent extent : {UniformExtent::Adverse, UniformExtent::Outside}) {
        train.extent = extent;
        const TrainSearch search(shear_line(37.0), {0.0, L}, train);
        for (const ExtremeKind kind : {ExtremeKind::Max, ExtremeKind::Min}) {
            double most = 0.0;
            const double sign = kind == ExtremeKind::Max ? 1.0 : -1.0;
            for (const bool reversed : {false, true}) {
                CAPTURE(reversed);
                const PositionFunction curve = search.over_positions(kind, reversed);
                const Stretch positions = search.positions(reversed);
                CHECK(positions.to - positions.from == Approx(L + 14.0 + 30.0));
                for (const double share : {0.03, 0.21, 0.48, 0.77, 0.92}) {
                    const double position = positions.from + share * (positions.to - positions.from);
                    const Placing there = search.at({.position = position, .reversed = reversed}, kind);
                    CHECK(there.value == Approx(curve.value(position, Side::After, 1e-9)));
                }
                for (const auto& candidate : curve.candidates()) most = std::max(most, sign * candidate.value);
            }
            const WorstPlacings worst = search.worst();
            CHECK(most == Approx(sign * (kind == ExtremeKind::Max ? worst.max : worst.min).value));
        }
    }
}

TEST_CASE("Axles times ordinates sum up to the value at any section, also where rounding puts one a hair beside a jump")
{
    MovingTrain truck = one_way_truck();
    truck.both_directions = true;
    for (int i = 1; i < 1000; ++i) {
        const double x = 0.1 * L * std::abs(std::sin(1.7 * i)) + 0.0893 * i;
        CAPTURE(x);
        const PiecewiseLine line = shear_line(x);
        for (const ExtremeKind kind : {ExtremeKind::Max, ExtremeKind::Min}) {
            const Placing worst = kind == ExtremeKind::Max ? largest(line, truck) : least(line, truck);
            double sum = 0.0;
            for (const StandingForce& axle : standing_forces(truck, worst, line, kind))
                sum += axle.force * axle.ordinate;
            CHECK(sum == Approx(worst.value).epsilon(1e-9));
        }
    }
}

TEST_CASE("The proof lists the candidates, and the largest of them is the value")
{
    const TrainSearch search(moment_line(50.0), {0.0, L}, one_way_truck());
    const SearchProof proof = search.proof(ExtremeKind::Max);
    double most = 0.0;
    for (const SearchProof::Entry& entry : proof.entries) most = std::max(most, entry.candidate.value);
    CHECK(proof.entries.size() > 6);
    CHECK(most == Approx(1520.0));
}

TEST_SUITE_END();
