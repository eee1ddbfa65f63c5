#pragma once

#include <cstddef>
#include <vector>

#include "femoop/element/bar.h"
#include "femoop/element/beam.h"
#include "femoop/element/polynomial.h"
#include "femoop/element/span_load.h"
#include "femoop/model/expected.h"

namespace femoop {

/// Section forces on the face whose outward normal is +x'. In plane models and grillages V is Vy and M is Mz.
///
/// N  tension positive; Vy positive along -y', Vz along -z'; Mz positive when it stretches the -y' fibre, My the
/// -z' fibre; T as a vector along +x'. Without distributed moments dMz/dx' = Vy and dMy/dx' = Vz.
struct SectionForces {
    double N = 0.0, Vy = 0.0, Vz = 0.0, T = 0.0, My = 0.0, Mz = 0.0;
};

/// Displacements of the member's axis along x' y' z', and rotations about them.
struct LocalDisplacement {
    double u = 0.0, v = 0.0, w = 0.0, rx = 0.0, ry = 0.0, rz = 0.0;
};

struct Extreme {
    double x = 0.0; ///< from the member's first end
    double value = 0.0;
};
struct Extremes {
    Extreme max, min;
};

/// A value at a place: at a jump there are two, Side::Before first.
struct Station {
    double x = 0.0;
    Side side = Side::After;
    SectionForces forces;
    LocalDisplacement displacement;
};

/// The exact solution along one member in one case: closed forms, piece by piece between load points.
///
/// Units     the model's base units
/// Accuracy  exact for the member's theory (Euler-Bernoulli, Timoshenko, Winkler foundation), nothing is sampled
class Curve {
public:
    /// The solution at one place.
    struct State {
        Bar::State axial, torsion;
        Beam::State xy, xz;
    };
    /// A stretch between load points, with the solution at its beginning, after the point loads there.
    struct Piece {
        SpanPiece load;
        State begin;
    };
    /// What governs the shape between the states: infinite stiffness where a member does not strain.
    struct Law {
        Bar axial, torsion;
        Beam xy, xz;
        double strain = 0.0;      ///< imposed
        double curvature = 0.0;   ///< imposed, in the x'y' plane
        bool is_in_plane = false; ///< of a plane model: nothing twists it or bends it in x'z'
    };

    /// For who makes a curve: starts over with a law and the loads of its pieces, from the first end to the last, whose
    /// states then follow one by one.
    void begin(const Law& law, const std::vector<SpanPiece>& loads);
    void begin_piece(std::size_t piece, const State& state) { pieces_[piece].begin = state; }

    double length() const { return pieces_.back().load.end; }

    /// Load points and the two ends, ascending: the first is 0, the last is length().
    std::vector<double> breaks() const;

    SectionForces forces(double x, Side side = Side::After) const;
    LocalDisplacement displacement(double x, Side side = Side::After) const;
    double value(MemberComponent component, double x, Side side = Side::After) const;

    /// Largest and smallest value along the member, both sides of a jump counted, at their exact places;
    /// of equal values the first.
    Extremes extremes(MemberComponent component) const;

    /// Where the component passes through or touches zero, ascending; a stretch of zero gives its two ends.
    std::vector<double> zeros(MemberComponent component) const;

    /// `n` evenly spaced stations and every load point; a jump gives two stations at one x. \pre n >= 2
    std::vector<Station> stations(std::size_t n) const;

    const std::vector<Piece>& pieces() const { return pieces_; }

    /// The component as a polynomial of t = x - begin over one piece.
    Polynomial polynomial(MemberComponent component, const Piece& piece) const;

private:
    const Piece& piece_at(double x, Side side) const;
    Station station(double x, Side side) const;
    bool jumps_at(double x) const;

    Law law_;
    std::vector<Piece> pieces_;
};

} // namespace femoop
