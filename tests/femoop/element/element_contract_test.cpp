// What every member of every model must hold to; a new kind of member joins by one line in `members()`.
#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "femoop/element/member_element.h"

using namespace femoop;

namespace {

constexpr double L = 3.7;

MemberProperties properties(double shear, double foundation)
{
    return {.axial = {8.3e5},
            .torsion = {950.0},
            .xy = {.EI = 5300.0, .shear_flexibility = shear, .foundation = foundation},
            .xz = {.EI = 2100.0, .shear_flexibility = 1.7 * shear}};
}

/// 1.6 times as deep at its second end.
MemberProperties tapered_properties(double shear)
{
    constexpr double growth = 0.6 / L;
    MemberProperties tapered = properties(shear, 0.0);
    tapered.axial.taper = growth;
    tapered.xy.taper = {.depth = growth,
                        .area = growth,
                        .shear_area = growth,
                        .inertia = {3.0 * growth, 3.0 * growth * growth, growth * growth * growth},
                        .longest_piece = 1.0 / growth / 6.0};
    return tapered;
}

struct Case {
    std::string name;
    MemberProperties properties;
    MemberEndConditions end_conditions;
    int lost_forces = 0; ///< section forces that releases take away
    bool on_foundation = false;
};

std::vector<Case> members()
{
    std::vector<Case> cases{
        {.name = "Euler-Bernoulli", .properties = properties(0.0, 0.0), .end_conditions = {}},
        {.name = "Timoshenko", .properties = properties(1.0 / 910.0, 0.0), .end_conditions = {}},
        {.name = "hinged at its end", .properties = properties(0.0, 0.0), .end_conditions = {}, .lost_forces = 1},
        {.name = "semi-rigid", .properties = properties(1.0 / 910.0, 0.0), .end_conditions = {}},
        {.name = "with rigid arms", .properties = properties(0.0, 0.0), .end_conditions = {}},
        {.name = "on a foundation",
         .properties = properties(0.0, 620.0),
         .end_conditions = {},
         .lost_forces = 0,
         .on_foundation = true},
        {.name = "tapered", .properties = tapered_properties(1.0 / 910.0), .end_conditions = {}}};
    cases[2].end_conditions.has_flexible_joint = true;
    cases[2].end_conditions.joints[1][index(LocalAxis::rz)] = 0.0;
    cases[3].end_conditions.has_flexible_joint = true;
    cases[3].end_conditions.joints[0][index(LocalAxis::rz)] = 4100.0;
    cases[3].end_conditions.joints[1][index(LocalAxis::rx)] = 370.0;
    cases[4].end_conditions.has_offset = true;
    cases[4].end_conditions.offsets = {Eigen::Vector3d(0.2, 0.0, 0.0), Eigen::Vector3d(-0.1, 0.0, 0.0)};
    return cases;
}

/// A unit vector for one of ux uy uz rx ry rz: as a shift, and as a turn.
Eigen::Vector3d unit_shift(int dof)
{
    return dof < 3 ? Eigen::Vector3d(Eigen::Vector3d::Unit(dof)) : Eigen::Vector3d(0, 0, 0);
}
Eigen::Vector3d unit_turn(int dof)
{
    return dof < 3 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(Eigen::Vector3d::Unit(dof - 3));
}

/// A skew member of length L: in the xy plane unless the model is spatial.
MemberGeometry skew_geometry(AnalysisKind kind, double turn = 0.0)
{
    const double angle = 0.61 + turn;
    Eigen::Vector3d x(std::cos(angle), std::sin(angle), 0.0);
    Eigen::Vector3d y(-std::sin(angle), std::cos(angle), 0.0);
    if (kind == AnalysisKind::Grillage) y = Eigen::Vector3d::UnitZ();
    if (is_3d(kind)) {
        const Eigen::AngleAxisd tilt(0.43, Eigen::Vector3d(0.3, -0.5, 0.8).normalized());
        x = tilt * x;
        y = tilt * y;
    }
    MemberGeometry geometry{.axes = {}, .start = {1.1, 2.3, 0.0}, .end = {}, .length = L};
    geometry.axes << x.transpose(), y.transpose(), x.cross(y).transpose();
    geometry.end = geometry.start + L * x;
    return geometry;
}

template <AnalysisKind kind> struct Rig {
    Case the_case;
    MemberGeometry geometry = skew_geometry(kind);
    MemberElement<kind> element{the_case.properties, geometry, &the_case.end_conditions};
};

/// The displacements of both nodes in a rigid motion of space: a translation and a rotation about the origin.
template <AnalysisKind kind>
Eigen::VectorXd rigid_motion(const MemberGeometry& geometry, const MemberEndConditions& end_conditions,
                             const Eigen::Vector3d& shift, const Eigen::Vector3d& turn)
{
    constexpr int n = MemberElement<kind>::n;
    Eigen::VectorXd u(2 * n);
    for (int end = 0; end < 2; ++end) {
        Eigen::Vector3d at = end == 0 ? geometry.start : geometry.end;
        if (end_conditions.has_offset) at -= end_conditions.offsets[static_cast<std::size_t>(end)];
        const Eigen::Vector3d moved = shift + turn.cross(at);
        for (int i = 0; i < n; ++i) {
            const auto g = static_cast<int>(index(AnalysisModel<kind>::global[static_cast<std::size_t>(i)]));
            u[end * n + i] = g < 3 ? moved[g] : turn[g - 3];
        }
    }
    return u;
}

template <AnalysisKind kind>
std::vector<Eigen::VectorXd> rigid_motions(const MemberGeometry& geometry, const MemberEndConditions& e)
{
    std::vector<Eigen::VectorXd> motions;
    for (const Dof dof : all_dofs) {
        const bool in_plane = dof == Dof::ux || dof == Dof::uy || dof == Dof::rz;
        const bool out_of_plane = dof == Dof::uz || dof == Dof::rx || dof == Dof::ry;
        if ((kind == AnalysisKind::Frame2d || kind == AnalysisKind::Truss2d) && !in_plane) continue;
        if (kind == AnalysisKind::Grillage && !out_of_plane) continue;
        const auto i = static_cast<int>(index(dof));
        motions.push_back(rigid_motion<kind>(geometry, e, unit_shift(i), unit_turn(i)));
    }
    return motions;
}

int rank(const Eigen::MatrixXd& K)
{
    const Eigen::VectorXd scale = K.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * K * scale.asDiagonal()).eigenvalues();
    return static_cast<int>((values.array() > 1e-10).count());
}

/// Calls check(kind constant, case) for every member that the model can have.
template <class Check> void for_every_member(Check&& check)
{
    for (const Case& each : members())
        for (const AnalysisKind kind : {AnalysisKind::Truss2d, AnalysisKind::Frame2d, AnalysisKind::Grillage,
                                        AnalysisKind::Truss3d, AnalysisKind::Frame3d}) {
            if (is_truss(kind) && each.name != "Euler-Bernoulli" && each.name != "with rigid arms") continue;
            if (is_truss(kind) && each.end_conditions.has_offset) continue;
            CAPTURE(each.name);
            CAPTURE(name(kind));
            with_model(kind, [&](auto constant) { check(constant, each); });
        }
}

SpanLoading some_load(const MemberProperties& p)
{
    const std::vector<SpanLoad> loads{
        {.axis = LocalAxis::y, .from = 0.4, .to = 2.9, .start = -3.0, .end = -7.0},
        {.kind = SpanLoad::Kind::Point, .axis = LocalAxis::x, .from = 1.9, .to = 1.9, .start = 5.0},
        {.kind = SpanLoad::Kind::Point, .axis = LocalAxis::z, .from = 2.2, .to = 2.2, .start = -2.6}};
    SpanLoading loading;
    const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads}}};
    loading.assign(L, terms, p.xy.longest_piece());
    return loading;
}

} // namespace

TEST_SUITE("element contract")
{
    TEST_CASE("The stiffness of every member is symmetric")
    {
        for_every_member([](auto kind, const Case& each) {
            const Eigen::MatrixXd K = Rig<decltype(kind)::value>{each}.element.stiffness();
            CHECK((K - K.transpose()).norm() <= 1e-13 * K.norm());
        });
    }

    TEST_CASE("Its rank is the number of section forces that the member has")
    {
        for_every_member([](auto kind, const Case& each) {
            constexpr AnalysisKind k = decltype(kind)::value;
            if (each.on_foundation) return;
            const int forces = is_truss(k) ? 1 : (k == AnalysisKind::Frame3d ? 6 : 3);
            CHECK(rank(Rig<k>{each}.element.stiffness()) == forces - each.lost_forces);
        });
    }

    TEST_CASE("A rigid motion strains nothing")
    {
        for_every_member([](auto kind, const Case& each) {
            constexpr AnalysisKind k = decltype(kind)::value;
            if (each.on_foundation) return;
            const Rig<k> rig{each};
            const Eigen::MatrixXd K = rig.element.stiffness();
            for (const Eigen::VectorXd& u : rigid_motions<k>(rig.geometry, each.end_conditions))
                CHECK((K * u).norm() <= 1e-11 * K.norm() * u.norm());
        });
    }

    TEST_CASE("Turned axes keep the energy")
    {
        for_every_member([](auto kind, const Case& each) {
            constexpr AnalysisKind k = decltype(kind)::value;
            if (each.end_conditions.has_offset) return; // the arms would have to turn too
            const double turn = 0.77;
            const Rig<k> before{each};
            const Rig<k> after{.the_case = each, .geometry = skew_geometry(k, turn)};
            if (is_3d(k)) return; // the tilt of the frame does not commute with this turn
            constexpr int n = MemberElement<k>::n;
            Eigen::MatrixXd turned = Eigen::MatrixXd::Identity(2 * n, 2 * n);
            const Eigen::Matrix2d R = Eigen::Rotation2Dd(turn).toRotationMatrix();
            const int first = k == AnalysisKind::Grillage ? 1 : 0; // rx ry turn like ux uy
            for (const int end : {0, 1}) turned.block<2, 2>(end * n + first, end * n + first) = R;
            const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(2 * n, -0.3, 0.9);
            const double energy = u.dot(before.element.stiffness() * u);
            const Eigen::VectorXd v = turned * u;
            CHECK(v.dot(after.element.stiffness() * v) == doctest::Approx(energy).epsilon(1e-11));
        });
    }

    TEST_CASE("Fixed-end forces keep the resultant of the loads")
    {
        for_every_member([](auto kind, const Case& each) {
            constexpr AnalysisKind k = decltype(kind)::value;
            if (each.on_foundation) return; // which takes its part
            const Rig<k> rig{each};
            const Eigen::VectorXd f = rig.element.fixed_end_forces(some_load(each.properties));
            // Virtual work of loads and of fixed-end forces in every rigid motion add up to nothing.
            const double Q = -5.0 * 2.5;                                           // trapezoid 3 to 7 over 2.5
            const double at = 0.4 + 2.5 * (3.0 + 2.0 * 7.0) / (3.0 * (3.0 + 7.0)); // its centroid
            for (const Dof dof : all_dofs) {
                const auto i = static_cast<int>(index(dof));
                const Eigen::Vector3d shift = unit_shift(i);
                const Eigen::Vector3d turn = unit_turn(i);
                if ((k == AnalysisKind::Frame2d || k == AnalysisKind::Truss2d) &&
                    !dofs(AnalysisKind::Frame2d).contains(dof))
                    continue;
                if (k == AnalysisKind::Grillage && !dofs(k).contains(dof)) continue;
                if (is_truss(k) && i >= 3) continue; // a truss node cannot follow, but its forces do: see translations
                const auto moved = [&](double x) {
                    return Eigen::Vector3d(shift +
                                           turn.cross(rig.geometry.start + x * rig.geometry.axes.row(0).transpose()));
                };
                double work = Q * rig.geometry.axes.row(1).dot(moved(at));
                if (k != AnalysisKind::Grillage) work += 5.0 * rig.geometry.axes.row(0).dot(moved(1.9));
                if (is_3d(k)) work += -2.6 * rig.geometry.axes.row(2).dot(moved(2.2));
                CHECK(f.dot(rigid_motion<k>(rig.geometry, each.end_conditions, shift, turn)) ==
                      doctest::Approx(-work).epsilon(1e-10));
            }
        });
    }
}
