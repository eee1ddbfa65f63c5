#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "femoop/methods/truss/arrangement.h"
#include "femoop/methods/truss/faces.h"
#include "femoop/methods/truss/joint_method.h"
#include "femoop/methods/truss/truss.h"

namespace femoop::truss {

using SpaceId = Id<struct SpaceTag>;

/// A region of the plane between bars and lines of forces, by Bow's notation: letters outside, numbers inside. In the
/// reciprocal diagram it is a point, with the same letter.
struct Space {
    std::string name; ///< "A" ... without I and O, then "AA"; inside "1" ...
    bool is_inside = false;
    std::vector<Way> outline;                        ///< along the bars that bound it, which have it to their left
    Eigen::Vector2d point = Eigen::Vector2d::Zero(); ///< in the diagram, as a force

    std::string point_name() const; ///< "a" ... of its point
};

/// What is drawn at one stage: first the forces from outside, then bar by bar, at last the joints that are left to check.
/// Of two bars that are unknown at a joint the first is a line without an end: the second cuts it in the new point.
struct DiagramStep {
    std::optional<std::size_t> joint_step{}; ///< of JointMethod::steps; none for the polygon of the forces
    std::optional<MemberId> bar{};           ///< whose line is drawn; none at the first stage, and where joints check
    std::optional<SpaceId> from{};           ///< at whose point it begins
    std::optional<MemberId> cuts{};          ///< the bar whose line it ends
    std::vector<SpaceId> spaces{};           ///< whose points become known
    bool is_open = false;                    ///< where the line ends is not known yet
    bool closes = false;                     ///< all sides of the joint of `joint_step` stand now
};

/// A side of a joint's force polygon in the diagram.
struct PolygonSide {
    std::optional<MemberId> bar;
    std::optional<std::size_t> force; ///< of Truss::forces
    SpaceId from, to;                 ///< as it acts on the joint
};

/// The reciprocal diagram of Maxwell and Cremona: every joint's force polygon, each bar drawn once.
///
///          B                    b
///        / 1 \   joint,         | \      Going clockwise about a joint from space p to space q, the bar or force
///    A  /_____\  C              1--- ...  between them does p -> q on the joint: tension if that points away from it.
///
/// Each side is parallel to its bar and as long as its force. Two of them are parallel to one and the same bar, so tension
/// and compression stand in the sense of reading, not in the drawing.
///
/// Assumes  a planar truss with forces at joints of its outline alone; of a force whose line runs between bars it matters
///          between which spaces of the outline it lies
/// Source   [Maxwell1864], [Cremona1872], [Bow1873]; [TimoshenkoYoung1965, ch. 2]
/// Lesson   courseware/04-a-truss-by-three-methods.md
struct Reciprocal {
    std::vector<Space> spaces;       ///< outside clockwise, then inside as they are found
    std::vector<std::size_t> forces; ///< of Truss::forces, clockwise: [i] lies between spaces i and i + 1
    std::vector<std::array<SpaceId, 2>> bar_spaces; ///< of every bar, to its left and right
    Arrangement arrangement;
    JointMethod joints;
    std::vector<DiagramStep> steps;
    double closing_error = 0.0; ///< the largest by which a side misses a point that is known already

    const Space& operator[](SpaceId space) const { return spaces[space.index]; }
    std::size_t n_outside() const { return forces.size(); }
    std::array<SpaceId, 2> force_spaces(std::size_t i) const; ///< before and after forces[i], clockwise
    std::string name(MemberId bar) const;                     ///< "A-1"
    std::string side_name(MemberId bar) const;                ///< "a-1"
    /// Clockwise about the joint of a step, so that what it finds comes last. \pre the step has a joint
    std::vector<PolygonSide> polygon(const Truss& truss, const Step& step) const;
};

std::optional<Refusal> why_no_reciprocal(const Truss& truss);

/// \pre why_no_reciprocal says nothing
Reciprocal reciprocal(const Truss& truss);

/// Where forces may lie: at a planar truss outside, else anywhere.
Arrangement usual_arrangement(const Truss& truss);

} // namespace femoop::truss
