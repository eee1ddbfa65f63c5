#include "apps/mohr/exercise/words.h"

#include <cmath>
#include <numbers>

#include "femoop/model/quantity/number_text.h"
#include "ui/text/language_manner.h"

namespace mohr {

using enum Asked;
using ui::Message;
using ui::translatable;

namespace {

std::string text(double value) { return femoop::number_text(std::round(1e6 * value) / 1e6 + 0.0); }

std::string unit(const Exercise& e) { return is_strain(e.topic) ? "[10⁻⁶]" : is_inertia(e.topic) ? "[cm⁴]" : "[MPa]"; }

std::string_view normal_letter(const Exercise& e) { return is_strain(e.topic) ? "ε" : is_inertia(e.topic) ? "I" : "σ"; }
std::string_view shear_letter(const Exercise& e) { return is_strain(e.topic) ? "γ" : is_inertia(e.topic) ? "I" : "τ"; }

/// A symbol and its unit, which no language changes.
Message symbol(std::string name, const Exercise& e) { return Message(std::move(name) + " " + unit(e)); }

std::string with_letter(std::string_view letter, std::string_view index)
{
    return std::string(letter) + std::string(index);
}

Message on_plane(std::string name, const Exercise& e)
{
    return {translatable("{what} at θ = {angle}° {unit}"),
            {{"what", std::move(name)}, {"angle", text(e.angle)}, {"unit", unit(e)}}};
}

Message on_oblique(std::string name, const Exercise& e)
{
    return {translatable("{what} on the plane whose normal is ({x}; {y}; {z}) [MPa]"),
            {{"what", std::move(name)}, {"x", text(e.normal[0])}, {"y", text(e.normal[1])}, {"z", text(e.normal[2])}}};
}

Message factor(std::string criterion, std::string strengths)
{
    return {translatable("safety factor of {criterion}, {strengths}"),
            {{"criterion", std::move(criterion)}, {"strengths", std::move(strengths)}}};
}

Message by_hooke(std::string name, const Exercise& e)
{
    return {translatable("{what} [MPa], E = {E} GPa, ν = {nu}, free surface"),
            {{"what", std::move(name)}, {"E", text(e.E)}, {"nu", text(e.nu)}}};
}

Message third(const Exercise& e)
{
    if (is_strain(e.topic)) return {translatable("εz of the free surface [10⁻⁶], ν = {nu}"), {{"nu", text(e.nu)}}};
    return {translatable("σz that holds the strain across the plane at 0 [MPa], ν = {nu}"), {{"nu", text(e.nu)}}};
}

Message largest_shear(const Exercise& e)
{
    if (e.topic == ExerciseTopic::PlaneStrain) return translatable("largest shear in space [MPa]");
    return e.topic == ExerciseTopic::Space ? Message(translatable("largest shear [MPa]"))
                                           : Message(translatable("largest shear in space [MPa], σz = 0"));
}

Message sentence(Asked asked, const Exercise& e)
{
    const std::string_view normal = normal_letter(e), shear = shear_letter(e);
    const auto& k = e.strength;
    switch (asked) {
    case StrainX: return symbol("εx", e);
    case StrainY: return symbol("εy", e);
    case ShearStrain: return symbol("γxy", e);
    case Centre:
        return e.topic == ExerciseTopic::Space ? Message(translatable("centre C of the circle in the plane x y [MPa]"))
                                               : Message(translatable("centre C {unit}"), {{"unit", unit(e)}});
    case Radius: return {translatable("radius R {unit}"), {{"unit", unit(e)}}};
    case First: return symbol(with_letter(normal, "1"), e);
    case Second: return symbol(with_letter(normal, "2"), e);
    case Direction:
        return {translatable("from x to the direction of {first}, θp [°]"), {{"first", with_letter(normal, "1")}}};
    case Normal: return on_plane(with_letter(normal, "x′"), e);
    case Shear: return on_plane(with_letter(shear, "x′y′"), e);
    case LargestShearStrain: return translatable("largest shear strain in the plane, γmax [10⁻⁶]");
    case Third: return third(e);
    case StressFirst: return by_hooke("σ1", e);
    case StressSecond: return by_hooke("σ2", e);
    case I1: return "I1 [MPa]";
    case I2: return "I2 [MPa²]";
    case I3: return "I3 [MPa³]";
    case SpaceFirst: return "σ1 [MPa]";
    case SpaceSecond: return "σ2 [MPa]";
    case SpaceThird: return "σ3 [MPa]";
    case LargestShear: return largest_shear(e);
    case Mean: return translatable("mean normal stress [MPa]");
    case VonMises: return translatable("von Mises' stress [MPa]");
    case SpaceNormal: return on_oblique("σ", e);
    case SpaceShear: return on_oblique("τ", e);
    case FactorTresca: return factor("Tresca", "fy = " + text(k.fy) + " MPa");
    case FactorVonMises: return factor("von Mises", "fy = " + text(k.fy) + " MPa");
    case FactorRankine: return factor("Rankine", "ft = " + text(k.ft) + " MPa, fc = " + text(k.fc) + " MPa");
    case FactorCoulomb:
        return factor("Mohr–Coulomb", "c = " + text(k.c) + " MPa, φ = " + text(k.phi * 180.0 / std::numbers::pi) + "°");
    }
    return {};
}

} // namespace

std::string question(Asked asked, const Exercise& e, const ui::Catalogue& tr)
{
    std::string words = tr(sentence(asked, e));
    if (ui::decimal_mark(tr.language()) == ui::DecimalMark::Point) return words;
    const auto is_digit = [&](std::size_t i) { return i < words.size() && words[i] >= '0' && words[i] <= '9'; };
    for (std::size_t i = 1; i < words.size(); ++i)
        if (words[i] == '.' && is_digit(i - 1) && is_digit(i + 1)) words[i] = ',';
    return words;
}

std::string_view hint(Asked asked, const Exercise& e)
{
    const bool is_delta = e.gauges == femoop::mohr::rosette_60_degrees;
    switch (asked) {
    case StrainX: return translatable("one gauge measures along x");
    case StrainY:
        return is_delta ? translatable("εx + εy is two thirds of the sum of the three readings")
                        : translatable("one gauge measures along y");
    case ShearStrain:
        return is_delta ? translatable("γ is the difference of both inclined gauges, times 2/√3")
                        : translatable("the gauge between both axes measures half the sum plus γ/2");
    case Centre:
        return is_inertia(e.topic) ? translatable("add both moments and halve")
                                   : translatable("add both normal components and halve");
    case Radius:
        return is_inertia(e.topic)
                   ? translatable("in the triangle of C, X and the axis: the hypotenuse of the half difference and Ixy")
                   : translatable("in the triangle of centre, face x and the axis: "
                                  "the hypotenuse of the half difference and the shear");
    case First: return translatable("from the centre go by the radius to the right");
    case Second: return translatable("from the centre go by the radius to the left");
    case Direction: return translatable("find the angle between the radius to X and the axis, and halve it");
    case Normal:
        return is_inertia(e.topic) ? translatable("turn the radius to X by 2θ and read the moment")
                                   : translatable("turn the radius to X by 2θ and read the normal component");
    case Shear:
        return is_inertia(e.topic)
                   ? translatable("turn the radius to X by 2θ and read the product: the axis counts −Ixy")
                   : translatable("turn the radius to X by 2θ and read the shear");
    case LargestShearStrain: return translatable("the circle counts γ/2, so γmax is its diameter");
    case Third:
        return is_strain(e.topic) ? translatable("on a free surface σz = 0: εz = −ν/(1 − ν) (ε1 + ε2)")
                                  : translatable("εz = 0 asks for σz = ν (σx + σy)");
    case StressFirst:
    case StressSecond:
        return translatable(
            "Hooke's law of plane stress: each stress is E/(1 − ν²) times its strain plus ν times the other");
    case I1: return translatable("I1 is the sum of the three normal stresses");
    case I2: return translatable("I2 is the sum of the three minors: σx σy − τxy², and so on round");
    case I3: return translatable("I3 is the determinant of the tensor");
    case SpaceFirst:
    case SpaceSecond:
    case SpaceThird:
        return e.difficulty == Difficulty::Hard
                   ? translatable("find the roots of σ³ − I1 σ² + I2 σ − I3 = 0; a whole one divides I3")
                   : translatable("z is principal: put its stress in order with centre plus and less radius");
    case LargestShear:
        return translatable("put the three principal stresses in order and take the radius of the largest circle");
    case Mean: return translatable("the mean of the three principal stresses, which is I1/3");
    case VonMises:
        return translatable("the root of half the sum of the squares of the differences of principal stresses");
    case SpaceNormal:
        return translatable("multiply the tensor by the unit normal, and take the traction's part along the normal");
    case SpaceShear: return translatable("by Pythagoras from the traction and its part along the normal");
    case FactorTresca: return translatable("fy over the difference of the extreme of the three principal stresses");
    case FactorVonMises: return translatable("fy over von Mises' stress");
    case FactorRankine:
        return translatable(
            "compare the largest tension with ft and the largest compression with fc; the smaller factor governs");
    case FactorCoulomb: return translatable("the largest circle, grown, touches the line: c cos φ over R + C sin φ");
    }
    return "";
}

} // namespace mohr
