#pragma once

#include "apps/drawing/draw_input.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/draw_state.h"
#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/results/envelope_band.h"
#include "apps/drawing/results/position_curve.h"
#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sheet/panels.h"
#include "apps/drawing/sheet/sheet_table.h"
#include "apps/drawing/sketch/sketch.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

#include <optional>
#include <vector>

namespace drawing {

/// All that a picture is made from, gathered once.
class Subject {
public:
    /// \pre the options and the state outlive it
    Subject(DrawInput input, const DrawOptions& options, const DrawState& state);

    /// How a sheet of this size is divided, and the camera of its panels.
    struct Plan {
        std::vector<Panel> panels;
        Camera camera;
    };
    Plan plan(ui::Size sheet, const ui::Fonts& fonts) const;
    /// What was drawn.
    struct Picture {
        Plan plan;
        Grips grips;                ///< what a hand can take hold of, where it is on the sheet
        bool is_whole = true;       ///< no mark of the structure runs out of its panel or below its heads
        double legend_bottom = 0.0; ///< of the title and of what stands over the first panel [logical pixels]
    };
    Picture draw(ui::Painter& painter) const;

private:
    /// What the results say along the members.
    struct Cases {
        std::optional<SolvedCase> shown;
        std::optional<EnvelopePicture> envelope; ///< of several cases
    };
    const Cases& cases() const;
    EnvelopePicture envelope_of_cases() const;
    const EnvelopePicture* envelope() const; ///< that is drawn in place of a case; null where none is

    std::vector<ShowSet> contents(std::size_t n_kept) const; ///< of so many kept lines, and its own
    std::vector<Panel> panels_of(std::size_t n_kept, const ui::Box& room, std::size_t columns) const;
    bool is_flat_row() const;
    std::size_t n_kept_with_room(const ui::Box& room, std::size_t columns) const;
    ui::Box area(ui::Size sheet, const ui::Fonts& fonts) const;
    Camera starting_camera() const;
    Camera usual_camera() const;
    Camera fitted(const std::vector<Panel>& panels, const ui::Fonts& fonts) const;
    /// Whether the picture keeps room for every caption where it would stand best, or for the marks alone.
    enum class Fit : std::uint8_t { Roomy, Tight };
    /// The room that marks need at a scale.
    struct Need {
        double scale;
        ui::Margins margins;
    };
    /// At the scale at which there is room for what is needed there, which changes evenly from one scale to the other.
    void fit_between(Camera& camera, ui::Size panel, const Need& a, const Need& b) const;
    Camera fitted(const std::vector<Panel>& panels, const ui::Fonts& fonts, Fit fit) const;
    ui::Margins needed_margins(const std::vector<Panel>& panels, const Camera& camera, const ui::Fonts& fonts,
                               Fit fit) const;
    /// What a fitted picture holds whole, apart from marks that keep their size.
    std::vector<Eigen::Vector3d> fitted_points() const;
    void fit(Camera& camera, ui::Size panel, const ui::Margins& margins) const;
    double aspect(const Camera& camera) const;

    /// Draws a panel and returns the room that its marks took; `n_left_out` counts labels without a place.
    struct Drawn {
        std::optional<ui::Box> bounds, tight_bounds, mark_bounds;
        double heads_height = 0.0;
        std::size_t n_left_out = 0;
        Grips grips{};
    };
    enum class Pass : std::uint8_t { Measure, Write };
    /// What a panel draws: the structure under its own loads, or under the unit load of virtual work.
    struct Side {
        const femoop::Model& model;
        const DrawOptions& options;
        const DrawState& state;
        const ui::DisplayUnits& units;
        const SolvedCase* solved;
    };
    /// The structure under the unit load, as a picture is made of it.
    struct UnitSide {
        DrawOptions options;
        DrawState state;
        ui::DisplayUnits units;
        std::optional<SolvedCase> solved;
    };
    Side side_of(const Panel& panel) const;
    const UnitSide& unit_side() const;                                          ///< \pre virtual work is shown
    const SheetTable& work_table(ui::Size sheet, const ui::Fonts& fonts) const; ///< likewise
    Drawn draw_panel(ui::Painter& painter, const Panel& panel, const Camera& camera, Pass pass) const;
    std::vector<ui::Box> head_rows(const std::vector<PanelHead>& heads, const ui::Theme& theme, const ui::Fonts& fonts,
                                   const Panel& panel) const;
    bool shows_truss() const;
    Plan plan_with_diagram(const ui::Box& room, const ui::Fonts& fonts) const;
    bool is_stacked(const ui::Box& room) const; ///< the structure over what stands beside it
    bool shows_funicular() const;
    bool shows_work() const;
    bool has_diagram() const; ///< of forces, beside the structure
    bool keeps_type() const;  ///< of the theme, in panels of any size
    bool has_curve() const;
    std::vector<Eigen::Vector3d> ends_of_curve() const; ///< where its positions end, on the line of a level path
    bool has_overlay_text() const;
    /// What stands at the foot of the sheet: how the structure moves, why it has no results, the
    /// equations of a free body, the table of virtual work and its sum, the stage of a truss that is worked out, what is
    /// read of a funicular, what the overlay says of the moments, or what is said of an influence line, under the curve of
    /// its train.
    void draw_foot(ui::Painter& painter, const Plan& plan) const;
    /// From its beginning to its end, where it is straight and goes along x in the plane.
    struct LevelPath {
        Eigen::Vector3d begin, end;
    };
    std::optional<LevelPath> level_path() const; ///< \pre there is an influence line
    std::optional<PathOnSheet> path_on_sheet(const Plan& plan) const;
    void draw_left_out(ui::Painter& painter, const std::string& words) const;
    /// What is written at the foot: a line of it, or a sentence before it is wrapped.
    struct FootText {
        std::string text;
        ui::Role role = ui::Role::Label;
        ui::Weight weight = ui::Weight::Regular;
    };
    std::vector<FootText> foot_sentences() const;
    static std::vector<FootText> headed(const std::vector<std::string>& sentences);
    std::vector<std::string> method_sentences() const; ///< of what is drawn in place of the results, or over them
    std::vector<std::string> line_sentences() const;   ///< \pre there is an influence line
    /// Its lines, and the size of their type.
    struct Foot {
        std::vector<FootText> lines;
        double type_size;

        double line_height() const { return 1.4 * type_size; }
        double height() const { return line_height() * static_cast<double>(lines.size()); }
    };
    Foot foot(ui::Size sheet, const ui::Fonts& fonts) const;
    Foot foot_in(double type_size, ui::Size sheet, const ui::Fonts& fonts) const;
    void shorten(Foot& foot, ui::Size sheet) const; ///< where it would leave the picture too little
    std::vector<std::string> truss_sentences() const;
    double most_foot_height(ui::Size sheet, const ui::Fonts& fonts) const;
    std::vector<FootText> wrapped_foot(const std::vector<FootText>& sentences, double type_size, ui::Size sheet,
                                       const ui::Fonts& fonts) const;
    ui::TextStyle foot_style(const FootText& of, double type_size) const;

    DrawInput input_;
    const DrawOptions& options_;
    const DrawState& state_;
    ui::Theme theme_;
    ui::DisplayUnits units_;
    StructureShape shape_;
    bool is_solved_ = false; ///< the case that is shown
    mutable std::optional<UnitSide> unit_side_;
    mutable std::optional<SheetTable> work_table_; ///< as it is measured first: of one sheet
    mutable std::optional<Cases> cases_;           ///< read when first drawn: a plan with a camera needs none of it
};

} // namespace drawing
