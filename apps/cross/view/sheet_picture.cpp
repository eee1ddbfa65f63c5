#include "apps/cross/view/sheet_picture.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "apps/cross/view/block_layout.h"
#include "apps/cross/view/columns.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/sheet_bays.h"
#include "apps/cross/view/sheet_parts.h"
#include "apps/cross/view/sheet_places.h"
#include "apps/cross/view/sheet_storeys.h"
#include "apps/drawing/sheet/legend.h"
#include "apps/drawing/structure/members.h"
#include "apps/drawing/structure/supports.h"
#include "femoop/methods/cross/symmetry.h"
#include "ui/paint/label/oriented_box.h"
#include "ui/paint/text_measure.h"

namespace cross {

namespace fc = femoop::cross;
using fc::RowKind;
using ui::translatable;

namespace {

constexpr std::size_t most_ends_at_once = 80;
constexpr std::size_t least_lines = 4; // of a column, which grows by so many at once
constexpr std::size_t shortest = 2;    // likewise, where longer ones have no room for the last row
constexpr double most_magnified = 4.0; // of numbers that a zoom enlarges
constexpr double usual_above = 1.8;    // ems that columns keep from the top, for the title
constexpr double border = 0.3;         // ems that columns keep from the edges of their picture
constexpr double beam_foot = 0.5;      // likewise those below a beam from the bottom
constexpr double balances_until = 0.6; // of a turn's phase; then the carry-overs fly

std::string title_of(const Scene& scene, bool has_key);

/// Writes one sheet into its boxes.
class SheetWriter {
public:
    SheetWriter(ui::Painter& painter, const Panel& panel, const Scene& scene)
        : painter_(painter),
          panel_(panel),
          scene_(scene),
          problem_(scene.solution.sheet_problem(scene.document)),
          sheet_(scene.solution.sheet(scene.document)),
          theme_(theme_of_marks(panel, scene.look)),
          numbers_(scene.document, scene.solution, scene.look),
          shape_(drawing::shape_of(scene.document.model)),
          moments_(present_moments(scene.document, scene.solution))
    {
        columns_ = sheet_ != nullptr ? columns_of(problem_, *sheet_) : columns_together();
        factors_ = fc::factors_of(problem_, scene.document.method.digits);
        widest_ = widest();
    }

    void lay_out()
    {
        lay_out(wanted_lines(), legible());
        if (!is_sum()) return;
        if (const std::string note = note_of_left_out(); !note.empty())
            taken_.push_back(box_below(painter_, panel_, theme_in(panel_, scene_.look), note));
        key_ = place_of_key();
        if (!key_) make_room_for_long_title();
    }
    /// What the lines of the columns are is written beside them.
    bool has_key() const { return key_.has_value(); }

    /// \pre it is laid out
    void draw()
    {
        const ui::LayerScope layer(painter_, ui::Layer::Labels);
        if (problem_.mirror) draw_axis(*problem_.mirror);
        mark_joints();
        arrows_ = arrows_of_turn();
        for (const Arrow& arrow : arrows_) draw(arrow);
        for (std::size_t e = 0; e < problem_.ends.size(); ++e)
            if (layout_.boxes[e] && layout_.boxes[e]->overlaps(panel_.box)) draw_column(fc::EndId(e));
        if (sheet_ != nullptr && !sheet_->steps.empty()) draw_flights();
        draw_left_out();
        if (key_) draw_key();
    }

    /// Of short columns: the frame stays where it is while they grow.
    const BlockLayout& short_columns(double least_type)
    {
        widest_ = widest_foreseen();
        lay_out(whole_or(least_lines), least_type);
        return layout_;
    }

    /// Lines of columns where storeys are no higher than these need, best first.
    std::vector<std::size_t> lines_of_tight_storeys() const
    {
        if (is_sum()) return {wanted_lines()};
        return {fewest_lines(), shortest};
    }

    /// Of a column where there is little room.
    double tight_width(double type)
    {
        widest_ = widest_foreseen();
        return type * (widest_ + 0.6);
    }

    ColumnNeeds column_needs() const
    {
        return {.ems = column_width(1.0),
                .largest_type = largest_type(),
                .least_type = BlockRequest().least_type,
                .support = support_reach(theme_),
                .n_rows = panel_.columns == BeamColumns::InTurn ? 2u : 1u};
    }

    DrawnSheet report() const
    {
        const auto n = std::ranges::count_if(layout_.boxes, [](const auto& box) { return !box; });
        return {static_cast<std::size_t>(n), layout_.type, way_to_turn()};
    }

    /// Of those that are laid out: of a large structure not all are.
    bool has_room_for_all() const
    {
        for (std::size_t e = 0; e < problem_.ends.size(); ++e)
            if (!layout_.boxes[e] && room_.contains(joint_place(problem_.ends[e].node))) return false;
        return true;
    }

    /// Size of the least numbers.
    double legible() const
    {
        const double least = legible_type(scene_.look.full_theme());
        return std::max(BlockRequest().least_type, is_beam(shape_) ? std::min(least, type_beside_beam()) : least);
    }

private:
    /// All sheets together.
    bool is_sum() const { return sheet_ == nullptr; }
    /// Numbers are written there: of the sheet's half, where it is one.
    bool is_worked(fc::EndId end) const { return is_sum() || problem_.is_on_sheet(end); }
    bool has_factor(fc::EndId end) const
    {
        return problem_.is_on_sheet(end) && problem_[end].joint && problem_.is_balanced(*problem_[end].joint);
    }

    /// Columns side by side have their lines at one height; that of a foot stands alone.
    bool has_place_of_factor(fc::EndId end) const
    {
        const ui::Point along = place_of_end(panel_, shape_, problem_, end, theme_).along;
        return problem_[end].joint || std::abs(along.x) > std::abs(along.y);
    }

    /// Line by line the loads and so much of every sway.
    std::vector<Column> columns_together() const
    {
        const std::vector<SheetPart> parts = parts_of(scene_);
        std::vector<Column> columns;
        for (std::size_t e = 0; e < problem_.ends.size(); ++e) {
            Column& column = columns.emplace_back(Column{.end = fc::EndId(e), .cells = {}, .n_levels = parts.size()});
            for (std::size_t i = 0; i < parts.size(); ++i)
                column.cells.push_back({.kind = RowKind::CarryOver, .value = parts[i].moments[e], .level = i});
        }
        return columns;
    }

    // ---- where everything stands

    /// Which has several lines in a narrow picture.
    void make_room_for_long_title()
    {
        const ui::Theme theme = theme_in(panel_, scene_.look);
        above_ = title_box(painter_, panel_, title_of(scene_, false), theme).height() / theme.type().normal;
        if (above_ > usual_above) lay_out(wanted_lines(), legible());
    }

    ui::Point joint_place(femoop::NodeId node) const { return panel_.at(shape_[node]); }

    void lay_out(std::size_t n_lines, double least_type)
    {
        BlockRequest request;
        for (std::size_t e = 0; e < problem_.ends.size(); ++e) {
            request.places.push_back(place_of_end(panel_, shape_, problem_, fc::EndId(e), theme_));
            request.places.back().has_box = has_place_of_factor(fc::EndId(e));
        }
        const auto is_balanced = [this](const EndPlace& place) { return has_factor(place.end); };
        std::stable_partition(request.places.begin(), request.places.end(), is_balanced); // joints have most to write
        const double em = theme_in(panel_, scene_.look).type().normal;
        request.room = panel_.whole.grown(-border * em);
        request.room.min.y += std::max(usual_above, above_) * em;
        if (request.places.size() > most_ends_at_once) request.room = in_sight(request.room);
        request.walls = walls_in(panel_, shape_);
        request.obstacles = obstacles_in(panel_, shape_, scene_.document.model, theme_);
        request.largest_type = largest_type();
        request.least_type = least_type;
        request.n_rows = 3;
        const bool is_enlarged = scene_.look.zoom.is_of_sheet; // a beam along its axis
        if (is_beam(shape_) && (is_read_from_afar() || is_enlarged)) request.n_rows = 1;
        if (is_beam(shape_) && is_enlarged)
            request.room.max.y = std::min(request.room.max.y, panel_.box.max.y - foot() * em);
        if (is_beam(shape_)) request.hardly_smaller = 0.65; // columns of a beam are read along it
        request.most_lines = n_lines;
        request.fewest_lines = std::min(n_lines, fewest_lines());
        request.last_resort = whole_or(request.last_resort);
        request.width_of = [this](double type) { return column_width(type); };
        request.middle = middle_of(panel_, shape_);
        layout_ = laid_out(request);
        if (is_read_from_afar() && !is_whole(layout_)) {
            request.fewest_lines = std::min(n_lines, whole_or(shortest));
            layout_ = laid_out(request);
        }
        taken_ = std::move(request.obstacles);
        room_ = request.room;
        std::vector<std::optional<ui::Box>> by_end(problem_.ends.size());
        for (std::size_t i = 0; i < request.places.size(); ++i) by_end[request.places[i].end.index] = layout_.boxes[i];
        layout_.boxes = std::move(by_end);
    }

    double foot() const { return panel_.columns == BeamColumns::InTurn ? border : beam_foot; }

    /// Of the shortest columns that reach from a beam to the foot of its picture, which no zoom makes higher, and to the
    /// heading where some stand above it.
    double type_beside_beam() const
    {
        const double em = theme_in(panel_, scene_.look).type().normal, beam = panel_.at(shape_.nodes.front()).y;
        const bool is_in_turn = panel_.columns == BeamColumns::InTurn;
        const double below = panel_.box.max.y - foot() * em - beam;
        const double above = is_in_turn ? beam - panel_.box.min.y - (border + usual_above) * em : below;
        const double lines = static_cast<double>(is_in_turn ? shortest : fewest_lines());
        const double ems = column_gap + head_height + line_height * lines + total_height;
        return (std::min(below, above) - (is_in_turn ? 0.1 : 1.0)) / ems; // something to spare
    }

    double largest_type() const
    {
        const double usual = 1.05 * theme_in(panel_, scene_.look).type().normal;
        return std::max(usual * std::clamp(panel_.zoom, 1.0, most_magnified), legible_type(scene_.look.full_theme()));
    }

    /// Of a large structure only what is seen is laid out.
    ui::Box in_sight(const ui::Box& room) const
    {
        return ui::intersection(panel_.box.grown(0.25 * panel_.box.width()), room);
    }

    /// So many that columns grow, and move, only now and then.
    std::size_t wanted_lines() const
    {
        constexpr std::size_t most = 16;
        if (is_sum()) return std::clamp<std::size_t>(n_levels(), 1, most); // it does not grow
        return std::clamp((n_levels() + least_lines - 1) / least_lines * least_lines, least_lines, most);
    }

    bool is_read_from_afar() const { return legible_type(scene_.look.full_theme()) > 0.0; }

    /// So many lines; but without one of its terms a sum is none.
    std::size_t whole_or(std::size_t n_lines) const { return is_sum() ? wanted_lines() : n_lines; }
    /// From afar rather in larger type than with more lines.
    std::size_t fewest_lines() const { return whole_or(is_read_from_afar() ? least_lines - 1 : least_lines); }

    double column_width(double type) const { return type * (widest_ + (panel_.is_tight() ? 0.6 : 0.9)); }

    /// The broadest number of the sheet, in ems.
    double widest() const
    {
        constexpr double em = 16.0;
        double widest = 0.0;
        const ui::TextStyle style{.size = em, .weight = ui::Weight::Bold};
        const auto consider = [&](const std::string& text) {
            widest = std::max(widest, painter_.measure(text, style).width / em);
        };
        for (std::size_t e = 0; e < problem_.ends.size(); ++e) {
            consider(numbers_.moment(problem_.ends[e], -std::abs(problem_.loading.fixed_end[e])));
            consider(numbers_.moment(problem_.ends[e], -std::abs(moments_[e])));
            consider(numbers_.factor(factors_[e]));
            if (sheet_ != nullptr) consider(numbers_.moment(problem_.ends[e], -std::abs(sheet_->start.moments[e])));
        }
        if (scene_.document.method.digits > 0) // small numbers have most decimals
            for (const Column& column : columns_)
                for (const Cell& cell : column.cells)
                    consider(numbers_.moment(problem_[column.end], -std::abs(cell.value)));
        return widest;
    }

    /// What hardly a number of the sheet will exceed, so that no turn changes it.
    double widest_foreseen() const
    {
        constexpr double em = 16.0, growth = 1.5;
        double largest = 0.0;
        for (const double moment : problem_.loading.fixed_end) largest = std::max(largest, std::abs(moment));
        const ui::TextStyle style{.size = em, .weight = ui::Weight::Bold};
        return painter_.measure(numbers_.moment(-growth * largest), style).width / em;
    }

    // ---- what stands there

    ui::TextStyle style(ui::Role role, ui::Anchor anchor, ui::Weight weight = ui::Weight::Regular) const
    {
        ui::TextStyle text = theme_.text(role, anchor);
        text.size = layout_.type;
        text.weight = weight;
        return text;
    }

    double line(double n) const { return n * line_height * layout_.type; }

    /// The lines that the columns have used, of all; and how many of them the boxes show.
    std::size_t n_levels() const
    {
        std::size_t most = 0;
        for (const Column& column : columns_)
            if (is_sum() || problem_.is_on_sheet(column.end)) most = std::max(most, column.n_levels);
        return most;
    }
    std::size_t n_shown() const { return std::min(n_levels(), layout_.n_lines); }

    /// Short columns have no line for what is gone: its sign stands beside the first number after it.
    bool is_short() const { return layout_.n_lines < least_lines; }

    /// Lines above the first level that is still there: the fixed-end moment and one that says what is gone. In the
    /// shortest column the moment goes too after all joints at once, which leave a balance and a carry-over.
    std::size_t n_head_lines() const
    {
        const bool is_of_all = sheet_ != nullptr && !sheet_->steps.empty() && !sheet_->steps.back().joint;
        if (!is_short()) return 2;
        return is_of_all && layout_.n_lines <= shortest ? 0 : 1;
    }

    /// Of a joint's columns together.
    std::size_t n_used(const Column& column) const
    {
        std::size_t used = column.n_levels;
        if (const auto joint = problem_[column.end].joint)
            for (const fc::EndId end : problem_[*joint].ends) used = std::max(used, columns_[end.index].n_levels);
        return used;
    }
    bool is_overfull(const Column& column) const { return n_used(column) > layout_.n_lines; }

    /// First level below the fixed-end moments that is still there.
    std::size_t first_shown(const Column& column) const
    {
        return is_overfull(column) ? n_used(column) - (layout_.n_lines - n_head_lines()) : 1;
    }

    /// Middle of the right end of a line.
    ui::Point line_at(fc::EndId end, double n) const
    {
        const ui::Box& box = *layout_.boxes[end.index];
        const double head = has_place_of_factor(end) ? head_height : bare_head_height;
        return {box.max.x - 0.4 * layout_.type, box.min.y + head * layout_.type + line(n + 0.5)};
    }

    ui::Point place_of(const Column& column, const Cell& cell) const
    {
        if (cell.level == 0) return line_at(column.end, 0.0);
        const std::size_t first = first_shown(column), above = is_overfull(column) ? n_head_lines() : 1;
        return line_at(column.end, static_cast<double>(above + cell.level - first));
    }

    bool is_shown(const Column& column, const Cell& cell) const
    {
        if (cell.level == 0) return !is_overfull(column) || n_head_lines() > 0;
        return cell.level >= first_shown(column);
    }

    bool is_last_turn(const Cell& cell) const
    {
        return sheet_ != nullptr && cell.step > 0 && cell.step == sheet_->steps.size();
    }

    void draw_column(fc::EndId id)
    {
        const ui::Box& box = *layout_.boxes[id.index];
        draw_head(id, box);
        if (is_worked(id)) draw_cells(columns_[id.index]);
        draw_total(id, box);
    }

    void draw_head(fc::EndId id, const ui::Box& box)
    {
        const fc::End& end = problem_[id];
        const double em = layout_.type, middle = 0.5 * (box.min.x + box.max.x);
        ui::TextStyle name = style(ui::Role::FaintLabel, ui::Anchor::Center);
        name.size *= 0.9;
        write_over_arrows({middle, box.min.y + 0.55 * em},
                          head_within(painter_, scene_.document.model, end, name, box.width()), name);
        if (!has_factor(id)) return;
        const ui::Box frame{{box.min.x + 0.15 * em, box.min.y + 1.1 * em},
                            {box.max.x - 0.05 * em, box.min.y + 2.55 * em}};
        ui::Stroke stroke = theme_.stroke(ui::Role::Label);
        stroke.width = std::max(1.0, 0.07 * em);
        painter_.polyline({frame.min, {frame.max.x, frame.min.y}, frame.max, {frame.min.x, frame.max.y}}, stroke,
                          ui::PathEnds::Closed);
        write_over_arrows(frame.center(), numbers_.factor(factors_[id.index]),
                          style(ui::Role::Label, ui::Anchor::Center));
    }

    void draw_cells(const Column& column)
    {
        if (is_overfull(column)) draw_gone(column);
        for (const Cell& cell : column.cells) {
            if (!is_shown(column, cell)) continue;
            const ui::Point at = place_of(column, cell);
            const bool is_flying = is_last_turn(cell) && scene_.phase < 1.0;
            if (!is_flying) write(column, cell, at);
            if (cell.kind == RowKind::Balance && !is_flying) underline(column, at);
        }
    }

    /// The sign of numbers that have left the column.
    void draw_gone(const Column& column)
    {
        const ui::TextStyle sign = style(ui::Role::FaintLabel, ui::Anchor::Right);
        const auto line = static_cast<double>(is_short() ? n_head_lines() : 1);
        const double before = is_short() ? 0.3 * layout_.type + width_of_first(column) : 0.8 * layout_.type;
        write_over_arrows(line_at(column.end, line) - ui::Point{before, 0.0}, "⋮", sign);
    }

    double width_of_first(const Column& column) const
    {
        const auto is_first = [&](const Cell& cell) { return cell.level == first_shown(column); };
        const auto first = std::ranges::find_if(column.cells, is_first);
        if (first == column.cells.end()) return 0.5 * layout_.type;
        const ui::TextStyle bold = style(ui::Role::Label, ui::Anchor::Right, ui::Weight::Bold);
        return painter_.measure(numbers_.moment(problem_[column.end], first->value), bold).width;
    }

    void write(const Column& column, const Cell& cell, ui::Point at, std::optional<ui::Color> plate = {})
    {
        const bool is_last = is_last_turn(cell);
        const ui::Role role = !is_last                        ? ui::Role::Label
                              : cell.kind == RowKind::Balance ? ui::Role::Changed
                                                              : ui::Role::Created;
        const ui::Weight weight = is_last ? ui::Weight::Bold : ui::Weight::Regular;
        ui::TextStyle text = style(role, ui::Anchor::Right, weight);
        text.plate = plate;
        write_over_arrows(at, numbers_.moment(problem_[column.end], cell.value), text);
    }

    void underline(const Column& column, ui::Point at)
    {
        const ui::Box& box = *layout_.boxes[column.end.index];
        ui::Stroke stroke = theme_.stroke(ui::Role::Label);
        stroke.width = std::max(0.8, 0.05 * layout_.type);
        const double y = at.y + line(0.48);
        painter_.line({box.min.x + 0.2 * layout_.type, y}, {box.max.x, y}, stroke);
    }

    void draw_total(fc::EndId id, const ui::Box& box)
    {
        const double n = is_worked(id) ? static_cast<double>(n_shown()) : 0.0;
        const ui::Point at = line_at(id, n + 0.12);
        rule_sum(box, at.y);
        write_over_arrows(at, numbers_.moment(problem_[id], total(id)),
                          style(ui::Role::BendingMoment, ui::Anchor::Right, ui::Weight::Bold));
    }

    /// Two lines over a sum that stands at this height.
    void rule_sum(const ui::Box& box, double middle)
    {
        ui::Stroke stroke = theme_.stroke(ui::Role::Label);
        stroke.width = std::max(1.0, 0.06 * layout_.type);
        for (const double lift : {0.56, 0.42}) {
            const double y = middle - line(lift);
            painter_.line({box.min.x + 0.1 * layout_.type, y}, {box.max.x, y}, stroke);
        }
    }

    /// A number that still flies is not counted.
    double total(fc::EndId id) const
    {
        double sum = moments_[id.index];
        if (is_sum() || scene_.phase >= 1.0) return sum;
        for (const Cell& cell : columns_[id.index].cells)
            if (is_last_turn(cell)) sum -= cell.value;
        return sum;
    }

    // ---- what the lines of all sheets together are

    ui::TextStyle key_style(bool is_sum) const
    {
        ui::TextStyle text = is_sum ? style(ui::Role::BendingMoment, ui::Anchor::Left, ui::Weight::Bold)
                                    : style(ui::Role::FaintLabel, ui::Anchor::Left);
        text.size *= 0.9;
        return text;
    }

    /// Line by line as they stand in the columns: "loads", "0.299 × sway at B", "sum".
    std::vector<std::string> key_names() const
    {
        std::vector<std::string> names;
        for (const SheetPart& part : parts_of(scene_)) names.push_back(cross::words_of(part, scene_));
        names.push_back(scene_.look.tr("sum"));
        return names;
    }

    void draw_key()
    {
        const std::vector<std::string> names = key_names();
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool is_sum = i + 1 == names.size();
            const double n = static_cast<double>(i) + (is_sum ? 0.62 : 0.5);
            painter_.text(key_->min + ui::Point{0.5 * layout_.type, line(n)}, names[i], key_style(is_sum));
            if (is_sum) rule_sum(*key_, key_->min.y + line(n));
        }
    }

    /// Beside the lines of a column; where none has room, as near to the first as may be.
    std::optional<ui::Box> place_of_key() const
    {
        const std::vector<std::string> names = key_names();
        const double em = layout_.type;
        double widest = 0.0;
        for (const std::string& name : names) widest = std::max(widest, painter_.measure(name, key_style(true)).width);
        const ui::Size size{widest + em, line(static_cast<double>(names.size()) + 0.2)};
        std::optional<ui::Point> first;
        for (std::size_t e = 0; e < layout_.boxes.size(); ++e) {
            const std::optional<ui::Box>& box = layout_.boxes[e];
            if (!box) continue;
            const double top = line_at(fc::EndId(e), -0.5).y;
            for (const double left : {box->max.x, box->min.x - size.width})
                if (const ui::Box beside = ui::box_at({left, top}, size); is_free(beside.grown(-1.0))) return beside;
            if (!first) first = box->min;
        }
        constexpr double apart = 2.0; // nearer to other lines it would seem to name those
        std::optional<ui::Box> best;
        for (double y = room_.min.y; first && y + size.height <= room_.max.y; y += em)
            for (double x = room_.min.x; x + size.width <= room_.max.x; x += em) {
                const ui::Box box = ui::box_at({x, y}, size);
                if (best && ui::distance(box.min, *first) >= ui::distance(best->min, *first)) continue;
                if (is_free(box.grown(0.5 * em)) && !overlaps_column(box.grown(apart * em))) best = box;
            }
        return best;
    }

    bool is_free(const ui::Box& box) const
    {
        const auto is_hit = [&](const ui::Box& other) { return other.overlaps(box); };
        return room_.contains(box) && panel_.box.contains(box) && std::ranges::none_of(taken_, is_hit) &&
               !overlaps_column(box);
    }

    bool overlaps_column(const ui::Box& box) const
    {
        const auto is_column = [&](const std::optional<ui::Box>& other) { return other && other->overlaps(box); };
        return std::ranges::any_of(layout_.boxes, is_column);
    }

    /// The axis of symmetry, over the whole picture.
    void draw_axis(const fc::Mirror& mirror)
    {
        const ui::LayerScope layer(painter_, ui::Layer::Lines);
        const double x = panel_.at({mirror.x, 0.0, 0.0}).x, em = theme_.type().normal;
        ui::Stroke stroke = theme_.stroke(ui::Role::Dimension);
        stroke.dash = {1.2 * em, 0.3 * em, 0.15 * em, 0.3 * em};
        painter_.line({x, panel_.box.min.y + 2.2 * em}, {x, panel_.box.max.y - 0.3 * em}, stroke);
        ui::TextStyle text = theme_.text(ui::Role::Dimension, ui::Anchor::BottomLeft);
        text.size = theme_.type().small;
        painter_.text({x + 0.5 * em, panel_.box.max.y - 2.0 * em}, words_of(mirror.kind), text);
    }

    /// "symmetric: BC 2EI/L"; where many members cross the axis the first word alone.
    std::string words_of(fc::SymmetryKind kind) const
    {
        constexpr std::size_t most = 4;
        const bool is_symmetric = kind == fc::SymmetryKind::Symmetric;
        const std::string word = is_symmetric ? scene_.look.tr("symmetric") : scene_.look.tr("antisymmetric");
        const std::vector<fc::EndId> crossing = fc::crossing_ends(problem_);
        if (crossing.size() > most) return word;
        std::string words;
        for (const fc::EndId end : crossing)
            words += (words.empty() ? ": " : ", ") + problem_[end].label + " " + std::string(formula(problem_, end));
        return word + words;
    }

    /// A ring around the joint that was balanced last and its mirror image, and one around what the pointer is on.
    void mark_joints()
    {
        const double r = 8.0 * theme_.symbol_scale();
        const auto ring = [&](fc::JointId joint, ui::Role role) {
            ui::Stroke stroke = theme_.stroke(role);
            stroke.width = 2.6 * theme_.symbol_scale();
            stroke.dash = {};
            painter_.circle(joint_place(problem_[joint].node), r, stroke);
        };
        for (std::size_t j = 0; j < problem_.joints.size(); ++j)
            if (sheet_ != nullptr && !sheet_->steps.empty() && sheet_->steps.back().joint &&
                problem_.balanced_for(fc::JointId(j)) == sheet_->steps.back().joint)
                ring(fc::JointId(j), ui::Role::Changed);
        if (scene_.hover) ring(*scene_.hover, ui::Role::Hover);
    }

    // ---- the last turn

    std::optional<ui::Point> cell_of_last_turn(fc::EndId end, RowKind kind) const
    {
        if (!layout_.boxes[end.index] || !problem_.is_on_sheet(end)) return std::nullopt;
        const Column& column = columns_[end.index];
        for (const Cell& cell : column.cells)
            if (is_last_turn(cell) && cell.kind == kind && is_shown(column, cell)) return place_of(column, cell);
        return std::nullopt;
    }

    void draw_flights()
    {
        for (const Column& column : columns_) {
            if (!layout_.boxes[column.end.index]) continue;
            for (const Cell& cell : column.cells)
                if (problem_.is_on_sheet(column.end) && is_last_turn(cell)) draw_flight(column, cell);
        }
    }

    /// That was balanced last, or whose turn it is; where all are at once the one that a reader begins at.
    std::optional<fc::JointId> joint_of_turn() const
    {
        std::optional<fc::JointId> joint;
        if (sheet_ != nullptr && !sheet_->steps.empty()) joint = sheet_->steps.back().joint;
        else if (sheet_ != nullptr) joint = next_turn(scene_.document, scene_.solution).value_or(std::nullopt);
        return joint ? joint : first_joint();
    }

    /// Of the uppermost the leftmost.
    std::optional<fc::JointId> first_joint() const
    {
        std::optional<fc::JointId> first;
        const auto key = [&](fc::JointId j) {
            const ui::Point at = joint_place(problem_[j].node);
            return std::pair(std::round(at.y), at.x);
        };
        for (std::size_t j = 0; j < problem_.joints.size(); ++j)
            if (!first || key(fc::JointId(j)) < key(*first)) first = fc::JointId(j);
        return first;
    }

    /// The columns of its joint, and with them those of the far ends as far as both are seen at once.
    std::optional<ui::Point> way_to_turn() const
    {
        const auto joint = joint_of_turn();
        if (!joint || !panel_.is_zoomed) return std::nullopt;
        const ui::Theme theme = theme_in(panel_, scene_.look);
        const ui::Box title = title_box(painter_, panel_, title_of(scene_, has_key()), theme);
        const ui::Box sight = sight_below(title, panel_, theme);
        std::optional<ui::Box> seen;
        const auto add = [&](fc::EndId end) {
            if (!layout_.boxes[end.index]) return;
            const ui::Box all = seen ? ui::united(*seen, *layout_.boxes[end.index]) : *layout_.boxes[end.index];
            const bool fits = all.width() <= sight.width() && all.height() <= sight.height();
            if (fits || !seen) seen = all;
        };
        for (const fc::EndId end : problem_[*joint].ends) add(end);
        if (!seen) seen = around(joint_place(problem_[*joint].node));
        for (const fc::EndId end : problem_[*joint].ends)
            if (const auto far = problem_[end].far) add(*far);
        return way_into_sight(*seen, sight);
    }

    /// Where the columns of a joint may stand that is not laid out, since it is far out of sight.
    ui::Box around(ui::Point joint) const
    {
        return ui::Box{joint, joint}.grown(8.0 * theme_in(panel_, scene_.look).type().normal);
    }

    void draw_flight(const Column& column, const Cell& cell)
    {
        if (!is_shown(column, cell)) return;
        const ui::Point to = place_of(column, cell);
        const fc::End& end = problem_[column.end];
        if (cell.kind == RowKind::Balance) {
            fly(column, cell, joint_place(end.node), to, scene_.phase / balances_until);
            return;
        }
        const auto from = end.far ? cell_of_last_turn(*end.far, RowKind::Balance) : std::nullopt;
        if (!from) return fly(column, cell, to, to, 1.0);
        fly(column, cell, *from, to, share_carried());
    }

    /// Of the way from a balance to what it carries over; before the turn comes to that, negative.
    double share_carried() const { return (scene_.phase - balances_until) / (1.0 - balances_until); }

    void fly(const Column& column, const Cell& cell, ui::Point from, ui::Point to, double share)
    {
        if (scene_.phase >= 1.0 || share <= 0.0) return;
        write(column, cell, from + std::min(1.0, share) * (to - from), theme_.background());
    }

    /// From a balance to what it carries over, as far as it has come.
    struct Arrow {
        ui::Point tail, tip;
    };

    std::vector<Arrow> arrows_of_turn() const
    {
        const double share = std::min(1.0, share_carried());
        std::vector<Arrow> arrows;
        if (share <= 0.0) return arrows;
        for (const Column& column : columns_) {
            const auto& far = problem_[column.end].far;
            const auto to = cell_of_last_turn(column.end, RowKind::CarryOver);
            const auto from = far ? cell_of_last_turn(*far, RowKind::Balance) : std::nullopt;
            if (!from || !to) continue;
            const Arrow arrow = arrow_between(*from, *to, joint_place(problem_[column.end].node), share);
            if (ui::distance(arrow.tail, arrow.tip) >= 1.2 * layout_.type) arrows.push_back(arrow);
        }
        return arrows;
    }

    Arrow arrow_between(ui::Point from, ui::Point to, ui::Point joint, double share) const
    {
        const double em = layout_.type, width = column_width(em);
        // Along a column of the frame it runs down beside the numbers, away from the member.
        const bool is_upright = std::abs(to.x - from.x) < 0.6 * width;
        const bool leaves_right = is_upright ? from.x - 0.5 * width > joint.x : to.x > from.x;
        const ui::Point right{0.5 * em, 0.0}, left{-width, 0.0};
        const ui::Point a = from + (leaves_right ? right : left), b = to + (leaves_right == is_upright ? right : left);
        return {a, a + share * (b - a)};
    }

    void draw(const Arrow& arrow)
    {
        const ui::LayerScope layer(painter_, ui::Layer::Lines);
        const double em = layout_.type;
        const auto& [tail, tip] = arrow;
        const ui::Point d = ui::direction(tip - tail), n = ui::left_normal(d);
        ui::Stroke stroke = theme_.stroke(ui::Role::Created);
        stroke.width = 0.09 * em;
        painter_.line(tail, tip - 0.5 * em * d, stroke);
        painter_.polygon({tip, tip - 0.75 * em * d + 0.28 * em * n, tip - 0.75 * em * d - 0.28 * em * n}, stroke.color);
    }

    /// Where an arrow runs below a string, that has a ground to be read on.
    void write_over_arrows(ui::Point at, const std::string& words, ui::TextStyle text)
    {
        const ui::Box box = ui::text_box(painter_.fonts(), at, words, text).grown(0.1 * layout_.type);
        const ui::OrientedBox around(box.center(), box.size());
        const auto is_below = [&](const Arrow& arrow) { return around.meets_segment(arrow.tail, arrow.tip); };
        if (std::ranges::any_of(arrows_, is_below)) text.plate = theme_.background();
        painter_.text(at, words, text);
    }

    /// "" where every column that is seen has room.
    std::string note_of_left_out() const
    {
        std::size_t n = 0;
        for (std::size_t e = 0; e < layout_.boxes.size(); ++e)
            n += !layout_.boxes[e] && panel_.box.contains(joint_place(problem_.ends[e].node)) ? 1 : 0;
        if (n == 0) return "";
        // Who has zoomed in sees columns below it: there it is short.
        const std::string_view words = panel_.is_zoomed
                                           ? translatable("columns without room: {count}")
                                           : translatable(
                                                 "member ends without room for their columns: {count}; zoom in, "
                                                 "or see the panel Table");
        return scene_.look.tr(words, {{"count", std::to_string(n)}});
    }

    void draw_left_out()
    {
        if (const std::string note = note_of_left_out(); !note.empty())
            write_below(painter_, panel_, theme_in(panel_, scene_.look), note);
    }

    ui::Painter& painter_;
    const Panel& panel_;
    const Scene& scene_;
    const fc::Problem& problem_;
    const fc::Sheet* sheet_;
    ui::Theme theme_;
    Numbers numbers_;
    drawing::StructureShape shape_;
    std::vector<double> moments_, factors_;
    std::vector<Column> columns_;
    double widest_ = 0.0;        // number
    double above_ = usual_above; // ems of the title
    BlockLayout layout_;         // its boxes by end
    std::vector<ui::Box> taken_; // by the structure
    ui::Box room_;
    std::optional<ui::Box> key_;
    std::vector<Arrow> arrows_; // of the last turn
};

std::string stage_name(const Scene& scene)
{
    const ui::Catalogue& tr = scene.look.tr;
    const fc::Problem& problem = scene.solution.task->problem;
    const std::size_t stage = scene.document.stage;
    if (problem.sways.empty()) return tr("Calculation sheet");
    if (stage == 0) return tr("Sheet of the loads, sways propped");
    if (stage > problem.sways.size()) return tr("All sheets together");
    const femoop::NodeId prop = problem.sways[stage - 1].prop;
    return tr("Sheet of the sway at {node}", {{"node", scene.document.model[prop].id}});
}

/// "loads + 0.312 × sway at B".
std::string sum_description(const Scene& scene)
{
    std::string words;
    for (const SheetPart& part : parts_of(scene)) words += (words.empty() ? "" : " + ") + words_of(part, scene);
    return words;
}

std::string title_of(const Scene& scene, bool has_key)
{
    const ui::Catalogue& tr = scene.look.tr;
    const Numbers numbers(scene.document, scene.solution, scene.look);
    std::string title = stage_name(scene) + " [" + numbers.moment_unit() + "]";
    const fc::Sheet* const sheet = scene.solution.sheet(scene.document);
    if (sheet == nullptr) return has_key ? title : title + ": " + sum_description(scene);
    if (sheet->steps.empty()) return title + tr(": every joint locked");
    const auto joint = sheet->steps.back().joint;
    const std::string step = std::to_string(sheet->steps.size());
    if (!joint) return title + tr(": step {n}, all joints at once", {{"n", step}});
    const std::string& name = scene.document.model[scene.solution.task->problem[*joint].node].id;
    return title + tr(": step {n}, joint {joint}", {{"n", step}, {"joint", name}});
}

} // namespace

DrawnSheet draw_sheet(ui::Painter& painter, const Panel& panel, const Scene& scene)
{
    SheetWriter writer(painter, panel, scene);
    writer.lay_out();
    draw_title(painter, panel, title_of(scene, writer.has_key()), theme_in(panel, scene.look));
    draw_structure_in(painter, panel, scene, {}, [](const drawing::Scene& in) {
        drawing::draw_members(in, drawing::Presence::Subject);
        {
            const ui::LayerScope layer(in.sketch.painter(), ui::Layer::Symbols);
            drawing::draw_supports(in);
        }
        drawing::draw_joints(in);
    });
    const ui::ClipScope clip(painter, panel.box);
    writer.draw();
    return writer.report();
}

namespace {

/// Short columns in storeys no higher than these need; nothing where they have no room.
std::optional<FittedSheet> fitted_storeys(ui::Painter& painter, const Panel& whole, const Scene& scene, double type)
{
    const ui::Theme theme = scene.look.full_theme();
    const drawing::StructureShape shape = drawing::shape_of(scene.document.model);
    for (const std::size_t n_lines : SheetWriter(painter, whole, scene).lines_of_tight_storeys())
        for (const TopColumns top : {TopColumns::Above, TopColumns::Below}) {
            const double width = SheetWriter(painter, whole, scene).tight_width(type);
            const StoreyNeeds needs{.type = type, .width = width, .n_lines = n_lines, .top = top};
            FittedSheet fitted{.room = tight_room(needs, theme)};
            Panel tried = whole;
            tried.storeys = storeys_to_scale(shape);
            make_room(tried, shape, theme, fitted.room);
            tried.storeys = fitted.storeys = storey_scale_for(shape, tried, needs);
            if (tried.storeys.is_to_scale()) continue;
            fitted.layout = SheetWriter(painter, tried, scene).short_columns(type);
            if (is_whole(fitted.layout)) return fitted;
        }
    return std::nullopt;
}

FittedSheet fitted_sheet(ui::Painter& painter, const Panel& whole, const Scene& scene, double least_type)
{
    const drawing::StructureShape shape = drawing::shape_of(scene.document.model);
    FittedSheet best{.layout = SheetWriter(painter, whole, scene).short_columns(least_type)};
    for (const SheetRoom& room : rooms_tried(scene.look.full_theme())) {
        Panel tried = whole;
        make_room(tried, shape, scene.look.full_theme(), room);
        const BlockLayout other = SheetWriter(painter, tried, scene).short_columns(least_type);
        if (is_better(other, best.layout)) best = {.room = room, .storeys = {}, .layout = other};
    }
    return best;
}

} // namespace

FittedSheet fitted_sheet(ui::Painter& painter, const Panel& whole, const Scene& scene)
{
    if (2 * scene.document.model.members.size() > most_ends_at_once) return {};
    if (const double legible = legible_type(scene.look.full_theme()); legible > 0.0) {
        FittedSheet best = fitted_sheet(painter, whole, scene, legible);
        if (!is_whole(best.layout) || best.layout.clarity < 1.0)
            if (auto tight = fitted_storeys(painter, whole, scene, legible);
                tight && is_better(tight->layout, best.layout))
                best = *std::move(tight);
        if (is_whole(best.layout)) return best;
    }
    return fitted_sheet(painter, whole, scene, BlockRequest().least_type);
}

bool is_legible(ui::Painter& painter, const Panel& panel, const Scene& scene)
{
    SheetWriter writer(painter, panel, scene);
    writer.short_columns(writer.legible());
    return writer.has_room_for_all();
}

ColumnNeeds column_needs(ui::Painter& painter, const Panel& whole, const Scene& scene)
{
    return SheetWriter(painter, whole, scene).column_needs();
}

std::vector<Bay> bays_of_sheet(const Scene& scene)
{
    const fc::Problem& problem = scene.solution.sheet_problem(scene.document);
    std::vector<fc::EndId> ends;
    for (std::size_t e = 0; e < problem.ends.size(); ++e) ends.emplace_back(e);
    return bays_of(drawing::shape_of(scene.document.model), problem, ends);
}

BayScale sheet_bays(ui::Painter& painter, const Panel& whole, const Scene& scene)
{
    if (!is_beam(drawing::shape_of(scene.document.model))) return {};
    return bay_scale_for(bays_of_sheet(scene), whole, column_needs(painter, whole, scene));
}

} // namespace cross
