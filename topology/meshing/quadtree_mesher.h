#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "topology/meshing/domain_triangulation.h"
#include "topology/meshing/inside_test.h"
#include "topology/meshing/mesher.h"
#include "topology/meshing/quadtree.h"

namespace topology {

/// Triangles inside a domain by a quadtree. When the outline is triangulated, so that it is known to be sound, a square
/// around it is cut into four, and these again, until none near the boundary is larger than the edges there, none inside
/// larger than asked for, and none has a side against more than two others. Squares inside, well away from the boundary,
/// are filled by patterns; the band between them and the boundary is triangulated. Last, places inside are smoothed.
///
///      +-------+---+---+      patterns, by the sides against two smaller squares:
///      |       |   |   |       none       one       two       two       three     four
///      |       +---+---+      +---+     +---+     +---+     +---+     +---+     +---+
///      |       |   |   |      | / |     |/\ |     |_/ |     | | |     |/|\|     |/ \|
///      +---+---+---+---+      +---+     +--+      +-+-+     +---+     +---+     +---+
///
/// Accuracy  right triangles inside; in the band what its width allows
/// Source    [YerryShephard1983] for the tree and its patterns, [BaehmannShephard1987] for the boundary
class QuadtreeMesher : public Mesher {
public:
    /// \throws CrossingEdges  \pre the domain lives as long
    QuadtreeMesher(const MeshDomain& domain, MesherOptions options);

    Step next() override;
    CellMesh mesh() const override;
    MeshMarks marks() const override; ///< lines: the squares of the tree

    const Quadtree& tree() const { return tree_; }

private:
    using Index = Quadtree::Index;
    using Place = std::pair<Quadtree::Step, Quadtree::Step>; ///< y, x
    /// An edge of the domain, or a place of its own, and the size that is wanted there.
    struct Border {
        FlatPoint a, b;
        double size = 0.0;
    };
    /// What is known of a square beside its place.
    struct Surroundings {
        std::vector<std::uint32_t> borders; ///< that come nearer than half its side
        bool is_outside = false, is_inside = false;
    };

    static Quadtree tree_around(const MeshDomain& domain, double size);
    void list_borders();
    bool cut_next();
    bool is_too_large(Index square) const;
    void cut(Index square);
    bool balance_next();
    void look_around(Index square);
    void list_places();
    void list_corners(Index leaf);
    bool stands(const Place& place) const;
    CellNode node(const Place& place) const;
    bool fill_next();
    bool is_filled(Index leaf) const;
    std::array<std::optional<CellNode>, 8> outline(Index leaf) const;
    void fill(const std::array<std::optional<CellNode>, 8>& outline);
    std::vector<CellEdge> pattern_edges() const;
    void make_band();

    const MeshDomain& given_;
    MesherOptions options_;
    MeshDomain domain_;           ///< with the places of the tree
    DomainTriangulation outline_; ///< as it is given: that it can be meshed
    InsideTest inside_;
    Quadtree tree_;
    std::vector<Border> borders_;
    std::vector<Surroundings> around_; ///< of each square
    std::vector<Place> places_;        ///< that are nodes, ascending
    std::vector<Cell> cells_;          ///< of patterns
    std::optional<DomainTriangulation> band_;
    Index looked_ = 0; ///< squares before this one are done
    Index last_square_ = 0;
    std::size_t n_cells_before_ = 0;
    enum class Stage : std::uint8_t { Outline, Cut, Balance, Fill, Smooth } stage_ = Stage::Outline;
    int n_sweeps_ = 0;
    Step last_ = Step::Done;
};

} // namespace topology
