#include "femoop/plane/result/cut_theory.h"

#include <algorithm>

namespace femoop::plane {

namespace {

/// A part of the section: E t is the same along it.
struct Strip {
    double from = 0.0, to = 0.0;
    double E = 0.0, t = 0.0;

    double stiffness() const { return E * t * (to - from); }
    /// Of the part beyond s.
    double first_moment(double s, double about) const
    {
        return 0.5 * E * t * ((to - about) * (to - about) - (s - about) * (s - about));
    }
    double second_moment(double about) const
    {
        const double a = from - about, b = to - about;
        return E * t * (b * b * b - a * a * a) / 3.0;
    }
};

double stiffness_of(const PlaneModel& model, RegionId region)
{
    const Material& material = model[model[region].material];
    const double nu = material.poisson();
    return model.analysis == StressState::PlaneStrain ? material.E / (1.0 - nu * nu) : material.E.value();
}

std::vector<Strip> strips_of(const PlaneModel& model, const std::vector<CutPiece>& pieces)
{
    std::vector<Strip> strips;
    for (const CutPiece& piece : pieces) {
        Strip strip{.from = piece.from, .to = piece.to};
        const auto n = static_cast<double>(piece.elements.size());
        for (const ElementId element : piece.elements) {
            strip.E += stiffness_of(model, model[element].region) / n;
            strip.t += model.thickness(model[element].region) / n;
        }
        strips.push_back(strip);
    }
    return strips;
}

} // namespace

CutTheory beam_theory(const PlaneResults& results, const PlaneCase& result, const Cut& cut, int n)
{
    const std::vector<Strip> strips = strips_of(results.model(), pieces_along(results.model(), results.locator(), cut));
    double EA = 0.0, ES = 0.0, EI = 0.0, length = 0.0, moment = 0.0;
    for (const Strip& strip : strips) {
        const double middle = 0.5 * (strip.from + strip.to);
        EA += strip.stiffness();
        ES += strip.stiffness() * middle;
        length += strip.to - strip.from;
        moment += (strip.to - strip.from) * middle;
    }
    CutTheory theory{.centroid = ES / EA, .stations = {}};
    const double c = theory.centroid;
    for (const Strip& strip : strips) EI += strip.second_moment(c);
    const CutForces forces = result.forces(cut);
    const double M = forces.M + forces.N * (c - moment / length); // about the centroid instead of the middle
    double beyond = 0.0;                                          // EQ of the strips that follow
    for (const Strip& strip : strips) beyond += strip.first_moment(strip.from, c);
    for (const Strip& strip : strips) {
        beyond -= strip.first_moment(strip.from, c);
        for (int i = 0; i < n; ++i) {
            const double s = strip.from + (strip.to - strip.from) * i / (n - 1);
            theory.stations.push_back({.s = s,
                                       .sigma = strip.E * (forces.N / EA - M * (s - c) / EI),
                                       .tau = -forces.V * (beyond + strip.first_moment(s, c)) / (EI * strip.t)});
        }
    }
    return theory;
}

} // namespace femoop::plane
