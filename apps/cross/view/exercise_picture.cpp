#include "apps/cross/view/exercise_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "apps/cross/view/blank_columns.h"
#include "apps/cross/view/block_layout.h"
#include "apps/cross/view/exercise_panels.h"
#include "apps/cross/view/given.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/sheet_bays.h"
#include "apps/cross/view/sheet_places.h"
#include "apps/cross/view/structure_pictures.h"
#include "apps/cross/view/verdict_mark.h"
#include "apps/drawing/structure/members.h"
#include "apps/drawing/structure/supports.h"
#include "ui/paint/wrapped_lines.h"

namespace cross {

namespace fc = femoop::cross;
using fc::Asked;

namespace {

constexpr double name_height = 1.15; // of the size of type
constexpr double cell_height = 1.2;
constexpr double label_size = 0.8;
constexpr double usual_cells = 1.1;              // size of type, of the usual one
constexpr double largest_cells = 1.7;            // likewise, where all find room beside their member ends
constexpr double most_magnified_cells = 3.0;     // of cells that a zoom enlarges
constexpr double least_cells = 7.0;              // [px]
constexpr std::size_t lines_of_head_and_sum = 2; // that a block has besides those that it is asked for

std::string worksheet_title_of(const Scene& scene);

/// Writes the cells of one sheet into their boxes.
class WorksheetWriter {
public:
    WorksheetWriter(ui::Painter& painter, const Panel& panel, const Scene& scene, Drawn& drawn)
        : painter_(painter),
          panel_(panel),
          scene_(scene),
          worksheet_(*scene.worksheet),
          problem_(worksheet_.form.problem),
          drawn_(drawn),
          theme_(theme_in(panel, scene.look)),
          marks_(theme_of_marks(panel, scene.look)),
          shape_(drawing::shape_of(scene.document.model)),
          columns_(blank_columns(worksheet_, scene.worksheet_stage))
    {}

    void draw()
    {
        lay_out();
        const ui::LayerScope layer(painter_, ui::Layer::Labels);
        mark_joint();
        for (std::size_t e = 0; e < columns_.size(); ++e)
            if (layout_.boxes[e] && !columns_[e].cells.empty()) draw_column(columns_[e], *layout_.boxes[e]);
        if (scene_.worksheet_stage == worksheet_.n_sheets()) draw_superposition();
        draw_legend();
        for (const Ratio& ratio : ratios())
            if (const auto place = free_place(ratio)) painter_.text(*place, ratio.text, ratio_style());
        for (const Arrow& arrow : arrows()) draw(arrow);
    }

    const BlockLayout& layout()
    {
        lay_out();
        return found_;
    }

    /// How the spans of a beam are drawn so that its columns find room, narrow ones where broad ones have none.
    BayScale bays()
    {
        std::vector<fc::EndId> ends;
        for (std::size_t e = 0; e < columns_.size(); ++e)
            if (!columns_[e].cells.empty()) ends.emplace_back(e);
        const std::vector<Bay> bays = bays_of(shape_, problem_, ends);
        is_narrow_ = false;
        is_narrow_ = breadth_needed(bays, column_needs(), least_broad()) > breadth_of_beam(bays);
        return bay_scale_for(bays, panel_, column_needs());
    }

    bool has_room() const
    {
        if (panel_.is_zoomed) return true; // some are out of sight
        std::size_t n = 0;
        for (const BlankColumn& column : columns_) n += column.cells.size();
        if (scene_.worksheet_stage == worksheet_.n_sheets()) n += superposition_cells(worksheet_).size();
        return drawn_.cells.size() >= n;
    }

private:
    ColumnNeeds column_needs() const
    {
        const double type = std::max(usual_cells * theme_.type().normal, largest_type());
        return {.ems = column_width(type) / type,
                .largest_type = type,
                .least_type = least_cells,
                .support = support_reach(theme_),
                .n_rows = panel_.columns == BeamColumns::InTurn ? 2u : 1u};
    }

    double breadth_of_beam(const std::vector<Bay>& bays) const
    {
        return panel_.camera.scale() * (bays.back().end - bays.front().start);
    }

    /// Size of type of broad cells, with which narrow ones are rather taken; on the projector the last row reads it.
    double least_broad() const
    {
        constexpr double least = 0.85; // of the usual size
        return std::max(least * usual_cells * magnified(), legible_type(scene_.look.full_theme()));
    }

    void lay_out()
    {
        BlockRequest request;
        std::vector<std::size_t> with_cells;
        for (std::size_t e = 0; e < columns_.size(); ++e) {
            if (columns_[e].cells.empty()) continue;
            request.places.push_back(place_of_end(panel_, shape_, problem_, fc::EndId(e), marks_));
            request.places.back().n_spare = n_lines() - std::min(n_lines(), columns_[e].n_lines);
            with_cells.push_back(e);
        }
        request.room = panel_.whole.grown(-0.3 * theme_.type().normal);
        request.room.min.y += 1.8 * theme_.type().normal;
        request.room.max.y -= legend_height();
        if (scene_.worksheet_stage == worksheet_.n_sheets()) request.room.max.y -= 2.4 * theme_.type().normal;
        request.obstacles = obstacles_in(panel_, shape_, scene_.document.model, marks_);
        for (const Arrow& arrow : arrows()) request.obstacles.push_back(arrow.around(0.4 * theme_.type().normal));
        request.largest_type = usual_cells * magnified();
        request.most_lines = n_lines() - std::min(n_lines(), lines_of_head_and_sum);
        request.fewest_lines = request.most_lines;
        request.least_type = least_cells;
        request.n_rows = 3;
        request.width_of = [this](double type) { return column_width(type); };
        request.middle = middle_of(panel_, shape_);
        found_ = best_layout(request);
        layout_ = {.boxes = {}, .type = found_.type, .n_lines = found_.n_lines};
        layout_.boxes.resize(columns_.size());
        for (std::size_t i = 0; i < with_cells.size(); ++i) layout_.boxes[with_cells[i]] = found_.boxes[i];
    }

    /// The size of type, which a zoom enlarges.
    double magnified() const { return theme_.type().normal * std::clamp(panel_.zoom, 1.0, most_magnified_cells); }

    /// On the last sheet the cells of the superposition stand in one row.
    double largest_type() const
    {
        if (scene_.worksheet_stage != worksheet_.n_sheets()) return largest_cells * magnified();
        return size_in_row(largest_cells * theme_.type().normal);
    }

    double size_in_row(double most) const
    {
        const double row = static_cast<double>(superposition_cells(worksheet_).size()) *
                           (column_width(most) + 2.6 * most);
        return most * std::min(1.0, (panel_.box.width() - most) / row);
    }

    /// Narrow cells beside their member end rather than broad ones farther below.
    BlockLayout best_layout(const BlockRequest& request)
    {
        BlockRequest beside = request;
        beside.n_rows = 1;
        for (const bool is_narrow : {false, true}) {
            is_narrow_ = is_narrow;
            beside.largest_type = std::max(request.largest_type, largest_type());
            beside.least_type = !is_narrow ? least_broad() : is_beam(shape_) ? least_cells : 0.6 * request.largest_type;
            BlockLayout found = laid_out(beside);
            if (is_whole(found) && found.n_lines == request.most_lines) return found;
        }
        return laid_out(request);
    }

    // ---- bending stiffnesses, where they differ

    struct Ratio {
        femoop::MemberId member;
        std::string text; ///< "2EI"
    };

    std::vector<Ratio> ratios() const
    {
        std::vector<Ratio> all;
        bool do_differ = false;
        for (std::size_t m = 0; m < problem_.members.size(); ++m) {
            const fc::MemberAction& member = problem_.members[m];
            if (member.EI_over_L <= 0.0 || member.is_overhang) continue;
            const double ratio = member.EI_over_L * member.length / worksheet_.form.EI;
            const bool is_one = std::abs(ratio - 1.0) < 1e-6;
            do_differ = do_differ || !is_one;
            all.push_back({femoop::MemberId(m), (is_one ? "" : ui::number_text(ratio, {3, decimal_mark()})) + "EI"});
        }
        return do_differ ? all : std::vector<Ratio>{};
    }

    ui::DecimalMark decimal_mark() const { return units_of(scene_.document.model, scene_.look.tr).format().mark; }

    /// Beside a place along a member: over a beam and right of a column, or on the other side.
    ui::Point beside(femoop::MemberId id, double t, double side) const
    {
        const drawing::MemberShape& member = shape_[id];
        const ui::Point a = panel_.at(member.start_node), b = panel_.at(member.end_node);
        const ui::Point d = ui::direction(b - a);
        const bool is_upright = std::abs(d.y) > 0.7;
        const double em = marks_.type().normal;
        return a + t * (b - a) + side * (is_upright ? ui::Point{1.6 * em, 0.0} : ui::Point{0.0, -0.9 * em});
    }

    ui::Box heading() const
    {
        return title_box(painter_, panel_, worksheet_title_of(scene_), theme_in(panel_, scene_.look));
    }

    /// Near the middle of its member, where neither a column stands nor the heading; nothing where they are everywhere.
    std::optional<ui::Point> free_place(const Ratio& ratio) const
    {
        const ui::Box taken = heading();
        for (const double t : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8})
            for (const double side : {1.0, -1.0}) {
                const ui::Point at = beside(ratio.member, t, side);
                const ui::Box box = box_of(ratio, at);
                const auto is_hit = [&](const std::optional<ui::Box>& other) { return other && other->overlaps(box); };
                if (panel_.box.contains(box) && !box.overlaps(taken) && std::ranges::none_of(layout_.boxes, is_hit))
                    return at;
            }
        return std::nullopt;
    }

    ui::TextStyle ratio_style() const { return marks_.text(ui::Role::Label, ui::Anchor::Center); }

    ui::Box box_of(const Ratio& ratio, ui::Point at) const
    {
        const double em = marks_.type().normal;
        const double half = 0.5 * painter_.measure(ratio.text, ratio_style()).width;
        return {at - ui::Point{half, 0.6 * em}, at + ui::Point{half, 0.6 * em}};
    }

    // ---- what the signs in the cells mean

    ui::TextStyle legend_style() const
    {
        ui::TextStyle text = theme_.text(ui::Role::FaintLabel, ui::Anchor::TopLeft);
        text.size = theme_.type().small;
        if (panel_.is_zoomed) text.plate = theme_.background(); // the structure may lie there
        return text;
    }

    std::string given() const
    {
        return given_text(scene_.document.model, scene_.document.method.load_case, scene_.look.tr);
    }

    std::vector<std::string> legend() const
    {
        const ui::Catalogue& tr = scene_.look.tr;
        std::string words;
        if (scene_.worksheet_stage == worksheet_.n_sheets())
            words = tr("R: force of a prop in the loads' sheet (0) and in the sway's, x: "
                       "how many times the sway is added, M: final moment");
        else {
            const std::string member = scene_.document.model[worksheet_.form.slenderest].id;
            const std::string unit = units_of(scene_.document.model, tr).unit(ui::Measure::Length).name;
            if (scene_.worksheet_stage == 0)
                words = tr("k: stiffness in EI of {member} [1/{unit}], µ: distribution factor",
                           {{"member", member}, {"unit", unit}}) +
                        ", ";
            words += tr("M: fixed-end moment, 1: balance of the first turn, →1: carried over by it, Σ: sum");
        }
        const double width = panel_.box.width() - 2.0 * legend_style().size;
        auto lines = ui::wrapped_lines(painter_.fonts(), given(), legend_style(), width);
        for (std::string& line : ui::wrapped_lines(painter_.fonts(), words, legend_style(), width))
            lines.push_back(std::move(line));
        return lines;
    }

    double legend_height() const { return (1.4 * static_cast<double>(legend().size()) + 0.6) * legend_style().size; }

    void draw_legend()
    {
        const ui::LayerScope layer(painter_, panel_.is_zoomed ? ui::Layer::Overlay : ui::Layer::Labels);
        const ui::TextStyle text = legend_style();
        const double warning = has_room() ? 0.0 : 1.5 * text.size; // a line below
        ui::Point at{panel_.box.min.x + text.size, panel_.box.max.y - legend_height() + 0.2 * text.size - warning};
        for (const std::string& line : legend()) {
            painter_.text(at, line, text);
            at.y += 1.4 * text.size;
        }
    }

    std::size_t n_lines() const
    {
        std::size_t most = lines_of_head_and_sum;
        for (const BlankColumn& column : columns_) most = std::max(most, column.n_lines);
        return most;
    }

    double label_width(double type) const
    {
        double widest = 0.0;
        for (const BlankColumn& column : columns_)
            for (const BlankCell& cell : column.cells)
                widest = std::max(widest, painter_.measure(cell.label, {.size = label_size * type}).width);
        return widest;
    }

    double column_width(double type) const
    {
        const ui::TextStyle style{.size = type};
        double widest = painter_.measure(is_narrow_ ? "−88.88" : "−88.888", style).width;
        for (const std::string& text : scene_.document.pupil->written)
            if (text.size() < 12) widest = std::max(widest, painter_.measure(with_minus(text), style).width);
        return widest + (is_narrow_ ? 1.6 : 2.1) * type + label_width(type);
    }

    ui::TextStyle style(ui::Role role, ui::Anchor anchor, double size) const
    {
        ui::TextStyle text = theme_.text(role, anchor);
        text.size = size;
        return text;
    }

    void draw_column(const BlankColumn& column, const ui::Box& box)
    {
        const double em = layout_.type;
        ui::TextStyle name = style(ui::Role::Label, ui::Anchor::Center, em);
        name.weight = ui::Weight::Bold;
        const std::string head = head_within(painter_, scene_.document.model, problem_[column.end], name, box.width());
        painter_.text({0.5 * (box.min.x + box.max.x), box.min.y + 0.55 * em}, head, name);
        for (const BlankCell& cell : column.cells) {
            const double top = box.min.y + (name_height + line_height * static_cast<double>(cell.line)) * em;
            const ui::Box place{{box.min.x + 0.05 * em, top}, {box.max.x - 0.05 * em, top + cell_height * em}};
            if (place.max.y > box.max.y + 0.2 * em) continue;
            draw_cell(cell, place);
            if (scene_.cell == cell.blank) drawn_.way_to_cell = way_into_sight(place);
        }
    }

    /// Nothing where a box is seen whole, between title and legend.
    std::optional<ui::Point> way_into_sight(const ui::Box& box) const
    {
        ui::Box sight = sight_below(heading(), panel_, theme_);
        sight.max.y -= legend_height();
        return panel_.is_zoomed ? cross::way_into_sight(box, sight) : std::nullopt;
    }

    /// A frame round it, its label at the left, the number, and at the right what is said of it.
    void draw_cell(const BlankCell& cell, const ui::Box& box)
    {
        if (!panel_.box.contains(box.center())) return;
        drawn_.cells.push_back({cell.blank, box});
        const double em = box.height() / cell_height;
        const fc::Blank& blank = worksheet_.form[cell.blank];
        const bool is_active = scene_.cell == cell.blank;
        const auto verdict = worksheet_.shows_judgement ? worksheet_.judgements[cell.blank.index].verdict
                                                        : fc::Verdict::Open;
        if (is_active) painter_.rectangle(box, theme_[ui::Role::Selection].fill);
        ui::Stroke stroke = theme_.stroke(is_active ? ui::Role::Selection : ui::Role::GridAxis);
        stroke.width = is_active ? 0.14 * em : 0.07 * em;
        stroke.dash = {};
        const auto outline = {box.min, {box.max.x, box.min.y}, box.max, ui::Point{box.min.x, box.max.y}};
        painter_.polyline(outline, stroke, ui::PathEnds::Closed);
        underline(blank.asked, box);
        const double middle = 0.5 * (box.min.y + box.max.y);
        ui::TextStyle label = style(ui::Role::FaintLabel, ui::Anchor::Left, label_size * em);
        painter_.text({box.min.x + 0.2 * em, middle}, cell.label, label);
        const ui::TextStyle number = style(role_of(verdict), ui::Anchor::Right, em);
        painter_.text({box.max.x - 1.1 * em, middle}, shown(cell.blank), number);
        draw_verdict(painter_, theme_, verdict, {box.max.x - 0.55 * em, middle}, em);
    }

    /// As on paper: a line under each balance, two over the sum, a frame round the factor.
    void underline(Asked asked, const ui::Box& box)
    {
        ui::Stroke stroke = theme_.stroke(ui::Role::Label);
        const double em = box.height() / cell_height;
        stroke.width = std::max(1.0, 0.08 * em);
        stroke.dash = {};
        const auto line = [&](double y) { painter_.line({box.min.x, y}, {box.max.x, y}, stroke); };
        if (asked == Asked::Balance) line(box.max.y);
        if (asked == Asked::Sum)
            for (const double lift : {0.0, 0.16}) line(box.min.y - lift * em);
        if (asked == Asked::Factor)
            painter_.polyline({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, stroke,
                              ui::PathEnds::Closed);
    }

    std::string shown(fc::BlankId id) const
    {
        const std::vector<std::string>& written = scene_.document.pupil->written;
        return id.index < written.size() ? with_minus(written[id.index]) : "";
    }

    static std::string with_minus(const std::string& typed)
    {
        return typed.starts_with('-') ? "−" + typed.substr(1) : typed;
    }

    /// A ring round the joint whose turn the cell belongs to.
    void mark_joint()
    {
        if (!scene_.cell) return;
        const fc::Blank& blank = worksheet_.form[*scene_.cell];
        if (blank.asked != Asked::Balance && blank.asked != Asked::CarryOver) return;
        const fc::Turn& turn = worksheet_.form.turns[blank.sheet][blank.step];
        if (!turn || worksheet_.stage_of(*scene_.cell) != scene_.worksheet_stage) return;
        ui::Stroke stroke = theme_.stroke(ui::Role::Selection);
        stroke.width = 2.6 * theme_.symbol_scale();
        stroke.dash = {};
        painter_.circle(panel_.at(shape_[problem_[*turn].node]), 8.0 * theme_.symbol_scale(), stroke);
    }

    /// Which way a prop of the sheet moves, or pushes.
    struct Arrow {
        ui::Point start, tip;
        ui::Box around(double margin) const { return ui::united({start, start}, {tip, tip}).grown(margin); }
    };

    std::vector<Arrow> arrows() const
    {
        const double em = theme_.type().normal;
        const std::size_t stage = scene_.worksheet_stage;
        std::vector<Arrow> arrows;
        for (std::size_t k = 0; k < problem_.sways.size() && stage > 0; ++k) {
            if (stage != k + 1 && stage != worksheet_.n_sheets()) continue;
            const fc::Sway& sway = problem_.sways[k];
            const ui::Point d{sway.direction.x(), -sway.direction.y()};
            const ui::Point start = panel_.at(shape_[sway.prop]) + 0.8 * em * d - 1.1 * em * ui::Point{0.0, 1.0};
            arrows.push_back({start, start + 3.0 * em * d});
        }
        return arrows;
    }

    void draw(const Arrow& arrow)
    {
        const double em = theme_.type().normal;
        const ui::Point start = arrow.start, tip = arrow.tip;
        const ui::Point d = ui::direction(tip - start), n = ui::left_normal(d);
        ui::Stroke stroke = theme_.stroke(ui::Role::Deformed);
        stroke.width = 0.16 * em;
        stroke.dash = {};
        painter_.line(start, tip - 0.5 * em * d, stroke);
        painter_.polygon({tip, tip - 0.8 * em * d + 0.3 * em * n, tip - 0.8 * em * d - 0.3 * em * n}, stroke.color);
    }

    /// Forces of the props and how often the sways are added, in rows below.
    void draw_superposition()
    {
        const double em = std::min(layout_.type, size_in_row(largest_cells * theme_.type().normal));
        const double width = column_width(em) + 2.0 * em;
        const std::string force = units_of(scene_.document.model, scene_.look.tr).unit(ui::Measure::Force).name;
        const auto in_row = static_cast<std::size_t>(std::max(1.0, (panel_.box.width() - em) / (width + 0.6 * em)));
        const double bottom = panel_.box.max.y - legend_height() - 1.6 * em;
        std::vector<BlankCell> cells = superposition_cells(worksheet_);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::size_t row = i / in_row, column = i % in_row;
            const double x = panel_.box.min.x + em + static_cast<double>(column) * (width + 0.6 * em);
            const double y = bottom - 1.5 * static_cast<double>(row) * em;
            if (y < panel_.box.min.y) return;
            if (worksheet_.form[cells[i].blank].asked == Asked::Holding) cells[i].label += " [" + force + "]";
            draw_cell(cells[i], ui::box_at({x, y}, {width, cell_height * em}));
        }
    }

    ui::Painter& painter_;
    const Panel& panel_;
    const Scene& scene_;
    const Worksheet& worksheet_;
    const fc::Problem& problem_;
    Drawn& drawn_;
    ui::Theme theme_, marks_;
    drawing::StructureShape shape_;
    std::vector<BlankColumn> columns_;
    BlockLayout found_, layout_; // of the columns with cells; of all
    bool is_narrow_ = false;
};

std::string worksheet_title_of(const Scene& scene)
{
    const ui::Catalogue& tr = scene.look.tr;
    const Numbers numbers(scene.document, scene.solution, scene.look);
    const std::string unit = " [" + numbers.moment_unit() + "]";
    const std::size_t stage = scene.worksheet_stage;
    if (scene.worksheet->is_solved()) return tr("The sheet is right") + unit;
    if (scene.worksheet->n_sheets() == 1) return tr("Fill the sheet") + unit;
    if (stage == 0) return tr("Fill the sheet of the loads, sways propped") + unit;
    if (stage == scene.worksheet->n_sheets()) return tr("Add the sheets") + unit;
    const femoop::NodeId prop = scene.worksheet->form.problem.sways[stage - 1].prop;
    return tr("Fill the sheet of the sway at {node}", {{"node", scene.document.model[prop].id}}) + unit;
}

void draw_cells(ui::Painter& painter, const Panel& panel, const Scene& scene, Drawn& drawn)
{
    const ui::Theme theme = theme_in(panel, scene.look);
    draw_title(painter, panel, worksheet_title_of(scene), theme);
    draw_structure_in(painter, panel, scene, {}, [](const drawing::Scene& in) {
        drawing::draw_members(in, drawing::Presence::Subject);
        {
            const ui::LayerScope layer(in.sketch.painter(), ui::Layer::Symbols);
            drawing::draw_supports(in);
        }
        drawing::draw_joints(in);
    });
    const ui::ClipScope clip(painter, panel.box);
    WorksheetWriter writer(painter, panel, scene, drawn);
    writer.draw();
    if (!writer.has_room())
        write_below(painter, panel, theme,
                    scene.look.tr("some cells have no room here; Tab reaches them, and the panel has them"));
}

/// Above the beam too where only so all cells are read from the last row, or are at least larger.
Panels best_beam(ui::Painter& painter, const Scene& scene, const drawing::StructureShape& shape)
{
    const auto panels_with = [&](BeamColumns columns) {
        Drawn nothing;
        Panels panels = exercise_panels(shape, painter.size(), scene, {}, columns);
        panels.sheet.bays = WorksheetWriter(painter, panels.sheet, scene, nothing).bays();
        return panels;
    };
    const auto type_of_all = [&](const Panels& panels) { // 0: some have no room
        Drawn nothing;
        const BlockLayout layout = WorksheetWriter(painter, panels.sheet, scene, nothing).layout();
        return is_whole(layout) ? layout.type : 0.0;
    };
    Panels below = panels_with(BeamColumns::Below);
    const double type_below = type_of_all(below);
    if (type_below >= legible_type(scene.look.full_theme())) return below;
    Panels in_turn = panels_with(BeamColumns::InTurn);
    return type_of_all(in_turn) > type_below ? in_turn : below;
}

/// A frame is drawn smaller where that makes its cells larger.
Panels best_panels(ui::Painter& painter, const Scene& scene)
{
    const drawing::StructureShape shape = drawing::shape_of(scene.document.model);
    if (is_beam(shape)) return best_beam(painter, scene, shape);
    Drawn nothing;
    Panels best = exercise_panels(shape, painter.size(), scene, {});
    BlockLayout layout = WorksheetWriter(painter, best.sheet, scene, nothing).layout();
    for (const SheetRoom& room : rooms_tried(scene.look.full_theme())) {
        Panels other = exercise_panels(shape, painter.size(), scene, room);
        const BlockLayout tried = WorksheetWriter(painter, other.sheet, scene, nothing).layout();
        if (!is_better(tried, layout)) continue;
        best = std::move(other);
        layout = tried;
    }
    return best;
}

} // namespace

Drawn draw_exercise(ui::Painter& painter, const Scene& scene)
{
    Drawn drawn;
    const bool is_solved = scene.worksheet->is_solved() && scene.state != nullptr;
    const ui::Theme theme = scene.look.full_theme();
    const drawing::StructureShape shape = drawing::shape_of(scene.document.model);
    Panels panels = best_panels(painter, scene);
    panels.structure.look_as(view_of_loads(panels.structure, scene, painter.fonts()));
    look_closer(panels, shape, scene.look.zoom);
    const ui::Box& first = panels.structure.box;
    {
        const ui::LayerScope layer(painter, ui::Layer::Grid);
        const ui::Stroke stroke = theme.stroke(ui::Role::GridAxis);
        painter.line({first.min.x, first.max.y}, first.max, stroke);
        const ui::Box& sheet = panels.sheet.box;
        if (panels.is_stacked && is_solved) painter.line(sheet.min, {sheet.max.x, sheet.min.y}, stroke);
        if (!panels.is_stacked) painter.line(sheet.min, {sheet.min.x, sheet.max.y}, stroke);
    }
    draw_loaded(painter, panels.structure, scene);
    if (is_solved) draw_moment_state(painter, panels.moments, scene);
    draw_cells(painter, panels.sheet, scene, drawn);
    drawn.zoom = panels.zoom;
    drawn.middle = middle_of(shape);
    drawn.views.push_back(view_of(panels.structure));
    if (is_solved) drawn.views.push_back(view_of(panels.moments));
    drawn.views.push_back(view_of(panels.sheet));
    return drawn;
}

} // namespace cross
