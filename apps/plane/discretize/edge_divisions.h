#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/plane/discretize/mapped_outline.h"
#include "topology/meshing/size_field.h"

namespace discretize {

/// Where nodes stand along an edge of the subdivision: shares of its length, from 0 to 1.
using EdgeShares = std::vector<double>;

/// How every edge beside material is divided: as its curve says; else as the side opposite to it in a mapped region is,
/// from region to region; else into equal parts of the size that is wanted, smaller near points with a size of their
/// own, and never by less than three parts around or one for every 45 degrees that it turns. Where the settings have a
/// field of sizes every edge that no mapped outline has is divided by it alone.
class EdgeDivisions {
public:
    /// \param outlines  with their settings, one of each
    EdgeDivisions(const Drawing& drawing, const std::vector<FaceOutline>& outlines,
                  const std::vector<MeshSettings>& settings);

    const EdgeShares& shares(topology::EdgeId edge) const { return *shares_[edge.index]; } ///< in its plus direction
    double length(topology::HalfEdgeId h) const { return lengths_[drawing_.subdivision().solid().edge(h)->index]; }
    const std::vector<femoop::Fault>& faults() const { return faults_; }
    /// The sides of outlines that are mapped, swept or trilateral, of each outline.
    const std::vector<std::optional<MappedOutline>>& mapped() const { return mapped_; }

private:
    /// Sides that have equally many parts: opposite ones, of a trilateral outline all.
    struct OppositeSides {
        std::size_t outline = 0;
        const OutlineLoop* a = nullptr;
        const OutlineLoop* b = nullptr;
    };

    void find_mapped();
    void divide_as_written();
    bool spread(); ///< false where an outline turned out not to be mapped
    bool spread_known();
    bool settle_greatest();
    bool copy(const OutlineLoop& from, const OutlineLoop& to);
    bool agree();
    std::vector<OppositeSides> opposite_sides() const;
    void divide_as_usual(topology::HalfEdgeId h);
    void divide_rest();

    bool is_known(topology::HalfEdgeId h) const { return edge_shares(h).has_value(); }
    bool is_known(const OutlineLoop& side) const;
    const std::optional<EdgeShares>& edge_shares(topology::HalfEdgeId h) const;
    std::size_t n_parts(const OutlineLoop& side) const; ///< with what is usual of edges that are not divided yet
    EdgeShares along(const OutlineLoop& side) const;    ///< the shares of a whole side. \pre known
    void set(topology::HalfEdgeId h, EdgeShares shares);
    EdgeShares usual(topology::EdgeId e, std::size_t n_more = 0) const;
    bool wants_even() const;
    void make_even(const OutlineLoop& side);
    const topology::SizeField* given_field() const;
    std::vector<double> samples_of(topology::EdgeId e) const;
    double size_at(topology::EdgeId e, double share) const;
    std::string curves_of(const OutlineLoop& side) const;

    const Drawing& drawing_;
    const std::vector<FaceOutline>& outlines_;
    const std::vector<MeshSettings>& settings_;
    std::vector<std::optional<MappedOutline>> mapped_;
    std::vector<std::optional<EdgeShares>> shares_; ///< of each edge
    std::vector<double> lengths_, sizes_;           ///< of each edge; the size is 0 beside no material
    topology::SizeField field_; ///< besides: of points with a size of their own, or in place of what the drawing says
    std::vector<femoop::Fault> faults_;
};

} // namespace discretize
