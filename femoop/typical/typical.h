#pragma once

#include <cstdint>

#include "femoop/model/model.h"

namespace femoop {

/// Structures that everybody draws, from a few numbers: each `model()` is an ordinary model with supports, a steel
/// material, a section and one load case "G", ready to be solved and changed. Lengths in m, forces in kN.
/// \pre the numbers lie within the limits that stand beside them \throws std::invalid_argument naming the one that does
/// not

enum class Base : std::uint8_t { Fixed, Pinned };

///   o====o====o====o   `spans` equal spans under a uniform load
///   ^    o    o    o
struct ContinuousBeam {
    int spans = 3;      ///< 1 to 20
    double span = 6.0;  ///< > 0
    double load = 20.0; ///< down [kN/m]
    Model model() const;
};

///   +----+----+
///   |    |    |     `storeys` by `bays`, uniform load on every beam, wind on the left of every floor
///   +----+----+     one of each: the portal
///   |    |    |
struct StoreyFrame {
    int bays = 2;        ///< 1 to 20
    int storeys = 3;     ///< 1 to 40
    double bay = 6.0;    ///< > 0
    double storey = 3.0; ///< > 0
    double load = 20.0;  ///< down [kN/m]
    double wind = 10.0;  ///< to the right [kN]
    Base base = Base::Fixed;
    Model model() const;
};

///      .-^-.
///     |     |    two columns under a pitched roof with snow on the projected length
struct GableFrame {
    double span = 12.0;  ///< > 0
    double column = 5.0; ///< > 0
    double rise = 2.0;   ///< >= 0
    double snow = 6.0;   ///< down, per horizontal metre [kN/m]
    Base base = Base::Pinned;
    Model model() const;
};

///   +--+--+--+   rigid joints, no diagonals; loads at the nodes of the lower chord
///   +--+--+--+
struct VierendeelGirder {
    int panels = 6;      ///< 2 to 40
    double span = 18.0;  ///< > 0
    double height = 3.0; ///< > 0
    double load = 30.0;  ///< down, at each inner node [kN]
    Model model() const;
};

/// Pratt    verticals, and diagonals that fall towards the middle (in tension)
/// Howe     verticals, and diagonals that rise towards the middle (in compression)
/// Warren   diagonals alone
/// K        verticals with a node at half height, from which two short diagonals run towards the middle
enum class TrussPattern : std::uint8_t { Pratt, Howe, Warren, K };

/// A parallel-chord truss on a pin and a roller, loaded at the nodes of its lower chord; statically determinate.
struct PlaneTruss {
    TrussPattern pattern = TrussPattern::Pratt;
    int panels = 6;      ///< 4 to 40, even (Warren: 2 to 40, any)
    double span = 18.0;  ///< > 0
    double height = 3.0; ///< > 0
    double load = 30.0;  ///< down, at each inner node of the lower chord [kN]
    Model model() const;
};

enum class ArchHinges : std::uint8_t { None, Two, Three }; ///< none: clamped; three: one at the crown too

/// A parabolic arch as a polygon of equal horizontal steps, y = 4 f x (L - x) / L^2, under a load per horizontal metre.
struct Arch {
    int chords = 12;    ///< 2 to 200, even
    double span = 20.0; ///< > 0
    double rise = 5.0;  ///< > 0
    double load = 10.0; ///< down, per horizontal metre [kN/m]
    ArchHinges hinges = ArchHinges::Two;
    Model model() const;
};

/// Beams that cross on a rectangle, propped at every node of the edge, with a load at each inner crossing.
struct GrillageFloor {
    int panels_x = 4;     ///< 2 to 40
    int panels_y = 3;     ///< 2 to 40
    double panel_x = 2.0; ///< > 0
    double panel_y = 2.5; ///< > 0
    double load = 20.0;   ///< down [kN]
    Model model() const;
};

///      +------+------+
///     /|     /|     /|     bays along x and along y, storeys, columns on fixed or pinned feet; a uniform load on every
///    +------+------+ |     beam, wind along x on every joint of the face at x = 0
///    | +----|-+----|-+
struct SpaceFrame {
    int bays_x = 2;      ///< 1 to 10
    int bays_y = 1;      ///< 1 to 10
    int storeys = 2;     ///< 1 to 20
    double bay_x = 6.0;  ///< > 0
    double bay_y = 5.0;  ///< > 0
    double storey = 3.0; ///< > 0
    double load = 15.0;  ///< down [kN/m]
    double wind = 8.0;   ///< along +x [kN]
    Base base = Base::Fixed;
    Model model() const;
};

/// A tower on four feet that lean towards each other, with a square of rigid beams at every level and a pull of wind
/// along x on its top.
struct Tower {
    int levels = 4;       ///< 1 to 30
    double height = 20.0; ///< > 0
    double foot = 6.0;    ///< side of the square on the ground, > 0
    double top = 2.0;     ///< side of the highest square, > 0
    double wind = 10.0;   ///< along +x, on each corner of the top [kN]
    double load = 20.0;   ///< down, on each corner of the top [kN]
    Model model() const;
};

/// A double-layer grid: square upon square, half a panel apart, joined by four diagonals at each node of the top; the
/// edge of the bottom layer is supported, the top is loaded.
struct SpaceTruss {
    int panels_x = 4;    ///< 1 to 30
    int panels_y = 3;    ///< 1 to 30
    double panel = 3.0;  ///< > 0
    double height = 2.0; ///< > 0
    double load = 10.0;  ///< down, at each node of the top [kN]
    Model model() const;
};

} // namespace femoop
