#pragma once

#include "ui/paint/geometry.h"
#include "ui/paint/label/obstacles.h"
#include "ui/paint/painter.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ui {

/// What lies on one side of a line.
struct HalfPlane {
    Point border;  ///< a point of the line
    Point inwards; ///< across the line
    bool contains(Point p) const { return dot(p - border, inwards) >= 0.0; }
};

/// A string that wants a place near what it speaks of.
struct Label {
    Point target;                    ///< what it speaks of: where a leader would point
    Size size;                       ///< of the text's box, unrotated
    std::vector<Point> wishes{};     ///< middles of the box, best first, each good without a leader; may be empty
    double rotation = 0.0;           ///< [rad], positive counter-clockwise as seen
    std::vector<Point> turned{};     ///< middles of the box turned by `turn`, liked less than the wishes
    double turn = 0.0;               ///< [rad], added to the rotation
    double priority = 0.0;           ///< larger ones choose first, and are the last to be left out
    double clearance = 5.0;          ///< least distance of the box from the target where no wish can be had
    double reach = 90.0;             ///< greatest distance of the box from the target
    std::optional<HalfPlane> side{}; ///< that the middle of the box never leaves
    std::span<const Point> others{}; ///< places beside the target that it speaks of as well
    /// It takes no place without a leader where it would seem to speak of something else: behind an obstacle, or, if it
    /// speaks of one place alone, with its middle nearer to what another such label speaks of.
    bool needs_sight = false;
};

/// A straight line from the top or the bottom of a label to its target, drawn where they are far apart.
struct Leader {
    Point from;
    Point to;
};

struct PlacedLabel {
    Point center;          ///< of the box, see `draw_label`
    double rotation = 0.0; ///< [rad], the label's own or the turned one
    std::optional<Leader> leader{};
    bool is_over_soft = false; ///< it covers something soft: a plate keeps it readable
};

struct LabelPlacement {
    std::vector<std::optional<PlacedLabel>> labels; ///< one per label, in the order given; nothing: no room for it
    std::size_t n_left_out = 0;
};

/// Finds a place for every label so that none covers another, an obstacle or another's leader.
///
/// By falling priority each label takes the first free place among its wishes, the turned ones next, then on rings
/// around its target, ever farther out. One that finds none asks the label in its way to move aside, one of higher
/// priority not far from its target; if that fails too, it may cover what is `Firmness::Soft`; then that other one moves
/// far after all; only then is it left out. The result depends on the input alone. Two hundred
/// labels that find room nearby take about 1 ms. The search is bounded: where a thousand crowd a screen, those of low
/// priority look nearby only, and the whole takes about 10 ms.
class LabelPlacer {
public:
    struct Options {
        Box room;                   ///< labels stay inside
        double gap = 2.0;           ///< between labels, and from them to obstacles
        double leader_after = 14.0; ///< distance from box to target above which a leader is drawn
    };

    explicit LabelPlacer(const Options& options);

    LabelObstacles& obstacles() { return obstacles_; }
    LabelPlacement place(std::span<const Label> labels) const;

private:
    Options options_;
    LabelObstacles obstacles_;
};

/// The box that a label needs for a string.
Size label_size(const Fonts& fonts, std::string_view utf8, const TextStyle& style);
/// Draws the string in its box, whatever the style's anchor and rotation. Draws no leader.
void draw_label(Painter& painter, const PlacedLabel& place, std::string_view utf8, const TextStyle& style);

} // namespace ui
