#include "apps/mohr/exercise/exercise.h"

#include <algorithm>
#include <cmath>

#include "apps/mohr/document/degree.h"
#include "femoop/methods/dice.h"
#include "femoop/methods/mohr/state.h"
#include "femoop/model/quantity/number_text.h"

namespace mohr {

namespace fm = femoop::mohr;
using femoop::Dice;

namespace {

/// Half the difference of the normal components, the shear and the radius are whole.
fm::PlaneState whole_state(Dice& dice)
{
    constexpr std::array<std::array<double, 2>, 4> triples{{{3, 4}, {4, 3}, {5, 12}, {8, 6}}};
    const auto& triple = dice.pick(triples);
    const double scale = dice.roll(5, 10, 5), centre = dice.roll(-40, 40, 10);
    const double a = dice.sign() * scale * triple[0], b = dice.sign() * scale * triple[1];
    return {centre + a, centre - a, b};
}

fm::PlaneState any_state(Dice& dice)
{
    const double x = dice.roll(-90, 90, 5);
    return {x, x + dice.sign() * dice.roll(20, 110, 5), dice.sign() * dice.roll(15, 70, 5)};
}

/// Both principal values of one sign, the smaller one `share` of the radius and more away from 0.
fm::PlaneState one_sided_state(Dice& dice, double sign, double share = 0.0)
{
    const fm::PlaneState turned = any_state(dice);
    const double radius = fm::circle(turned).radius;
    const double centre = sign * (std::ceil((1.0 + share) * radius / 10.0) * 10.0 + dice.roll(20, 60, 10));
    const double half = 0.5 * (turned.x - turned.y);
    return {centre + half, centre - half, turned.xy};
}

fm::PlaneState times(double factor, const fm::PlaneState& s) { return {factor * s.x, factor * s.y, factor * s.xy}; }

void add(Exercise& e, std::initializer_list<Asked> more) { e.asked.insert(e.asked.end(), more); }

using enum Asked;

void draw_plane_stress(Exercise& e, Dice& dice)
{
    add(e, {Centre, Radius, First, Second});
    switch (e.difficulty) {
    case Difficulty::Easy: e.state = whole_state(dice); return;
    case Difficulty::Medium: e.state = any_state(dice); break;
    case Difficulty::Hard: e.state = one_sided_state(dice, dice.sign()); break;
    }
    e.angle = dice.sign() * dice.roll(10, 60, 5);
    add(e, {Direction, Normal, Shear});
    if (e.difficulty == Difficulty::Hard) add(e, {LargestShear});
}

void draw_plane_strain(Exercise& e, Dice& dice)
{
    e.nu = dice.pick(std::array{0.2, 0.25});
    add(e, {Centre, Radius, First, Second});
    switch (e.difficulty) {
    case Difficulty::Easy: e.state = whole_state(dice); break;
    case Difficulty::Medium: e.state = any_state(dice); break;
    case Difficulty::Hard: e.state = one_sided_state(dice, dice.sign(), 1.0); break;
    }
    if (e.difficulty != Difficulty::Easy) add(e, {Direction});
    add(e, {Third});
    if (e.difficulty == Difficulty::Hard) add(e, {LargestShear});
}

void draw_strain(Exercise& e, Dice& dice)
{
    e.E = dice.pick(std::array{70.0, 100.0, 200.0, 210.0});
    e.nu = dice.pick(std::array{0.25, 0.3, 0.33});
    add(e, {Centre, Radius, First, Second});
    e.state = times(10.0, e.difficulty == Difficulty::Easy ? whole_state(dice) : any_state(dice));
    if (e.difficulty == Difficulty::Easy) return;
    e.angle = dice.sign() * dice.roll(10, 60, 5);
    add(e, {Direction, Normal, Shear, LargestShearStrain});
    if (e.difficulty == Difficulty::Hard) add(e, {Third, StressFirst, StressSecond});
}

void draw_rosette(Exercise& e, Dice& dice)
{
    e.E = dice.pick(std::array{70.0, 200.0, 210.0});
    e.nu = dice.pick(std::array{0.25, 0.3});
    const bool is_delta = e.difficulty == Difficulty::Hard;
    e.gauges = is_delta ? fm::rosette_60_degrees : fm::rosette_45_degrees;
    const fm::PlaneState meant = times(10.0, e.difficulty == Difficulty::Easy ? whole_state(dice) : any_state(dice));
    fm::Rosette rosette;
    for (std::size_t i = 0; i < 3; ++i) {
        rosette.angles[i] = e.gauges[i] * degree;
        rosette.readings[i] = e.readings[i] = std::round(fm::rotated(meant, rosette.angles[i]).x) + 0.0;
    }
    e.state = fm::strain(rosette);
    add(e, {StrainX, StrainY, ShearStrain, Centre, Radius, First, Second});
    if (e.difficulty != Difficulty::Easy) add(e, {Direction});
    if (is_delta) add(e, {StressFirst, StressSecond});
}

void draw_inertia(Exercise& e, Dice& dice)
{
    e.state = times(10.0, e.difficulty == Difficulty::Easy ? whole_state(dice) : any_state(dice));
    const auto [centre, radius] = fm::circle(e.state);
    const double up = 100.0 * std::ceil(1.3 * radius / 100.0) - std::min(centre, 0.0) + dice.roll(0, 500, 100);
    e.state.x += up;
    e.state.y += up;
    add(e, {Centre, Radius, First, Second});
    if (e.difficulty != Difficulty::Easy) add(e, {Direction});
    if (e.difficulty != Difficulty::Hard) return;
    e.angle = dice.sign() * dice.roll(10, 60, 5);
    add(e, {Normal, Shear});
}

/// Principal values three times whole numbers in directions with thirds: every component is whole.
fm::SpaceState whole_space_state(Dice& dice)
{
    const Eigen::Matrix3d Q = (Eigen::Matrix3d() << 2, -2, 1, 1, 2, 2, 2, 1, -2).finished() / 3.0;
    const double second = 9.0 * dice.roll(-4, 4);
    const Eigen::Vector3d values(second + 9.0 * dice.roll(2, 7), second, second - 9.0 * dice.roll(1, 6));
    fm::SpaceState s = fm::from_tensor(Q * values.asDiagonal() * Q.transpose());
    for (double fm::SpaceState::*part : {&fm::SpaceState::x, &fm::SpaceState::y, &fm::SpaceState::z,
                                         &fm::SpaceState::xy, &fm::SpaceState::yz, &fm::SpaceState::zx})
        s.*part = std::round(s.*part) + 0.0;
    return s;
}

void draw_space(Exercise& e, Dice& dice)
{
    if (e.difficulty == Difficulty::Hard) {
        e.space = whole_space_state(dice);
        e.normal = dice.pick(std::array<std::array<double, 3>, 4>{{{1, 2, 2}, {2, 3, 6}, {2, 1, 2}, {1, 4, 8}}});
        return add(e, {I1, I2, I3, SpaceFirst, SpaceSecond, SpaceThird, LargestShear, SpaceNormal, SpaceShear});
    }
    e.state = e.difficulty == Difficulty::Easy ? whole_state(dice) : any_state(dice);
    e.space = fm::in_space(e.state, dice.sign() * dice.roll(25, 95, 10));
    add(e, {Centre, Radius, SpaceFirst, SpaceSecond, SpaceThird, LargestShear});
    if (e.difficulty == Difficulty::Medium) add(e, {Mean, VonMises});
}

void draw_criteria(Exercise& e, Dice& dice)
{
    e.strength.fy = dice.pick(std::array{235.0, 250.0, 275.0, 345.0});
    e.strength.ft = dice.roll(20, 50, 5);
    e.strength.fc = dice.roll(100, 200, 20);
    e.strength.c = dice.roll(10, 40, 5);
    e.strength.phi = dice.roll(20, 40, 5) * degree;
    switch (e.difficulty) {
    case Difficulty::Easy: // one stress of each sign, or both positive: the third one counts or not
        e.state = dice.sign() > 0.0 ? whole_state(dice) : one_sided_state(dice, 1.0);
        return add(e, {First, Second, FactorTresca});
    case Difficulty::Medium: e.state = any_state(dice); return add(e, {First, Second, VonMises, FactorVonMises});
    case Difficulty::Hard: break;
    }
    e.state = any_state(dice);
    const auto [centre, radius] = fm::circle(e.state);
    const double shift = -std::round(centre / 5.0) * 5.0 - dice.roll(5, 30, 5); // some tension, more compression
    e.state.x += shift;
    e.state.y += shift;
    add(e, {First, Second, FactorRankine, FactorCoulomb});
}

Subject subject_of(ExerciseTopic topic)
{
    switch (topic) {
    case ExerciseTopic::PlaneStrain: return Subject::PlaneStrain;
    case ExerciseTopic::Strain: return Subject::Strain;
    case ExerciseTopic::Rosette: return Subject::Rosette;
    case ExerciseTopic::Inertia: return Subject::Inertia;
    case ExerciseTopic::Space: return Subject::SpaceStress;
    case ExerciseTopic::PlaneStress:
    case ExerciseTopic::Criteria: break;
    }
    return Subject::PlaneStress;
}

/// The numbers of the state as they are given.
std::vector<double> given(const Exercise& e)
{
    const auto& s = e.space;
    switch (e.topic) {
    case ExerciseTopic::Space: return {s.x, s.y, s.z, s.xy, s.yz, s.zx};
    case ExerciseTopic::Rosette:
        return {e.gauges[0], e.gauges[1], e.gauges[2], e.readings[0], e.readings[1], e.readings[2]};
    case ExerciseTopic::Strain: return {e.state.x, e.state.y, fm::given_shear(fm::Kind::Strain, e.state.xy)};
    case ExerciseTopic::Inertia: return {e.state.x, e.state.y, fm::given_shear(fm::Kind::Inertia, e.state.xy)};
    default: return {e.state.x, e.state.y, e.state.xy};
    }
}

} // namespace

bool is_inertia(ExerciseTopic topic) { return topic == ExerciseTopic::Inertia; }

bool is_strain(ExerciseTopic topic) { return topic == ExerciseTopic::Strain || topic == ExerciseTopic::Rosette; }

Exercise exercise(ExerciseTopic topic, Difficulty difficulty, std::uint32_t seed)
{
    Dice dice(3 * seed + static_cast<std::uint32_t>(difficulty));
    dice.roll(0, 9);
    Exercise e{.topic = topic, .difficulty = difficulty, .seed = seed};
    switch (topic) {
    case ExerciseTopic::PlaneStress: draw_plane_stress(e, dice); break;
    case ExerciseTopic::PlaneStrain: draw_plane_strain(e, dice); break;
    case ExerciseTopic::Strain: draw_strain(e, dice); break;
    case ExerciseTopic::Rosette: draw_rosette(e, dice); break;
    case ExerciseTopic::Inertia: draw_inertia(e, dice); break;
    case ExerciseTopic::Space: draw_space(e, dice); break;
    case ExerciseTopic::Criteria: draw_criteria(e, dice); break;
    }
    return e;
}

Document document_of(const Exercise& e)
{
    Document document = textbook_state();
    document.subject = subject_of(e.topic);
    document.angle = 0.0;
    const std::string unit = is_strain(e.topic) ? "" : e.topic == ExerciseTopic::Inertia ? " cm^4" : " MPa";
    document.state().clear();
    for (const double value : given(e)) document.state().push_back(femoop::number_text(value + 0.0) + unit);
    if (e.E > 0.0) document.elasticity[0] = femoop::number_text(e.E) + " GPa";
    if (e.nu > 0.0) document.elasticity[1] = femoop::number_text(e.nu);
    if (e.normal != std::array<double, 3>{}) document.normal = e.normal;
    return document;
}

} // namespace mohr
