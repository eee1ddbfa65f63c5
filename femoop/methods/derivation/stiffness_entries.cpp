#include "femoop/methods/derivation/stiffness_entries.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "femoop/element/analysis_model.h"

namespace femoop::derivation {

namespace {

using Numbers = std::vector<NamedNumber>;

bool has_stiffness(double value) { return value > 0.0 && std::isfinite(value); }

/// A joint of a member's end along one of its axes, and what its spring is called.
struct Joint {
    double k = rigid_joint;
    std::string name; ///< "k(A.rz')"

    bool is_released() const { return k == 0.0; }
    bool is_spring() const { return k > 0.0 && std::isfinite(k); }
    double flexibility() const { return is_spring() ? 1.0 / k : 0.0; }
    std::string addend() const { return is_spring() ? " + 1/" + name : ""; }
};

Joint joint(const StiffMember& member, std::size_t end, LocalAxis axis)
{
    return {member.joints[end][index(axis)], "k(" + member.row_name(end, axis) + ")"};
}

/// "6 EI r1 (2 + r2)/(L^2 D)" of its factors above and below the line.
std::string quotient(const std::string& above, const std::string& below, const std::string& more = "")
{
    return more.empty() ? above + "/" + below : above + "/(" + below + " " + more + ")";
}

/// Along the axis or about it: the springs at both ends in series with the member.
void add_bar(Numbers& numbers, const StiffMember& member, LocalAxis axis, const Bar& bar, const std::string& EA)
{
    const Joint first = joint(member, 0, axis), second = joint(member, 1, axis);
    if (!has_stiffness(bar.EA) || first.is_released() || second.is_released()) return;
    const bool is_tapered = bar.taper != 0.0, is_sprung = first.is_spring() || second.is_spring();
    const std::string own = is_tapered ? "∫ dx/" + EA : "L/" + EA;
    const double stiffness = 1.0 / (bar.flexibility(member.length) + first.flexibility() + second.flexibility());
    if (is_sprung) numbers.push_back({"1/(" + own + first.addend() + second.addend() + ")", stiffness});
    else numbers.push_back({is_tapered ? "1/" + own : EA + "/L", stiffness});
}

/// Products of sin, cos, sinh and cosh of x = beta L; all of them divided by e^2x where x is not small.
struct FoundationWaves {
    double sum, difference, squares;         ///< sinh cosh + sin cos, sinh cosh - sin cos, sinh^2 + sin^2
    double far_sum, far_difference, product; ///< cosh sin + sinh cos, cosh sin - sinh cos, sinh sin
    double D;                                ///< sinh^2 - sin^2
};

/// The sum of r^k x^(4k+3)/(4k+3)!: of differences in which all but their ends would cancel. \pre x <= 2
double cubic_series(double x, double r)
{
    double term = x * x * x / 6.0, sum = 0.0;
    for (double n = 3.0; n < 32.0; n += 4.0) {
        sum += term;
        term *= r * x * x * x * x / ((n + 1.0) * (n + 2.0) * (n + 3.0) * (n + 4.0));
    }
    return sum;
}

FoundationWaves foundation_waves(double x)
{
    const bool is_small = x < 1.0;
    const double e = is_small ? 1.0 : std::exp(-x), s = std::sin(x), c = std::cos(x);
    const double sinh = is_small ? std::sinh(x) : -0.5 * std::expm1(-2.0 * x);
    const double cosh = is_small ? std::cosh(x) : 0.5 * (1.0 + e * e);
    const double D = is_small ? 2.0 * cubic_series(x, 1.0) * (sinh + s) : sinh * sinh - s * s * e * e;
    return {.sum = sinh * cosh + s * c * e * e,
            .difference = is_small ? cubic_series(2.0 * x, 1.0) : sinh * cosh - s * c * e * e,
            .squares = sinh * sinh + s * s * e * e,
            .far_sum = (cosh * s + sinh * c) * e,
            .far_difference = is_small ? 4.0 * cubic_series(x, -4.0) : (cosh * s - sinh * c) * e,
            .product = sinh * s * e,
            .D = D};
}

/// Bending in one plane, its joints turning and sliding across the axis.
class BendingEntries {
public:
    BendingEntries(const StiffMember& member, BendingPlane plane)
        : beam_(plane == BendingPlane::xy ? member.properties->xy : member.properties->xz),
          L_(member.length),
          suffix_(!is_3d(member.kind)         ? ""
                  : plane == BendingPlane::xy ? "z"
                                              : "y"),
          shear_suffix_(!is_3d(member.kind)         ? ""
                        : plane == BendingPlane::xy ? "y"
                                                    : "z")
    {
        for (std::size_t end = 0; end < 2; ++end) {
            turning_[end] = joint(member, end, moment_axis(plane));
            sliding_[end] = joint(member, end, force_axis(plane));
        }
    }

    void add_to(Numbers& numbers) const
    {
        if (!has_stiffness(beam_.EI)) return;
        if (beam_.foundation > 0.0) return add_on_foundation(numbers);
        if (turning_[0].is_released() && turning_[1].is_released()) return;
        if (slides()) return add_sliding(numbers);
        if (is_tapered()) add_tapered(numbers);
        else if (turning_[0].is_spring() || turning_[1].is_spring()) add_sprung(numbers);
        else if (turning_[0].is_released() || turning_[1].is_released()) add_hinged(numbers);
        else add_rigid(numbers);
    }

private:
    bool is_tapered() const { return !beam_.taper.is_prismatic(); }
    bool slides() const { return sliding_[0].is_released() || sliding_[1].is_released(); }
    bool shears() const { return beam_.shear_flexibility > 0.0; }
    bool is_sprung_across() const { return sliding_[0].is_spring() || sliding_[1].is_spring(); }
    bool has_phi() const { return shears() || is_sprung_across(); }
    double across() const { return sliding_[0].flexibility() + sliding_[1].flexibility(); }
    double phi() const { return 12.0 * beam_.EI / (L_ * L_ * L_) * (L_ * beam_.shear_flexibility + across()); }
    std::string EI() const { return "EI" + suffix_; }
    std::string GAs() const { return "GAs" + shear_suffix_; }

    void add_phi(Numbers& numbers) const
    {
        if (!has_phi()) return;
        if (!is_sprung_across()) return numbers.push_back({"φ = 12 " + EI() + "/(" + GAs() + " L^2)", phi()});
        const std::string springs = sliding_[0].addend() + sliding_[1].addend();
        const std::string sum = shears() ? "L/" + GAs() + springs : springs.substr(3);
        numbers.push_back({"φ = 12 " + EI() + " (" + sum + ")/L^3", phi()});
    }

    void add_rigid(Numbers& numbers) const
    {
        add_phi(numbers);
        const double p = phi(), k = beam_.EI / (1.0 + p);
        const std::string more = has_phi() ? "(1 + φ)" : "";
        numbers.push_back({quotient("12 " + EI(), "L^3", more), 12.0 * k / (L_ * L_ * L_)});
        numbers.push_back({quotient("6 " + EI(), "L^2", more), 6.0 * k / (L_ * L_)});
        numbers.push_back({quotient((has_phi() ? "(4 + φ) " : "4 ") + EI(), "L", more), (4.0 + p) * k / L_});
        numbers.push_back({quotient((has_phi() ? "(2 - φ) " : "2 ") + EI(), "L", more), (2.0 - p) * k / L_});
    }

    void add_hinged(Numbers& numbers) const
    {
        add_phi(numbers);
        const double k = 3.0 * beam_.EI / (1.0 + 0.25 * phi());
        const std::string more = has_phi() ? "(1 + φ/4)" : "";
        numbers.push_back({quotient("3 " + EI(), "L^3", more), k / (L_ * L_ * L_)});
        numbers.push_back({quotient("3 " + EI(), "L^2", more), k / (L_ * L_)});
        numbers.push_back({quotient("3 " + EI(), "L", more), k / L_});
    }

    double fixity(std::size_t end) const
    {
        return turning_[end].is_released() ? 0.0 : 1.0 / (1.0 + 3.0 * beam_.EI / L_ * turning_[end].flexibility());
    }

    void add_sprung(Numbers& numbers) const
    {
        add_phi(numbers);
        const double r1 = fixity(0), r2 = fixity(1), p = phi();
        const double D = 4.0 - r1 * r2 + p * (r1 + r2 + r1 * r2), k = beam_.EI / D;
        for (std::size_t end = 0; end < 2; ++end) {
            const std::string r = end == 0 ? "r1" : "r2";
            const bool is_spring = turning_[end].is_spring();
            numbers.push_back(
                {is_spring ? r + " = 1/(1 + 3 " + EI() + "/(L " + turning_[end].name + "))" : r, fixity(end)});
        }
        numbers.push_back({has_phi() ? "D = 4 - r1 r2 + φ (r1 + r2 + r1 r2)" : "D = 4 - r1 r2", D});
        const auto add = [&](const std::string& above, const std::string& below, double value) {
            numbers.push_back({above + "/(" + below + " D)", value});
        };
        add("12 " + EI() + " (r1 + r2 + r1 r2)", "L^3", 12.0 * k * (r1 + r2 + r1 * r2) / (L_ * L_ * L_));
        add("6 " + EI() + " r1 (2 + r2)", "L^2", 6.0 * k * r1 * (2.0 + r2) / (L_ * L_));
        add("6 " + EI() + " r2 (2 + r1)", "L^2", 6.0 * k * r2 * (2.0 + r1) / (L_ * L_));
        add("12 " + EI() + " r1" + (has_phi() ? " (1 + φ r2/4)" : ""), "L", 12.0 * k * r1 * (1.0 + p * r2 / 4.0) / L_);
        add("12 " + EI() + " r2" + (has_phi() ? " (1 + φ r1/4)" : ""), "L", 12.0 * k * r2 * (1.0 + p * r1 / 4.0) / L_);
        add("6 " + EI() + " r1 r2" + (has_phi() ? " (1 - φ/2)" : ""), "L", 6.0 * k * r1 * r2 * (1.0 - p / 2.0) / L_);
    }

    /// Of the rotations against the chord, springs and what slides across the axis left out.
    Eigen::Matrix2d flexibility() const { return beam_.chord_stiffness(L_).inverse(); }

    /// No force crosses a joint that slides: the moment is the same all along.
    void add_sliding(Numbers& numbers) const
    {
        if (turning_[0].is_released() || turning_[1].is_released()) return;
        const std::string springs = turning_[0].addend() + turning_[1].addend();
        const std::string own = is_tapered() ? "∫ dx/" + EI() : "L/" + EI();
        const Eigen::Matrix2d F = flexibility();
        const double f = F(0, 0) + F(1, 1) - F(0, 1) - F(1, 0) + turning_[0].flexibility() + turning_[1].flexibility();
        if (springs.empty()) numbers.push_back({is_tapered() ? "1/" + own : EI() + "/L", 1.0 / f});
        else numbers.push_back({"1/(" + own + springs + ")", 1.0 / f});
    }

    void add_tapered(Numbers& numbers) const
    {
        const Eigen::Matrix2d F = flexibility();
        const double slid = across() / (L_ * L_);
        const double f1 = F(0, 0) + slid + turning_[0].flexibility(), f2 = F(1, 1) + slid + turning_[1].flexibility(),
                     f12 = F(0, 1) + slid, D = f1 * f2 - f12 * f12;
        std::string shear = shears() ? " + ∫ dx/(" + GAs() + " L^2)" : "";
        for (const Joint& across : sliding_)
            if (across.is_spring()) shear += " + 1/(" + across.name + " L^2)";
        const bool is_first = !turning_[0].is_released(), is_second = !turning_[1].is_released();
        if (is_first) numbers.push_back({"f1 = ∫ (1 - x/L)^2 dx/" + EI() + shear + turning_[0].addend(), f1});
        if (is_second) numbers.push_back({"f2 = ∫ (x/L)^2 dx/" + EI() + shear + turning_[1].addend(), f2});
        if (is_first && is_second) {
            numbers.push_back({"f12 = -∫ (1 - x/L) x/L dx/" + EI() + shear, f12});
            numbers.push_back({"D = f1 f2 - f12^2", D});
            numbers.push_back({"(f1 + f2 - 2 f12)/(L^2 D)", (f1 + f2 - 2.0 * f12) / (L_ * L_ * D)});
            numbers.push_back({"(f2 - f12)/(L D)", (f2 - f12) / (L_ * D)});
            numbers.push_back({"(f1 - f12)/(L D)", (f1 - f12) / (L_ * D)});
            numbers.push_back({"f2/D", f2 / D});
            numbers.push_back({"f1/D", f1 / D});
            numbers.push_back({"-f12/D", -f12 / D});
            return;
        }
        const std::string f = is_first ? "f1" : "f2";
        const double held = is_first ? f1 : f2;
        numbers.push_back({"1/(L^2 " + f + ")", 1.0 / (L_ * L_ * held)});
        numbers.push_back({"1/(L " + f + ")", 1.0 / (L_ * held)});
        numbers.push_back({"1/" + f, 1.0 / held});
    }

    bool has_joint() const
    {
        return std::isfinite(turning_[0].k) || std::isfinite(turning_[1].k) || std::isfinite(sliding_[0].k) ||
               std::isfinite(sliding_[1].k);
    }

    /// Where joints or shear are at work too, the step says so in words alone.
    void add_on_foundation(Numbers& numbers) const
    {
        const double beta = std::pow(beam_.foundation / (4.0 * beam_.EI), 0.25);
        numbers.push_back({"β = (k/(4 " + EI() + "))^(1/4)", beta});
        numbers.push_back({"β L", beta * L_});
        if (has_joint() || shears()) return;
        const FoundationWaves w = foundation_waves(beta * L_);
        const double k1 = 2.0 * beam_.EI * beta / w.D, k2 = k1 * beta, k3 = 2.0 * k2 * beta;
        numbers.push_back({"4 " + EI() + " β^3 (sinh cosh + sin cos)/D", k3 * w.sum});
        numbers.push_back({"2 " + EI() + " β^2 (sinh^2 + sin^2)/D", k2 * w.squares});
        numbers.push_back({"2 " + EI() + " β (sinh cosh - sin cos)/D", k1 * w.difference});
        numbers.push_back({"4 " + EI() + " β^3 (cosh sin + sinh cos)/D", k3 * w.far_sum});
        numbers.push_back({"4 " + EI() + " β^2 sinh sin/D", 2.0 * k2 * w.product});
        numbers.push_back({"2 " + EI() + " β (cosh sin - sinh cos)/D", k1 * w.far_difference});
    }

    const Beam& beam_;
    double L_;
    std::string suffix_, shear_suffix_;
    std::array<Joint, 2> turning_, sliding_;
};

} // namespace

std::vector<NamedNumber> stiffness_entries(const StiffMember& member)
{
    Numbers numbers;
    const MemberProperties& properties = *member.properties;
    const double foundation = properties.xy.foundation;
    if (member.is_on_foundation_alone) {
        if (foundation > 0.0) {
            numbers.push_back({"k L/3", foundation * member.length / 3.0});
            numbers.push_back({"k L/6", foundation * member.length / 6.0});
        }
        return numbers;
    }
    if (member.stretches) add_bar(numbers, member, LocalAxis::x, properties.axial, "EA");
    if (!member.bends) return numbers;
    if (is_3d(member.kind) || member.kind == AnalysisKind::Grillage)
        add_bar(numbers, member, LocalAxis::rx, properties.torsion, "GJ");
    BendingEntries(member, BendingPlane::xy).add_to(numbers);
    if (is_3d(member.kind)) BendingEntries(member, BendingPlane::xz).add_to(numbers);
    return numbers;
}

} // namespace femoop::derivation
