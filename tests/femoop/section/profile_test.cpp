#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "femoop/section/profile.h"

using namespace femoop;

// Every number of every row is held against the others by a law that no table was made from here: areas, inertias
// and moduli of the drawn outline with its fillets, mass = A rho, W = I / c. The tolerances are the rounding of the
// printed figures, and for W shapes that of the dimensions too, so a misread digit shows.

namespace {

using std::numbers::pi;

/// The area between a root fillet of radius r and its corner.
struct Fillet {
    explicit Fillet(double r)
        : A((1.0 - pi / 4.0) * r * r),
          c((10.0 - 3.0 * pi) / (3.0 * (4.0 - pi)) * r),
          I((1.0 - 5.0 * pi / 16.0) * std::pow(r, 4) - A * c * c)
    {}
    double A; ///< area
    double c; ///< centroid's distance from either side
    double I; ///< about the axis through its centroid along a side
};

struct Outline {
    double A, Iz, Zz, Iy, Zy;
};

/// An I with parallel flanges and four root fillets.
Outline outline_of_i(const Profile& p)
{
    const Fillet f(p.r);
    const double web = p.h - 2.0 * p.tf;
    const double y = p.h / 2.0 - p.tf - f.c;
    const double z = p.tw / 2.0 + f.c;
    return {.A = 2.0 * p.bf * p.tf + web * p.tw + 4.0 * f.A,
            .Iz = (p.bf * std::pow(p.h, 3) - (p.bf - p.tw) * std::pow(web, 3)) / 12.0 + 4.0 * (f.I + f.A * y * y),
            .Zz = p.bf * p.tf * (p.h - p.tf) + p.tw * web * web / 4.0 + 4.0 * f.A * y,
            .Iy = (2.0 * p.tf * std::pow(p.bf, 3) + web * std::pow(p.tw, 3)) / 12.0 + 4.0 * (f.I + f.A * z * z),
            .Zy = p.tf * p.bf * p.bf / 2.0 + web * p.tw * p.tw / 4.0 + 4.0 * f.A * z};
}

/// Torsion constant of a rolled I: its rectangles, their free ends, and the inscribed circle D at the junctions.
/// El Darwish & Johnston, "Torsion of structural shapes", J. Struct. Div. ASCE 91 (ST1), 1965; `alpha` is their
/// first formula as European makers use it (rounded) or as AISC Design Guide 9 does.
double torsion_of_i(const Profile& p, bool american)
{
    const double tf = p.tf, tw = p.tw, r = p.r;
    const double D = ((tf + r) * (tf + r) + tw * (r + tw / 4.0)) / (2.0 * r + tf);
    const double alpha = american ? -0.042 + 0.2204 * tw / tf + 0.1355 * r / tf - 0.0865 * r * tw / (tf * tf) -
                                        0.0725 * tw * tw / (tf * tf)
                                  : tw / tf * (0.145 + 0.1 * r / tf);
    return (2.0 * (p.bf - 0.63 * tf) * std::pow(tf, 3) + (p.h - 2.0 * tf) * std::pow(tw, 3)) / 3.0 +
           2.0 * alpha * std::pow(D, 4);
}

/// A channel with sloping flanges, integrated in thin strips along the flange.
struct UpnOutline {
    explicit UpnOutline(const Profile& p)
    {
        constexpr int n = 20000;
        const double dz = (p.bf - p.tw) / n;
        A = p.h * p.tw;
        double Sz = A * p.tw / 2.0;
        Iz = p.tw * std::pow(p.h, 3) / 12.0;
        Zz = p.tw * p.h * p.h / 4.0;
        J = p.h * std::pow(p.tw, 3) / 3.0;
        double Izz = p.h * std::pow(p.tw, 3) / 3.0;
        for (int i = 0; i < n; ++i) {
            const double z = p.tw + (i + 0.5) * dz;
            const double t = flange(p, z);
            A += 2.0 * t * dz;
            Sz += 2.0 * t * z * dz;
            Iz += 2.0 * (std::pow(p.h / 2.0, 3) - std::pow(p.h / 2.0 - t, 3)) / 3.0 * dz;
            Zz += t * (p.h - t) * dz;
            J += 2.0 * std::pow(t, 3) / 3.0 * dz;
            Izz += 2.0 * t * z * z * dz;
        }
        zc = Sz / A;
        Iy = Izz - A * zc * zc;
        Zy = plastic_modulus_z(p, dz);
    }
    /// About the axis that halves the area.
    double plastic_modulus_z(const Profile& p, double dz) const
    {
        double axis = std::min(A / (2.0 * p.h), p.tw);
        for (double area = p.h * axis; area < A / 2.0; axis += dz) area += 2.0 * flange(p, axis) * dz;
        const double right = std::min(axis, p.tw);
        double sum = p.h * right * (axis - right / 2.0) + p.h * (p.tw - right) * (p.tw - right) / 2.0;
        for (double z = p.tw + dz / 2.0; z < p.bf; z += dz) sum += 2.0 * flange(p, z) * std::abs(z - axis) * dz;
        return sum;
    }
    /// Thickness at z from the back of the web: slope, root fillet of radius tf, toe of radius tf / 2.
    static double flange(const Profile& p, double z)
    {
        const bool small = p.h < 30.5;
        const double slope = small ? 0.08 : 0.05;
        const double at = small ? p.bf / 2.0 : p.bf - (p.bf - p.tw) / 2.0; // where the thickness is tf
        const auto straight = [&](double where) { return p.tf + slope * (at - where); };
        const double n = std::sqrt(1.0 + slope * slope);
        const double root = p.tw + p.r, toe = p.bf - p.r / 2.0; // centres of the two arcs
        if (z < root - p.r * slope / n)
            return straight(root) + p.r * n - std::sqrt(p.r * p.r - (z - root) * (z - root));
        if (z > toe + p.r / 2.0 * slope / n)
            return straight(toe) - p.r / 2.0 * n + std::sqrt(p.r * p.r / 4.0 - (z - toe) * (z - toe));
        return straight(z);
    }
    double A, zc, Iz, Zz, Iy, Zy, J;
};

double error(double published, double expected) { return std::abs(published / expected - 1.0); }

constexpr std::array european_i{ProfileFamily::IPE, ProfileFamily::HEA, ProfileFamily::HEB, ProfileFamily::HEM};

} // namespace

TEST_CASE("IPE, HEA, HEB and HEM: A, I, W and Z are those of the outline with its fillets, to the printed digits")
{
    for (const ProfileFamily family : european_i)
        for (const Profile& p : profiles(family)) {
            CAPTURE(p.name);
            const Outline o = outline_of_i(p);
            CHECK(error(p.A, o.A) < 0.0025); // three figures
            for (const auto& [published, expected] : {std::pair(p.Iz, o.Iz),
                                                      {p.Wz, 2.0 * o.Iz / p.h},
                                                      {p.Zz, o.Zz},
                                                      {p.Iy, o.Iy},
                                                      {p.Wy, 2.0 * o.Iy / p.bf},
                                                      {p.Zy, o.Zy}})
                CHECK(error(published, expected) < 0.00055); // four figures
            CHECK(p.zc == p.bf / 2.0);
        }
}

TEST_CASE("IPE, HEA, HEB and HEM: J is El Darwish and Johnston's, mass is 7850 kg/m^3 A")
{
    for (const ProfileFamily family : european_i)
        for (const Profile& p : profiles(family)) {
            CAPTURE(p.name);
            CHECK(error(p.J, torsion_of_i(p, false)) < 0.003);
            CHECK(error(p.mass, 0.785 * outline_of_i(p).A) < 0.005); // two or three figures
        }
}

TEST_CASE("UPN: A, I and W are those of the outline with sloping flanges, mass is 7850 kg/m^3 A")
{
    for (const Profile& p : profiles(ProfileFamily::UPN)) {
        CAPTURE(p.name);
        const UpnOutline o(p);
        CHECK(error(p.A, o.A) < 0.003);
        CHECK(error(p.Iz, o.Iz) < 0.003);
        CHECK(error(p.Wz, 2.0 * o.Iz / p.h) < 0.0035);
        CHECK(error(p.Iy, o.Iy) < 0.0065);
        CHECK(error(p.Wy, o.Iy / (p.bf - o.zc)) < 0.006);
        CHECK(error(p.zc, o.zc) < 0.011); // UPN 400: 2.65 cm, from its outline 2.68 cm
        CHECK(error(p.mass, 0.785 * o.A) < 0.005);
        CHECK(error(p.J, o.J) < 0.035); // thin parts, the root's excess and the toes' lack left out
    }
}

TEST_CASE("UPN: the plastic moduli are those of the outline, but for the Zz of UPN 350, which is printed 2 % larger")
{
    for (const Profile& p : profiles(ProfileFamily::UPN)) {
        CAPTURE(p.name);
        CHECK(error(p.Zz, UpnOutline(p).Zz) < (p.name == "UPN350" ? 0.022 : 0.004));
        CHECK(error(p.Zy, UpnOutline(p).Zy) < 0.016);
    }
}

TEST_CASE("W: A, I, Z and J are those of the outline with fillets k - tf, S = 2 I / d, to three figures of each")
{
    for (const Profile& p : profiles(ProfileFamily::W)) {
        CAPTURE(p.name);
        const Outline o = outline_of_i(p);
        CHECK(error(p.A, o.A) < 0.0075);
        CHECK(error(p.Iz, o.Iz) < 0.0097);
        CHECK(error(p.Zz, o.Zz) < 0.0105);
        CHECK(error(p.Iy, o.Iy) < 0.0145);
        CHECK(error(p.Zy, o.Zy) < 0.0105);
        CHECK(error(p.Wz, 2.0 * p.Iz / p.h) < 0.0065);
        CHECK(error(p.Wy, 2.0 * p.Iy / p.bf) < 0.0075);
        CHECK(error(p.J, torsion_of_i(p, true)) < 0.0115);
    }
}

TEST_CASE("W: the name tells the weight, and 490 lb/ft^3 A is that weight")
{
    constexpr double kg_per_m = 0.45359237 / 0.3048; // in a lb/ft
    for (const Profile& p : profiles(ProfileFamily::W)) {
        CAPTURE(p.name);
        const std::string name(p.name);
        const auto x = name.find('X');
        const double weight = std::stod(name.substr(x + 1));
        CHECK(p.mass == doctest::Approx(weight * kg_per_m));
        CHECK(error(weight, 490.0 / 144.0 * p.A) < 0.0146);
    }
}

TEST_CASE("The tables are complete: 18 IPE, 24 each of HEA, HEB, HEM, 16 UPN and 289 W, no name twice")
{
    CHECK(profiles(ProfileFamily::IPE).size() == 18);
    CHECK(profiles(ProfileFamily::HEA).size() == 24);
    CHECK(profiles(ProfileFamily::HEB).size() == 24);
    CHECK(profiles(ProfileFamily::HEM).size() == 24);
    CHECK(profiles(ProfileFamily::UPN).size() == 16);
    CHECK(profiles(ProfileFamily::W).size() == 289);
    std::set<std::string_view> names;
    for (const Profile& p : profiles()) names.insert(p.name);
    CHECK(names.size() == profiles().size());
    CHECK(profiles().size() == 395);
}

TEST_CASE("Every profile is found by its own name, and stands with its family")
{
    for (const ProfileFamily family : profile_families())
        for (const Profile& p : profiles(family)) {
            CAPTURE(p.name);
            CHECK(find_profile(p.name) == &p);
            CHECK(p.name.starts_with(name(family)));
        }
}

TEST_CASE("Case, blanks, the multiplication sign and the standard's own HE 300 A make no difference")
{
    for (const char* text : {"IPE 300", "ipe300", " I p E 3 0 0\t"}) {
        CAPTURE(text);
        REQUIRE(find_profile(text) != nullptr);
        CHECK(find_profile(text)->name == "IPE300");
    }
    for (const char* text : {"w12x26", "W 12 x 26", "W12\u00d726"}) {
        CAPTURE(text);
        REQUIRE(find_profile(text) != nullptr);
        CHECK(find_profile(text)->name == "W12X26");
    }
    CHECK(find_profile("HE 1000 m") == find_profile("HEM1000"));
    CHECK(find_profile("W6x8.5")->A == 2.52);
}

TEST_CASE("A name that no table has finds nothing")
{
    for (const char* text : {"", " ", "IPE", "IPE301", "HE300", "HE", "HE300AA", "HEA", "W12X26W", "12X26", "\u00d7",
                             "IPE300IPE300IPE300IPE300IPE300"}) {
        CAPTURE(text);
        CHECK(find_profile(text) == nullptr);
    }
}
