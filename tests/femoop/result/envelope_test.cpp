#include "femoop/result/envelope.h"

#include <doctest/doctest.h>

#include <stdexcept>

#include "femoop/analysis/linear_static.h"
#include "tests/femoop/result/two_cases.h"

using namespace femoop;

TEST_SUITE_BEGIN("result");

TEST_CASE("The envelope of a moment takes each case's own extreme, with its place and the case that governs")
{
    const Envelope envelope(analyse(two_cases()));
    const GoverningExtremes M = envelope.extremes(MemberId(0), MemberComponent::Mz);
    CHECK(M.max.value == doctest::Approx(30.0 * 2.0 * 6.0 / 8.0)); // P a b / L
    CHECK(M.max.x == doctest::Approx(2.0));
    CHECK(M.max.load_case == CaseId(0));
    CHECK(M.min.value == doctest::Approx(-12.0 * 6.0 * 2.0 / 8.0));
    CHECK(M.min.x == doctest::Approx(6.0));
    CHECK(M.min.load_case == CaseId(1));
}

TEST_CASE("The envelope of a reaction spans all cases and combinations")
{
    const Envelope envelope(analyse(two_cases()));
    const GoverningRange fy = envelope.reaction(NodeId(0), Dof::uy);
    CHECK(fy.max.value == doctest::Approx(22.5));
    CHECK(fy.max.load_case == CaseId(0));
    CHECK(fy.min.value == doctest::Approx(-3.0));
    CHECK(fy.min.load_case == CaseId(1));
}

TEST_CASE("Stations of the envelope hold the load points of every case, twice where one of them jumps")
{
    const Envelope envelope(analyse(two_cases()));
    std::vector<double> x;
    for (const EnvelopeStation& station : envelope.stations(MemberId(0), {MemberComponent::Vy}, 2))
        x.push_back(station.x);
    CHECK(x == std::vector<double>{0.0, 2.0, 2.0, 6.0, 6.0, 8.0});
}

TEST_CASE("At every station the envelope holds the value of every case between its bounds")
{
    const Results results = analyse(two_cases());
    const Envelope envelope(results);
    for (const EnvelopeStation& station : envelope.stations(MemberId(0), {MemberComponent::Mz}, 9))
        for (const CaseId id : envelope.cases()) {
            CAPTURE(station.x);
            const double M = results[id].curve(MemberId(0)).value(MemberComponent::Mz, station.x, station.side);
            CHECK(M <= station.ranges[0].max.value);
            CHECK(M >= station.ranges[0].min.value);
        }
}

TEST_CASE("An envelope of no case is refused")
{
    CHECK_THROWS_AS(Envelope(analyse(two_cases()), {}), std::invalid_argument);
}

TEST_SUITE_END();
