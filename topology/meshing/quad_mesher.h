#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "topology/meshing/delaunay_mesher.h"
#include "topology/meshing/mesh_domain.h"

namespace topology {

/// Quadrilaterals inside a domain whose boundary stays as it is, with one triangle where the number of its edges is odd.
/// A Delaunay mesh's triangles are paired, where one has fewest partners first; two that are left over walk towards each
/// other through the quadrilaterals between them, which are cut anew on the way. Then the worst are mended: edges between
/// two are turned, three take the place of two, a flat one is closed, nodes of two cells alone are taken out, and all are
/// smoothed.
///
/// Accuracy  where a quadrilateral cannot be mended, half as fine a mesh is cut into quadrilaterals at the middles of
///           its edges; where that makes flat ones it stays as two triangles; where a cell is turned inside out, the
///           pairs alone are the mesh
/// Source    pairing: [KarpSipser1981]; turning edges and taking nodes out: [Kinney1997]
class QuadMesher : public Mesher {
public:
    QuadMesher(const MeshDomain& domain, MesherOptions options); ///< \pre the domain lives as long

    Step next() override;
    CellMesh mesh() const override;
    MeshMarks marks() const override;

    /// The least sine of a cell's angles, negative where one is above 180 degrees; of a triangle 1 where it is
    /// equilateral.
    static double quality(std::span<const FlatPoint> corners);

private:
    using Nodes = std::vector<CellNode>;
    using CellIndex = std::uint32_t;
    static constexpr std::size_t most_rounds = 30;
    static constexpr double least_of_filled = 0.05; ///< quality of cells without which triangles stay
    QuadMesher(const MeshDomain& domain, MesherOptions options, bool is_halved);
    static constexpr CellIndex none = 0xffffffff;

    void triangulate();
    bool pair_next();
    bool walk_next();
    bool mend();

    void find_pairs();
    void pair(CellIndex a, CellIndex b);
    std::vector<CellIndex> path_to_triangle(CellIndex from);
    CellIndex without_doublet(CellIndex triangle, CellIndex quadrilateral);
    CellIndex step_through(CellIndex triangle, CellIndex through, CellIndex ahead);
    bool mend_cell(CellIndex cell);
    using Choice = std::vector<Nodes>; ///< cells that may take the place of others
    std::vector<Choice> turned_edges(CellIndex a, CellIndex b) const;
    std::vector<Choice> around_node(CellIndex a, CellIndex b, CellNode centre) const;
    std::optional<Choice> without_cell(const std::vector<CellIndex>& around, CellIndex cell, std::size_t corner) const;
    bool collapse(CellIndex cell);
    bool recut(const std::vector<CellIndex>& cells, const std::vector<Choice>& choices);
    bool recut_and_move(const std::vector<CellIndex>& cells, const Choice& choice);
    std::vector<CellIndex> cells_around(CellNode node, const std::vector<CellIndex>& known) const;
    bool remove_doublets();
    std::vector<CellIndex> poor_cells() const;
    void smooth_all();
    void smooth_poor();
    void smooth(CellNode node, const std::vector<CellIndex>& around);
    void move_to_middle(CellNode node, const std::vector<CellIndex>& around);
    void move_to_best(CellNode node, const std::vector<CellIndex>& around);
    double worst_of(const std::vector<CellIndex>& cells) const;
    void cut_worst();
    void fall_back();
    struct Halved;
    void refill();
    bool fill_halved(std::size_t first);
    bool cut_at_middles(const Nodes& corners, const Halved& half, std::unordered_map<std::uint64_t, CellNode>& middles);
    void mend_filled();
    CellNode add_place(const FlatPoint& at);
    std::size_t n_triangles() const;

    CellIndex add(const Nodes& nodes);
    void put(CellIndex cell, const Nodes& nodes);
    void remove(CellIndex cell);
    CellIndex across(CellNode from, CellNode to) const;      ///< the cell that has the edge from `from` to `to`
    std::vector<CellIndex> neighbours(CellIndex cell) const; ///< across edges that are not fixed
    Nodes outline(CellIndex a, CellIndex b) const;           ///< of two that share one edge
    double quality(const Nodes& cell) const;
    FlatVector leaving(CellNode from, CellNode to) const; ///< from a node along an edge, as this bends
    double worst(const std::vector<Nodes>& cells) const;
    std::vector<std::vector<CellIndex>> cells_of_nodes() const;
    bool is_fixed_edge(CellNode a, CellNode b) const;
    bool is_triangle(CellIndex cell) const { return cells_[cell].size() == 3; }

    Step step();

    const MeshDomain& domain_;
    MesherOptions options_;
    std::vector<FlatPoint> nodes_;
    std::vector<Nodes> cells_;            ///< empty where one is no longer there
    std::vector<FlatPoint> triangulated_; ///< nodes of the Delaunay mesh
    std::vector<Nodes> paired_;           ///< cells as all pairs were made
    std::unordered_map<std::uint64_t, CellIndex> edges_;
    std::vector<std::uint64_t> fixed_;                   ///< segments, ascending
    std::unordered_map<std::uint64_t, FlatPoint> bends_; ///< middles of edges that bend
    /// Edges between triangles that may be paired, the best first, and how many partners each triangle still has.
    struct Pairing {
        CellIndex a = none, b = none;
        double quality = 0.0;
    };
    std::vector<Pairing> pairs_;
    std::vector<CellIndex> lonely_; ///< triangles with one partner
    std::size_t n_looked_ = 0, n_rounds_ = 0, n_tries_ = 0;
    CellIndex walked_ = 0; ///< all triangles before this one are gone, or alone
    struct Reached {
        CellIndex before = none;
        std::uint32_t search = 0;
    };
    std::vector<Reached> reached_; ///< of each cell
    std::vector<CellIndex> open_;
    std::uint32_t search_ = 0;
    std::vector<CellIndex> made_; ///< in the last step
    bool is_triangulated_ = false, is_cut_ = false;
    bool is_halved_ = false; ///< its cells are to be cut into quadrilaterals
};

} // namespace topology
