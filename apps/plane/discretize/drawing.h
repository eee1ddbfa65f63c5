#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "apps/plane/discretize/shape_curves.h"
#include "femoop/model/fault/fault.h"
#include "femoop/plane/model/plane_model.h"
#include "topology/planar/planar_subdivision.h"

namespace discretize {

/// A bounded face of a drawing, islands not included.
struct DrawnFace {
    topology::FaceId id;
    double area = 0.0, perimeter = 0.0; ///< perimeter with that of its holes
    std::size_t n_holes = 0;
    topology::FlatPoint inside; ///< a place in it
    std::optional<femoop::plane::RegionId> region;
};

/// A plane model's drawing as its curves divide the plane: vertices, edges, faces, and which region each face is of.
/// The contract is courseware/reference/plane-model-file.md.
class Drawing {
public:
    explicit Drawing(const PlaneModel& model); ///< \pre it is drawn, and `check(model)` finds no error

    /// What is wrong with it: errors of curves and of places in regions, warnings of what is left empty or dangles.
    /// Where a curve cannot be drawn there are no faces.
    const std::vector<femoop::Fault>& faults() const { return faults_; }
    bool is_sound() const;

    const PlaneModel& model() const { return model_; }
    const topology::PlanarSubdivision& subdivision() const { return subdivision_; }
    const std::vector<DrawnFace>& faces() const { return faces_; } ///< the largest first
    /// The face that a place lies in; nothing outside, and on a curve.
    std::optional<std::size_t> face_at(const topology::FlatPoint& at) const;
    std::optional<topology::VertexId> vertex(femoop::NodeId point) const { return vertices_[point.index]; }
    /// The model's curve that a curve of the subdivision is a part of.
    femoop::plane::CurveId owner(topology::CurveIndex i) const { return owners_[i]; }
    /// Where a curve of the subdivision was drawn to begin and to end.
    const std::array<topology::FlatPoint, 2>& ends(topology::CurveIndex i) const { return ends_[i]; }

    /// What a check of a count or of an area finds; nothing for others, and where its face is not there.
    std::optional<double> read(const femoop::plane::PlaneExpected& check) const;

private:
    /// A drawn curve with its parts.
    struct Drawn {
        femoop::plane::CurveId curve;
        std::vector<ShapePart> parts;
    };
    std::vector<Drawn> draw_curves();
    topology::FlatBox box_around(const std::vector<Drawn>& drawn) const;
    double snap_of(const std::vector<Drawn>& drawn);
    void require_right_of_axis(const std::vector<Drawn>& drawn);
    std::string length_text(double length) const;
    std::vector<bool> standing_points() const;
    void insert(const std::vector<Drawn>& drawn);
    void list_faces();
    double count(const femoop::plane::PlaneExpected& check) const;
    std::optional<double> area(const femoop::plane::PlaneExpected& check) const;
    std::optional<std::size_t> face_of(const femoop::plane::PlaneExpected& check) const;

    const PlaneModel& model_;
    std::vector<femoop::Fault> faults_;
    topology::PlanarSubdivision subdivision_;
    std::vector<femoop::plane::CurveId> owners_; ///< of the subdivision's curves
    std::vector<std::array<topology::FlatPoint, 2>> ends_;
    std::vector<std::optional<topology::VertexId>> vertices_; ///< of points that stand by themselves, or are an end
    std::vector<DrawnFace> faces_;
    std::vector<std::optional<std::size_t>> index_of_face_; ///< by face of the solid
};

} // namespace discretize
