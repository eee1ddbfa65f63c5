#include "femoop/methods/influence/train/extreme_search.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace femoop;
using namespace femoop::influence;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop train");

namespace {

/// A simple span.
SectionLines moments(double span)
{
    return {
        [span](double x) {
            return PiecewiseLine{{{0.0, x, {0.0, (span - x) / span}}, {x, span, {x * (span - x) / span, -x / span}}}};
        },
        span, 1};
}

SectionLines shears(double span)
{
    return {[span](double x) {
                return PiecewiseLine{{{0.0, x, {0.0, -1.0 / span}}, {x, span, {1.0 - x / span, -1.0 / span}}}};
            },
            span, 1};
}

/// HS20-44, kip and ft.
MovingTrain truck()
{
    return {.axles = {8.0, 32.0, 32.0}, .spacings = {{14.0, 14.0}, {14.0, 14.0}}, .both_directions = true};
}

/// Its lane load for moments.
MovingTrain lane(double concentrated) { return {.axles = {}, .uniform = 0.64, .concentrated = {concentrated}}; }

} // namespace

TEST_CASE("The HS20 truck on simple spans bends and shears them as AASHTO's table says")
{
    struct Row {
        double span, moment, shear; // appendix A: kip ft and kip
    };
    for (const Row& row : {Row{40.0, 449.8, 55.2}, Row{60.0, 806.5, 60.8}, Row{100.0, 1524.0, 65.3}}) {
        CAPTURE(row.span);
        const auto M = worst_section(moments(row.span), {0.0, row.span}, truck(), ExtremeKind::Max);
        const auto V = worst_section(shears(row.span), {0.0, row.span}, truck(), ExtremeKind::Max);
        CHECK(M.placing.value == Approx(row.moment).epsilon(1e-4));
        CHECK(V.placing.value == Approx(row.shear).epsilon(1e-3));
        CHECK(V.sections == std::vector<double>{0.0});
        // Middle of the span halves the middle axle and the resultant, 14 (32 - 8) / 72 = 4 2/3 behind it.
        REQUIRE(M.sections.size() == 2);
        CHECK(M.sections[0] == Approx(0.5 * row.span - 7.0 / 3.0).epsilon(1e-9));
        CHECK(M.sections[1] == Approx(0.5 * row.span + 7.0 / 3.0).epsilon(1e-9));
        CHECK(!M.placing.reversed);
    }
}

TEST_CASE("Barre: middle of the span halves the heavier of two wheels and their resultant")
{
    const double L = 30.0, P = 31.0, Q = 17.0, d = 6.0, e = Q * d / (P + Q);
    const MovingTrain wheels{.axles = {P, Q}, .spacings = {{d, d}}};
    const auto worst = worst_section(moments(L), {0.0, L}, wheels, ExtremeKind::Max);
    REQUIRE(worst.sections.size() == 1);
    CHECK(worst.sections[0] == Approx(0.5 * (L + e)).epsilon(1e-9));
    CHECK(worst.placing.value == Approx((P + Q) * (L - e) * (L - e) / (4.0 * L)).epsilon(1e-10));
    CHECK(worst.placing.position.value() == Approx(worst.sections[0]));
}

TEST_CASE("The lane load is worst at midspan for moments and at a support for shear")
{
    const double L = 60.0;
    const auto M = worst_section(moments(L), {0.0, L}, lane(18.0), ExtremeKind::Max);
    CHECK(M.placing.value == Approx(558.0).epsilon(1e-10)); // published
    REQUIRE(M.sections.size() == 1);
    CHECK(M.sections[0] == Approx(30.0).epsilon(1e-6));
    CHECK(M.placing.concentrated.at(0).value() == Approx(30.0).epsilon(1e-6));
    const auto V = worst_section(shears(L), {0.0, L}, lane(26.0), ExtremeKind::Max);
    CHECK(V.placing.value == Approx(45.2).epsilon(1e-10));
    CHECK(V.sections == std::vector<double>{0.0});
}

TEST_CASE("No section and no position goes beyond the worst, whatever the train")
{
    const double L = 23.0;
    for (const double gap : {0.0, 2.5}) {
        MovingTrain train = truck();
        train.spacings[1].most = 17.0 + gap;
        train.uniform = gap;
        const SectionLines lines = moments(L);
        const auto worst = worst_section(lines, {0.0, L}, train, ExtremeKind::Max);
        double most = 0.0;
        for (int i = 0; i <= 500; ++i)
            most = std::max(most, TrainSearch(lines.at(L * i / 500.0), {0.0, L}, train).largest().value);
        CHECK(most <= worst.placing.value + 1e-9);
        CHECK(most >= worst.placing.value * (1.0 - 1e-4));
    }
}

TEST_CASE("A permanent moment moves the worst section")
{
    const double L = 20.0, P = 10.0, g = 3.0;
    const MovingTrain wheel{.axles = {P}};
    const Permanent permanent{[&](double x) { return 0.5 * g * x * (L - x) + 40.0 * x; }, {}, 1.4};
    const auto worst = worst_section(moments(L), {0.0, L}, wheel, ExtremeKind::Max, &permanent);
    const double k = 0.5 * g + 1.4 * P / L, x = 0.5 * (L + 40.0 / k); // of k x (L - x) + 40 x
    CHECK(worst.sections.at(0) == Approx(x).epsilon(1e-6));
    CHECK(worst.placing.value == Approx(k * x * (L - x) + 40.0 * x).epsilon(1e-12));
}

TEST_CASE("Where no load does anything the ends of the member are named, however many axles there are")
{
    const SectionLines nothing([](double x) { return PiecewiseLine{{{0.0, x, {}}, {x, 9.0, {}}}}; }, 9.0, 1);
    MovingTrain convoy{.axles = std::vector<double>(60, 3.0),
                       .spacings = std::vector<MovingTrain::Spacing>(59, {0.1, 0.1})};
    const WorstSection worst = worst_section(nothing, {0.0, 9.0}, convoy, ExtremeKind::Max);
    CHECK(worst.sections == std::vector<double>{0.0, 9.0});
    CHECK(worst.placing.value == 0.0);
}

TEST_CASE("A member whose force does not change names the two ends of the stretch")
{
    const double L = 7.0; // a cantilever, its tip the first node: V = -P from the load to the clamp
    const SectionLines lines{[](double x) { return PiecewiseLine{{{0.0, x, {-1.0}}, {x, 7.0, {}}}}; }, L, 1};
    const auto worst = worst_section(lines, {0.0, L}, {.axles = {5.0}}, ExtremeKind::Min);
    CHECK(worst.placing.value == Approx(-5.0));
    CHECK(worst.sections == std::vector<double>{0.0, L});
    CHECK(worst.placing.position.value() == Approx(0.0));
}

TEST_SUITE_END();
