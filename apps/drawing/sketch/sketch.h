#pragma once

#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/part.h"
#include "apps/drawing/sketch/caption_crowd.h"
#include "femoop/model/dof.h"
#include "femoop/model/moving_load.h"
#include "ui/paint/label_placement.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace drawing {

/// What labels do where a line stands: nothing, keep clear if they can, or always. `Inside` is of an area whose border
/// is drawn as lines of its own: they keep clear of what lies within, if they can.
enum class Clearance : std::uint8_t { None, Inside, Soft, Hard };

/// Of a number of an envelope: which end of its range it is, and the place of what makes it among the envelope's names.
struct RangeEnd {
    femoop::ExtremeKind kind = femoop::ExtremeKind::Max;
    std::size_t made_by = 0;
};

/// A string that is put near what it speaks of, wherever there is room.
struct Caption {
    std::string text;
    ui::Role role = ui::Role::Label;
    ui::Point target;            ///< what it speaks of
    ui::Point toward{0.0, -1.0}; ///< on which side of the target it would stand
    double gap = 5.0;            ///< from the target, where it stands on that side
    Rank rank = Rank::Value;
    ui::Weight weight = ui::Weight::Regular;
    double size = 0.0;               ///< em; 0 is the theme's normal size
    std::vector<ui::Point> others{}; ///< targets that serve as well, such as places along a member
    double reach = 90.0;             ///< how far off it may stand, with a leader
    std::optional<ui::Point> of{};   ///< the place that decides whether it is in sight, where that is not the target
    ui::Point along{}; ///< of a member: where there is no room beside it it is written along this; zero: never
    std::optional<ui::HalfPlane> side{}; ///< where it means nothing else; it stands on no other
    bool is_repeat = false; ///< the same is said nearby: written where there is room, and missed by nobody else
    std::optional<femoop::MovingEffect> number{}; ///< of the results that it writes
    std::optional<RangeEnd> end{};                ///< that the number is
    std::optional<std::size_t> load_mark{};       ///< of the load whose value it is: a hand takes hold of it there too
};

/// A plus or a minus in a small disc, which says the sign of an area.
struct SignMark {
    std::vector<ui::Point> places; ///< where it may stand, best first; not empty
    double radius = 6.0;
    bool is_positive = true;
    ui::Role role = ui::Role::Label;
};

/// Where the arrow of a load stands, so that a hand can pull it.
struct LoadMark {
    Part load;
    femoop::Dof dof;             ///< along or about which it acts
    std::vector<ui::Point> area; ///< of the arrows, or the two ends of one
    ui::Point root, tip;         ///< from the place it acts at to the end that is pulled
};

/// Where the symbol of a support stands, so that a hand can turn it about its node.
struct SupportMark {
    femoop::NodeId node;
    ui::Point root, middle; ///< the node, and the middle of the symbol
    double radius = 0.0;    ///< about the middle
};

/// Where a dimension line stands, so that a hand can move it.
struct DimensionMark {
    DimensionPlace dimension;
    ui::Point start, end;
};

/// Where a number of the results is written.
struct NumberMark {
    ui::Box box;                 ///< around it
    femoop::MovingEffect number; ///< of a reaction without `dof`: the resultant
    std::optional<RangeEnd> end{};
};

/// What of a picture a hand can take hold of, or point at.
struct Grips {
    std::vector<LoadMark> loads{};
    std::vector<SupportMark> supports{};
    std::vector<DimensionMark> dimensions{};
    std::vector<NumberMark> numbers{};
};

/// Draws the marks of a structure and remembers where they are: labels keep clear of them, and the sheet learns how
/// much room the picture needs.
class Sketch {
public:
    struct Setup {
        ui::Painter* painter;
        const ui::Theme* theme;
        ui::Box room; ///< what the labels may use
        double symbol_factor = 1.0;
        /// Strokes are slim, without the round joins and ends that nobody would see, and where captions crowd lesser
        /// ones are left out.
        bool is_reduced = false;
        bool is_measured = false; ///< for the room that the marks take: nothing is written
    };
    explicit Sketch(const Setup& setup);

    ui::Painter& painter() { return *painter_; }
    const ui::Theme& theme() const { return *theme_; }
    bool is_reduced() const { return is_crowded_; }
    /// A length in the theme's symbol size.
    double px(double logical) const { return logical * symbol_scale_; }
    /// Em of values beside those at extremes and of names of members; on the projector a class reads them all.
    double lesser_value_size() const;
    ui::Stroke stroke(ui::Role role) const;
    ui::Stroke thin(ui::Role role) const; ///< 0.7 of the role's width, solid

    void line(ui::Point a, ui::Point b, const ui::Stroke& stroke, Clearance clearance = Clearance::Hard);
    void polyline(const std::vector<ui::Point>& points, const ui::Stroke& stroke, Clearance clearance = Clearance::Hard,
                  ui::PathEnds ends = ui::PathEnds::Open);
    void polygon(const std::vector<ui::Point>& points, ui::Color fill, Clearance clearance = Clearance::Hard);
    void disc(ui::Point center, double radius, ui::Color fill, Clearance clearance = Clearance::Hard);
    void ring(ui::Point center, double radius, const ui::Stroke& stroke, Clearance clearance = Clearance::Hard);
    /// Labels keep clear of the area as if it were filled.
    void keep_clear(const std::vector<ui::Point>& area);

    /// Labels stay off the area if they can, and on a plate of their own where they cannot.
    void shade(const std::vector<ui::Point>& area);
    /// Does nothing that was drawn so far lie there? So it is while a picture is measured.
    bool is_free(const ui::Box& box);

    /// The same string twice within a few pixels is written once.
    void caption(Caption caption);
    /// Whether a caption would be left out without a look: see Setup::is_crowded.
    bool is_full_at(ui::Point target, Rank rank) const { return crowd_ && crowd_->is_full(target, rank); }
    const ui::Box& room() const { return room_; }
    bool is_in_sight(ui::Point target) const { return room_.contains(target); }
    /// Counts one that is not even made.
    void leave_out(ui::Point target) { n_left_out_ += is_in_sight(target) ? 1 : 0; }

    /// Put where no line runs, on a disc that hides what lies below it; labels keep clear of it.
    void sign(SignMark mark);

    void mark(const NumberMark& mark) { grips_.numbers.push_back(mark); } ///< of one that no caption writes
    std::size_t mark(LoadMark mark); ///< \returns its number, for the caption with the load's value
    void mark(const SupportMark& mark) { grips_.supports.push_back(mark); }
    void mark(const DimensionMark& mark) { grips_.dimensions.push_back(mark); }
    const Grips& grips() const { return grips_; }

    /// Finds places for all signs and captions and writes them. Call once, at the end.
    void write_captions();

    const std::optional<ui::Box>& bounds() const { return bounds_; } ///< of all marks and of the captions' first wishes
    /// As if every caption were as narrow as its target.
    const std::optional<ui::Box>& tight_bounds() const { return tight_bounds_; }
    const std::optional<ui::Box>& mark_bounds() const { return mark_bounds_; } ///< without captions
    void include(ui::Point point);
    /// Labels keep out of a part of the sheet, which counts to no bounds.
    void reserve(const ui::Box& box) { placer_.obstacles().add_box(box); }
    std::size_t n_left_out() const { return n_left_out_; } ///< captions of what is in sight for which there was no room

private:
    struct Request {
        Caption caption;
        ui::TextStyle style;
        ui::Size size;
    };

    struct PlacedSign {
        SignMark mark;
        ui::Point center;
    };

    std::vector<PlacedSign> placed_signs();
    void draw(const PlacedSign& sign);
    /// Captions without room: a value's counts for more than any number of names.
    struct Loss {
        std::size_t n_values = 0, n_captions = 0;
        auto operator<=>(const Loss&) const = default;
    };

    Loss loss(const ui::LabelPlacement& placed) const;
    ui::LabelPlacement placed_captions() const;
    ui::LabelPlacement placed_at_best();
    void write_names_small();
    void write(const Request& request, const ui::PlacedLabel& place);
    void mark_value(std::size_t load_mark, const ui::Box& box);
    void mark_number(const Request& request, const ui::PlacedLabel& place);
    bool is_in_sight(const Caption& caption) const;
    static void unite(std::optional<ui::Box>& bounds, const ui::Box& box);
    ui::TextStyle style_of(const Caption& caption) const;
    ui::Label label_of(const Request& request) const;
    static void add_turned(ui::Label& label, const Caption& caption);
    bool is_obstacle(Clearance clearance) const { return clearance != Clearance::None && !is_measured_; }
    static ui::Firmness firmness(Clearance clearance);
    bool is_said_beside(const Caption& caption);

    ui::Painter* painter_;
    const ui::Theme* theme_;
    double symbol_scale_;
    ui::Box room_;
    bool is_crowded_, is_measured_;
    std::optional<CaptionCrowd> crowd_;
    ui::LabelPlacer placer_;
    std::vector<Request> requests_;
    using Said = std::pair<ui::Role, ui::Point>;
    std::unordered_map<std::string, std::vector<Said>> said_; ///< where each string's requests have their targets
    std::vector<SignMark> signs_;
    Grips grips_;
    std::optional<ui::Box> bounds_, tight_bounds_, mark_bounds_;
    std::size_t n_left_out_ = 0;
};

} // namespace drawing
