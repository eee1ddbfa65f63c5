#include <doctest/doctest.h>

#include <numbers>

#include "topology/geometry/curve_contact.h"

using namespace topology;
using doctest::Approx;

namespace {

constexpr double straight_angle = std::numbers::pi;
constexpr double snap = 1e-9;

Curve ellipse(const FlatPoint& center, double a, double b)
{
    return EllipticArc{center, {a, 0.0}, {0.0, b}, 0.0, 2.0 * straight_angle};
}
Curve circle(const FlatPoint& center, double r) { return ellipse(center, r, r); }
Curve line(const FlatPoint& a, const FlatPoint& b) { return Segment{a, b}; }

} // namespace

TEST_SUITE("where curves meet")
{
    TEST_CASE("Every contact lies on both curves, by its parameters")
    {
        const std::vector<Curve> curves{line({-3.0, -1.1}, {3.0, 1.7}),
                                        circle({0.2, 0.1}, 1.4),
                                        ellipse({0.0, 0.0}, 2.0, 1.0),
                                        ellipse({0.3, 0.2}, 1.0, 2.1),
                                        CubicBezier{{{{-2.0, -1.0}, {0.0, 4.0}, {1.0, -4.0}, {2.5, 1.3}}}},
                                        CubicBezier{{{{-2.0, 1.5}, {5.0, 2.0}, {-5.0, -2.0}, {2.0, -1.5}}}}};
        std::size_t n = 0;
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (std::size_t j = i + 1; j < curves.size(); ++j) {
                const CurveContacts found = contacts(curves[i], curves[j], snap);
                CHECK(!found.run_together);
                n += found.places.size();
                for (const CurveContact& contact : found.places) {
                    CHECK(distance(curves[i].at(contact.t), contact.at) < 1e-12);
                    CHECK(distance(curves[j].at(contact.u), contact.at) < 1e-12);
                }
            }
        CHECK(n > 30); // the curves were chosen to cross often
    }

    TEST_CASE("Two ellipses cross in four places, a line and a cubic in three")
    {
        CHECK(contacts(ellipse({0.0, 0.0}, 2.0, 1.0), ellipse({0.0, 0.0}, 1.0, 2.0), snap).places.size() == 4);
        const Curve cubic = CubicBezier{
            {{{-2.0, -6.0}, {-2.0 / 3.0, 26.0 / 3.0}, {2.0 / 3.0, -26.0 / 3.0}, {2.0, 6.0}}}};
        const CurveContacts found = contacts(cubic, line({-3.0, 0.0}, {3.0, 0.0}), snap); // x^3 - x = 0
        REQUIRE(found.places.size() == 3);
        for (int i = 0; i < 3; ++i)
            CHECK(found.places[static_cast<std::size_t>(i)].at.x == Approx(i - 1.0).epsilon(1e-12));
    }

    TEST_CASE("Slender ellipses are found to cross wherever they turn sharply")
    {
        const auto turned = [](const FlatPoint& center, double a, double b) {
            const double c = std::cos(straight_angle / 6.0), s = std::sin(straight_angle / 6.0);
            return Curve(EllipticArc{center, {a * c, a * s}, {-b * s, b * c}, 0.0, 2.0 * straight_angle});
        };
        CHECK(contacts(turned({6.5, 7.0}, 1.0, 18.0), turned({1.0, 4.0}, 8.0, 17.0), snap).places.size() % 2 == 0);
        for (double angle = 0.0; angle < 3.0; angle += 0.1) { // a slender one through the middle of a circle
            const FlatVector p{20.0 * std::cos(angle), 20.0 * std::sin(angle)},
                q{-0.1 * std::sin(angle), 0.1 * std::cos(angle)};
            CHECK(
                contacts(EllipticArc{{0.0, 0.0}, p, q, 0.0, 2.0 * straight_angle}, ellipse({0.0, 0.0}, 3.0, 2.0), snap)
                    .places.size() == 4);
        }
    }

    TEST_CASE("What touches to within snap has one contact, also where it crosses twice by less")
    {
        for (const double off : {-0.4e-9, 0.0, 0.4e-9}) {
            CAPTURE(off);
            CHECK(contacts(circle({0.0, 0.0}, 1.0), line({-2.0, 1.0 + off}, {2.0, 1.0 + off}), snap).places.size() ==
                  1);
            CHECK(contacts(circle({0.0, 0.0}, 1.0), circle({3.0 + off, 0.0}, 2.0), snap).places.size() == 1);
            CHECK(contacts(circle({0.0, 0.0}, 3.0), circle({2.0 + off, 0.0}, 1.0), snap).places.size() == 1);
            CHECK(contacts(circle({2.0 + off, 0.0}, 1.0), circle({0.0, 0.0}, 3.0), snap).places.size() == 1);
            CHECK(contacts(ellipse({0.0, 0.0}, 3.0, 2.0), ellipse({0.0, 5.0 + off}, 1.0, 3.0), snap).places.size() ==
                  1);
        }
        CHECK(contacts(circle({0.0, 0.0}, 1.0), line({-2.0, 1.0 + 3e-9}, {2.0, 1.0 + 3e-9}), snap).places.empty());
        CHECK(contacts(circle({0.0, 0.0}, 1.0), line({-2.0, 1.0 - 3e-9}, {2.0, 1.0 - 3e-9}), snap).places.size() == 2);
    }

    TEST_CASE("The places are the same bit for bit, whichever curve comes first")
    {
        const std::vector<Curve> curves{line({-3.0, -1.1}, {3.0, 1.7}), line({2.0, 0.3}, {-1.0, 0.7}),
                                        circle({0.2, 0.1}, 1.4), ellipse({0.0, 0.0}, 2.0, 1.0),
                                        CubicBezier{{{{-2.0, -1.0}, {0.0, 4.0}, {1.0, -4.0}, {2.5, 1.3}}}}};
        for (const Curve& a : curves)
            for (const Curve& b : curves) {
                if (&a == &b) continue;
                std::vector<FlatPoint> there, back;
                for (const CurveContact& contact : contacts(a, b, snap).places) there.push_back(contact.at);
                for (const CurveContact& contact : contacts(b, a, snap).places) back.push_back(contact.at);
                const auto by_place = [](const FlatPoint& p) { return std::pair(p.x, p.y); };
                std::ranges::sort(there, {}, by_place);
                std::ranges::sort(back, {}, by_place);
                CHECK(there == back);
            }
    }

    TEST_CASE("Straight lines and arcs of one circle may lie on one another, other curves may not")
    {
        const CurveContacts lines = contacts(line({0.0, 0.0}, {3.0, 1.0}), line({1.5, 0.5}, {6.0, 2.0}), snap);
        CHECK((lines.places.empty() && !lines.run_together));
        const CurveContacts arcs = contacts(circle({1.0, 2.0}, 3.0), circle({1.0, 2.0}, 3.0), snap);
        CHECK((arcs.places.empty() && !arcs.run_together));
        const Curve bezier = CubicBezier{{{{0.0, 0.0}, {1.0, 2.0}, {2.0, -2.0}, {3.0, 0.5}}}};
        CHECK(contacts(bezier, bezier, snap).run_together);
        const Curve straight = CubicBezier{{{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {3.0, 0.0}}}};
        CHECK(contacts(straight, line({1.0, 0.0}, {9.0, 0.0}), snap).run_together);
    }
}
