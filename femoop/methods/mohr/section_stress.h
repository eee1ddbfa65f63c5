#pragma once

#include <optional>
#include <vector>

#include "femoop/methods/mohr/plane_state.h"
#include "femoop/model/property.h"
#include "femoop/section/outline.h"
#include "femoop/section/profile.h"

namespace femoop::mohr {

/// Section forces in the x'y' plane, with the signs of courseware/conventions.md: N tension positive, V along -y' on
/// the face whose normal is +x', M positive where it stretches the -y' fibre.
struct SectionForces {
    double N = 0.0, V = 0.0, M = 0.0;
};

/// A horizontal cut through a section, at the height y' above its centroid.
struct Cut {
    double y = 0.0;
    double width = 0.0; ///< of the material that is cut; of all webs together
    double Q = 0.0;     ///< first moment about the centroid of the part above the cut
};

/// Where a width jumps, as between flange and web.
enum class CutSide : std::uint8_t { Above, Below };

/// A cross-section as its stresses need it, symmetric about y' or z' (an unsymmetrical one bends out of the x'y' plane,
/// which is left out).
///
/// Area and Iz  of a rolled profile those that its standard publishes, as everywhere else in the analysis; of a shape
///              exact
/// Cuts         exact, along the round fillets too; so Q and a published Iz differ by the rounding of the table, at
/// most
///              0.06 % for IPE, HEA, HEB and HEM, 0.3 % for UPN and 1 % for W
class SectionFigure {
public:
    explicit SectionFigure(SectionOutline outline);
    /// \pre `why_not(shape)` has nothing to say
    explicit SectionFigure(const SectionShape& shape);
    /// A section that has a shape or a profile, turned where it is. \pre `outline(section, units)` is there
    SectionFigure(const Section& section, const Units& units);

    double area() const { return area_; }
    double Iz() const { return Iz_; }
    double top() const { return outline_.top; }
    double bottom() const { return outline_.bottom; }
    const SectionOutline& outline() const { return outline_; }
    Cut cut(double y, CutSide side = CutSide::Below) const;
    /// Heights at which the width jumps or the outline has a corner, from the bottom up.
    std::vector<double> corners() const;

private:
    SectionOutline outline_;
    double area_ = 0.0, Iz_ = 0.0;
};

/// What acts at a height of the section.
struct FibreStress {
    Cut cut;
    double sigma = 0.0; ///< N / A - M y' / Iz (Navier)
    double tau = 0.0;   ///< tau_x'y' = -V Q / (Iz b) (Jourawski), averaged over the width
    PlaneState state() const { return {sigma, 0.0, tau}; }
};

/// Source  [GereTimoshenko], flexure formula (Navier) and shear formula (Jourawski)
FibreStress stress(const SectionFigure& section, const SectionForces& forces, double y, CutSide side = CutSide::Below);

/// From the bottom up: at `n` evenly spaced heights, and on both sides of every corner.
std::vector<FibreStress> distribution(const SectionFigure& section, const SectionForces& forces, std::size_t n);

/// The height at which sigma^2 + 3 tau^2 (von Mises) is largest, of `n` evenly spaced heights and the corners, where
/// the part below a jump counts; the lowest of equal ones.
double most_stressed(const SectionFigure& section, const SectionForces& forces, std::size_t n = 41);

} // namespace femoop::mohr
