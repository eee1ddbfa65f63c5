#pragma once

#include "apps/euler/view/shapes/outline.h"
#include "apps/euler/view/subject.h"
#include "ui/paint/geometry.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace euler {

/// Where everything of a picture stands on its sheet [px]: in space, in the plane or as polygons. Whatever drew it, one
/// hand paints it (draw/draw.h) and one hand picks from it (pick.h).
struct Shapes {
    /// A flat part of a face, painted in this order: later ones lie in front.
    struct Piece {
        std::size_t face; ///< its place in `faces`
        Region area;
        bool is_back = false; ///< seen from inside
    };
    struct Face {
        std::size_t subject;
        topology::FaceId face;
        bool is_back = false; ///< seen from inside
        bool is_bent = false; ///< stretched over its loops as triangles
    };
    struct Edge {
        std::size_t subject;
        topology::EdgeId edge;
        std::vector<ui::Point> line; ///< from the old vertex to the new one
        bool is_hidden = false;
        std::size_t after = 0;               ///< painted after so many pieces
        std::optional<std::size_t> series{}; ///< which colour tells it apart, where edges are told apart
    };
    /// A half-edge, beside its edge and inside its face; about its vertex where that is lone.
    struct Arrow {
        std::size_t subject;
        topology::HalfEdgeId half_edge;
        std::vector<ui::Point> line;
        bool is_hidden = false;
        std::size_t after = 0;
    };
    struct Vertex {
        std::size_t subject;
        topology::VertexId vertex;
        ui::Point at;
        bool is_hidden = false;
        std::size_t after = 0;
        ui::Point toward{}; ///< unit vector to the side where its name stands best; zero: any
    };

    std::vector<Piece> pieces;
    std::vector<Face> faces;
    std::vector<Edge> edges;
    std::vector<Arrow> arrows;
    std::vector<Vertex> vertices;
    bool is_repeated = false;             ///< an entity stands in several places, and is named at each
    std::vector<std::string> sentences{}; ///< what this kind of picture cannot show, in words
};

/// How much is left out because there are so many edges: 0 of a solid that can be read edge by edge, 1 of thousands,
/// growing evenly between, so that a frame takes about as long whatever the solid.
double thinning(std::size_t n_edges);

/// The length of an edge on the sheet [px], of half of them at least; infinite where there is none.
double typical_edge(const Shapes& shapes);

} // namespace euler
