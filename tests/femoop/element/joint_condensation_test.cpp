#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "femoop/element/beam.h"
#include "femoop/element/joint_condensation.h"
#include "femoop/element/member_properties.h"

using namespace femoop;

namespace {

constexpr double L = 3.7, EI = 5300.0;

/// Of the beam (v1, phi1, v2, phi2) with rigid joints.
StrainForm beam(double length = L) { return strain_form(Beam{.EI = EI}, length, BendingPlane::xy); }

Eigen::VectorXd joints(double v1, double phi1, double v2, double phi2) { return Eigen::Vector4d(v1, phi1, v2, phi2); }

} // namespace

TEST_SUITE("joint condensation")
{
    TEST_CASE("A beam hinged at one end has the stiffness 3 EI / L at the other")
    {
        const JointCondensation hinged(beam(), joints(rigid_joint, rigid_joint, rigid_joint, 0.0));
        const Eigen::MatrixXd K = hinged.stiffness();
        CHECK(K(1, 1) == doctest::Approx(3.0 * EI / L));
        CHECK(K(0, 1) == doctest::Approx(3.0 * EI / (L * L)));
        CHECK(K.row(3).norm() == 0.0);
        CHECK(hinged.free_motions().empty());
    }

    TEST_CASE("A hinge moves q L^2 / 8 to the clamped end")
    {
        const double q = 6.1;
        const JointCondensation hinged(beam(), joints(rigid_joint, rigid_joint, rigid_joint, 0.0));
        const Eigen::Vector4d clamped(q * L / 2.0, q * L * L / 12.0, q * L / 2.0, -q * L * L / 12.0);
        const Eigen::VectorXd f = hinged.end_forces(Eigen::Vector4d::Zero(), clamped);
        CHECK(f[0] == doctest::Approx(5.0 * q * L / 8.0));
        CHECK(f[1] == doctest::Approx(q * L * L / 8.0));
        CHECK(f[2] == doctest::Approx(3.0 * q * L / 8.0));
        CHECK(f[3] == 0.0);
    }

    TEST_CASE("A beam hinged at both ends has no stiffness at all, not even that of rounding")
    {
        for (int i = 1; i < 200; ++i) {
            const JointCondensation hinged(beam(0.0173 * i), joints(rigid_joint, 0.0, rigid_joint, 0.0));
            CHECK(hinged.stiffness().norm() == 0.0);
        }
    }

    TEST_CASE("A spring at one end leaves 4 EI / L (1 + 3 r) / (1 + 4 r), r = EI / c L, at the other")
    {
        const double c = 4100.0;
        const double r = EI / (c * L);
        const JointCondensation joined(beam(), joints(rigid_joint, rigid_joint, rigid_joint, c));
        CHECK(joined.stiffness()(1, 1) == doctest::Approx(4.0 * EI / L * (1.0 + 3.0 * r) / (1.0 + 4.0 * r)));
    }

    TEST_CASE("A spring far softer than its bar gives k c / (k + c) at both ends, to the last digits")
    {
        const double EA = 8.3e9, c = 0.71;
        const double k = EA / L;
        const JointCondensation joined(strain_form(Bar{.EA = EA}, L), Eigen::Vector2d(c, rigid_joint));
        const Eigen::Matrix2d K = joined.stiffness();
        const double expected = k * c / (k + c);
        CHECK(K(0, 0) == doctest::Approx(expected).epsilon(1e-15));
        CHECK(K(1, 1) == doctest::Approx(expected).epsilon(1e-15));
        CHECK(K(0, 1) == doctest::Approx(-expected).epsilon(1e-15));
        // Drawn by u = 0.03 the bar carries that stiffness times u.
        const Eigen::Vector2d nodes(0.5, 0.53);
        CHECK(joined.end_forces(nodes, Eigen::Vector2d::Zero())[1] == doctest::Approx(0.03 * expected).epsilon(1e-14));
    }

    TEST_CASE("What joints leave of a stiffness is symmetric to the last digit")
    {
        for (const double c : {0.31, 4100.0, 7.7e6})
            for (const double v : {rigid_joint, 53.0}) {
                CAPTURE(c);
                CAPTURE(v);
                const Eigen::MatrixXd S = JointCondensation(beam(), joints(v, c, rigid_joint, 0.3 * c)).strain_form().S;
                CHECK(S == S.transpose());
            }
    }

    TEST_CASE("A stiff beam between two soft springs sways with 2 c / L^2")
    {
        const double c = 3.1e-9; // E I / c L = 5e11: what the beam itself bends is lost beside 1
        const JointCondensation joined(beam(), joints(rigid_joint, c, rigid_joint, c));
        const Eigen::Matrix4d K = joined.stiffness();
        CHECK(K(2, 2) * L * L / (2.0 * c) == doctest::Approx(1.0).epsilon(1e-11));
        CHECK(K(1, 1) / c == doctest::Approx(1.0).epsilon(1e-11));
        CHECK(std::abs(K(1, 3)) < 1e-11 * c);
    }

    TEST_CASE("Ends on soft springs keep the bending of a stiff beam under its load")
    {
        const double q = 8.3e6, c = 1.1e-4; // E I / c L = 1.3e7
        const JointCondensation joined(beam(), joints(rigid_joint, c, rigid_joint, 2.0 * c));
        const Eigen::Vector4d clamped(q * L / 2.0, q * L * L / 12.0, q * L / 2.0, -q * L * L / 12.0);
        const Eigen::Vector4d ends = joined.end_displacements(Eigen::Vector4d::Zero(), clamped);
        // What is left of the clamped moment after the beam turned is what the spring takes.
        const Eigen::Vector4d member = Beam{.EI = EI}.stiffness(L) * ends + clamped;
        CHECK(std::abs(member[1] + c * ends[1]) < 1e-14 * clamped[1]);
        CHECK(std::abs(member[3] + 2.0 * c * ends[3]) < 1e-14 * clamped[1]);
    }

    TEST_CASE("Very stiff and very soft springs come to rigid joints and hinges")
    {
        const Eigen::Matrix4d k = Beam{.EI = EI}.stiffness(L);
        const auto at = [&](double c) {
            return JointCondensation(beam(), joints(rigid_joint, c, rigid_joint, rigid_joint)).stiffness();
        };
        CHECK((at(1e13) - k).norm() < 1e-6 * k.norm());
        CHECK((at(1e-6) - at(0.0)).norm() < 1e-6 * k.norm());
    }

    TEST_CASE("A beam released in v and rotation at one end and in v at the other is loose")
    {
        const JointCondensation loose(beam(), joints(0.0, rigid_joint, 0.0, rigid_joint));
        REQUIRE(loose.free_motions().size() == 1);
        const Eigen::VectorXd& mode = loose.free_motions().front().mode;
        CHECK(mode[0] == doctest::Approx(mode[2])); // it slides sideways as a whole
        CHECK(mode[1] == 0.0);
        CHECK(JointCondensation::work(loose.free_motions().front(), Eigen::Vector4d(2.0, 0.0, 3.0, 0.0)) ==
              doctest::Approx(5.0 * mode[0]));
    }

    TEST_CASE("The ends found from the nodes keep the joints in equilibrium")
    {
        const Eigen::Matrix4d k = Beam{.EI = EI}.stiffness(L);
        const Eigen::VectorXd c = joints(rigid_joint, 900.0, 350.0, 0.0);
        const JointCondensation joined(beam(), c);
        const Eigen::Vector4d nodes(0.011, -0.007, 0.023, 0.017);
        const Eigen::Vector4d fixed(3.1, 2.3, -1.7, 0.9);
        const Eigen::Vector4d ends = joined.end_displacements(nodes, fixed);
        const Eigen::Vector4d member = k * ends + fixed;
        const Eigen::Vector4d felt = joined.stiffness() * nodes + joined.end_forces(Eigen::Vector4d::Zero(), fixed);
        CHECK(ends[0] == nodes[0]);
        CHECK(member[1] == doctest::Approx(900.0 * (nodes[1] - ends[1])));
        CHECK(member[2] == doctest::Approx(350.0 * (nodes[2] - ends[2])));
        CHECK(member[3] == doctest::Approx(0.0).epsilon(1e-9));
        CHECK((member - felt).norm() < 1e-10 * felt.norm());
    }
}
