#pragma once

#include "apps/euler/view/look.h"
#include "apps/euler/view/subject.h"
#include "topology/tables/pointer_graph.h"
#include "ui/paint/painter.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace euler {

/// A link as `topology::Pointer` labels it, in the reader's language.
std::string link_name(std::string_view label, const ui::Catalogue& tr);

/// The links of an entity as boxes and arrows. The entity stands in the middle, a half-edge's neighbours where one
/// looks for them: prev on the left, next on the right, the mate below, the loop above.
///
///               [ l1 ]            Several links from one box to another are one arrow with all their names; a link
///        start    ^ loop          back is an arrow of its own. A link of an entity to itself, as a lone vertex's
///      [v1] <--.  |               half-edge has, is an arrow around its box. Links of the others among themselves
///    [%4] <-- [ %1 ] --> [%2]     are pale.
///      prev      | mate   next
///                v
///              [ %8 ]
class PointerDrawing {
public:
    struct Node {
        topology::Entity entity;
        std::string name;
        ui::Box box;
        std::size_t level = 0; ///< how many links from the entity in the middle
    };
    struct Arrow {
        std::vector<ui::Point> line; ///< from border to border
        std::string label;
        bool is_pale = false;
    };

    /// \pre the graph's first node is the entity in the middle
    PointerDrawing(const topology::PointerGraph& graph, const Subject& subject, const Look& look, ui::Size sheet,
                   const ui::Fonts& fonts);

    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<Arrow>& arrows() const { return arrows_; }

    void draw(ui::Painter& painter) const;
    std::optional<topology::Entity> pick(ui::Point at) const; ///< whose box lies there

private:
    void place_nodes(const topology::PointerGraph& graph, ui::Size sheet);
    void add_arrows(const topology::PointerGraph& graph, const ui::Catalogue& tr);
    Arrow arrow(const Node& from, const Node& to, bool has_return) const;
    Arrow around(const Node& node) const;
    ui::Stroke stroke(const Node& node) const;
    void write_labels(ui::Painter& painter) const;

    ui::Theme theme_;
    std::vector<Node> nodes_;
    std::vector<Arrow> arrows_;
};

} // namespace euler
