#include "apps/cross/report/calculation.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "apps/cross/report/tables.h"
#include "apps/cross/view/columns.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/sheet_bays.h"
#include "apps/cross/view/sheet_picture.h"
#include "apps/cross/view/structure_pictures.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/fraction.h"
#include "ui/text/language_manner.h"

namespace cross {

namespace fc = femoop::cross;
using ui::translatable;

Document balanced_document(const Document& document, const Solution& solution)
{
    Document balanced = document;
    const Task& task = *solution.task;
    balanced.plays.resize(task.n_sheets());
    for (std::size_t stage = 0; stage < task.n_sheets(); ++stage) {
        if (solution.sheets[stage].is_balanced && !solution.sheets[stage].steps.empty()) continue;
        const fc::Stage& own = stage == 0 ? task.all->held : task.all->sways[stage - 1];
        balanced.plays[stage].restart();
        for (const fc::Step& step : own.sheet.steps) balanced.plays[stage].advance(step.joint);
    }
    balanced.stage = 0;
    return balanced;
}

namespace {

constexpr double width = 680.0; // of a figure [px]

std::string_view order_text(fc::Order order)
{
    switch (order) {
    case fc::Order::Largest: return translatable("the joint with the largest unbalance first");
    case fc::Order::LeftToRight: return translatable("the joints from left to right, again and again");
    case fc::Order::AllAtOnce: return translatable("all joints at once");
    case fc::Order::Listed: return translatable("the joints in an order of one's own");
    }
    return "";
}

tabular::Column to_the_right(std::string heading) { return {std::move(heading), "", tabular::Alignment::Right}; }

class CalculationWriter {
public:
    CalculationWriter(const Document& document, const Look& look, const ui::Fonts& fonts)
        : document_(document), solution_(solve(document)), look_(look), fonts_(fonts), tr_(look_.tr)
    {
        look_.theme = ui::ThemeName::Print;
        look_.size = 1.0;
        look_.zoom = {};
        report_.title = document.model.title.empty() ? tr_("Moment distribution") : document.model.title;
        report_.language = ui::language_tag(tr_.language());
    }

    ui::Report write()
    {
        heading(1, report_.title);
        if (!document_.model.notes.empty()) text(document_.model.notes);
        if (!solution_.task) {
            heading(2, tr_("Not distributed"));
            for (const femoop::Fault& fault : solution_.faults) text(fault_text(fault, tr_));
            return std::move(report_);
        }
        if (solution_.task->all) {
            document_ = balanced_document(document_, solution_);
            work(solution_, document_);
        }
        write_problem();
        write_factors();
        if (solution_.task->all) write_results();
        for (const femoop::Fault& fault : solution_.task->remarks) text(fault_text(fault, tr_));
        return std::move(report_);
    }

private:
    void heading(int level, std::string words) { report_.blocks.push_back(ui::ReportHeading{level, std::move(words)}); }
    void text(std::string words) { report_.blocks.push_back(ui::ReportText{std::move(words)}); }

    Scene scene(const femoop::Results* state = nullptr) const
    {
        return {document_, solution_, state, 1.0, std::nullopt, look_};
    }

    /// A table that is too broad for a page is cut; each part begins with the names of the rows.
    void table(const tabular::Table& told)
    {
        constexpr std::size_t most = 10; // columns beside the names
        for (const std::string& note : told.notes) text(note);
        for (std::size_t begin = 1; begin < told.columns.size(); begin += most) {
            std::vector<std::size_t> columns{0};
            for (std::size_t i = begin; i < std::min(told.columns.size(), begin + most); ++i) columns.push_back(i);
            report_.blocks.push_back(columns_of(told, columns));
        }
    }

    template <class Draw> void figure(Part part, std::size_t n_lines, const Draw& draw)
    {
        const drawing::StructureShape shape = drawing::shape_of(document_.model);
        const ui::Theme theme = look_.full_theme();
        const ui::Size size{width, height_alone(part, shape, width, n_lines, theme)};
        ui::Painter painter(size, fonts_);
        draw(painter, panel_alone(part, shape, size, theme));
        report_.blocks.push_back(ui::ReportFigure{painter.picture(), ""});
    }

    void write_problem()
    {
        heading(2, tr_("Structure and loads"));
        figure(Part::Structure, 0,
               [&](ui::Painter& painter, const Panel& panel) { draw_loaded(painter, panel, scene()); });
        const Numbers numbers(document_, solution_, look_);
        const Method& method = document_.method;
        text(tr_("Load case {case}; {order}; tolerance {tolerance}.",
                 {{"case", document_.model.case_name(method.load_case)},
                  {"order", tr_(order_text(method.order))},
                  {"tolerance", numbers.moment(solution_.sheets.front().tolerance) + " " + numbers.moment_unit()}}));
        if (method.digits > 0)
            text(tr_("Every number is rounded to {n} significant digits.", {{"n", std::to_string(method.digits)}}));
        text(look_.signs == Signs::JointRotation ? tr_("Moments act on the member ends, counter-clockwise positive.")
                                                 : tr_("Moments are positive where they stretch the lower side."));
    }

    void write_factors()
    {
        heading(2, tr_("Factors and fixed-end moments"));
        const fc::Problem& problem = solution_.task->problem;
        if (problem.halves.empty()) write_factors(problem, problem.loading);
        else
            for (std::size_t stage = 0; stage < problem.halves.size(); ++stage) {
                if (problem.halves.size() > 1) heading(3, sheet_name(stage));
                write_factors(problem.of_sheet(stage), solution_.task->loading(stage));
            }
        text(tr_("Stiffnesses are moments per radian in the file's base units."));
    }

    std::string sheet_name(std::size_t stage) const
    {
        if (stage == 0) return tr_("Sheet of the loads");
        const femoop::NodeId prop = solution_.task->problem.sways[stage - 1].prop;
        return tr_("Sheet of the sway at {node}", {{"node", document_.model[prop].id}});
    }

    /// Of the ends on a sheet.
    void write_factors(const fc::Problem& problem, const fc::Loading& loading)
    {
        const Numbers numbers(document_, solution_, look_);
        tabular::Table told({tr_("member end"), to_the_right(tr_("stiffness")), to_the_right(""),
                             to_the_right(tr_("distribution factor")), to_the_right(""),
                             to_the_right(tr_("carry-over")),
                             to_the_right(tr_("FEM") + " [" + numbers.moment_unit() + "]")});
        for (std::size_t e = 0; e < problem.ends.size(); ++e) {
            const fc::End& end = problem.ends[e];
            if (!problem.is_on_sheet(fc::EndId(e))) continue;
            const bool is_on_axis = end.joint && !problem.is_balanced(*end.joint);
            const bool is_free = (end.joint && !is_on_axis) || end.is_hinged;
            const auto fraction = fc::fraction_of(end.factor, 999);
            told.add_row({end.label, std::string(fc::formula(problem, fc::EndId(e))),
                          ui::number_text(end.stiffness, numbers.units().format()),
                          is_free      ? numbers.factor(end.factor)
                          : is_on_axis ? tr_("on the axis")
                                       : tr_("fixed"),
                          is_free && fraction ? fc::fraction_text(*fraction) : "", numbers.factor(end.carry_over),
                          numbers.moment(end, loading.fixed_end[e])});
        }
        table(told);
    }

    void write_results()
    {
        for (std::size_t stage = 0; stage < solution_.sheets.size(); ++stage) write_sheet(stage);
        if (!solution_.task->problem.sways.empty()) {
            heading(2, tr_("Sways"));
            table(table_of(scene(), Topic::Sways));
        }
        document_.stage = solution_.sheets.size(); // all together
        if (!solution_.task->problem.sways.empty()) write_sum();
        heading(2, tr_("Final moments"));
        table(table_of(scene(), Topic::Comparison));
        write_diagrams();
        write_other_methods();
    }

    /// The loads and so many times each sway, line by line.
    void write_sum()
    {
        heading(2, tr_("All sheets together"));
        const std::size_t n_lines = solution_.sheets.size() + 1;
        if (is_beam(drawing::shape_of(document_.model))) beam_sheet(n_lines);
        else frame_sheet(n_lines);
        table(table_of(scene(), Topic::Sheet));
    }

    void write_sheet(std::size_t stage)
    {
        document_.stage = stage;
        const fc::Problem& problem = solution_.task->problem.of_sheet(stage);
        heading(2, sheet_name(stage));
        std::size_t n_lines = 0;
        for (const Column& column : columns_of(problem, solution_.sheets[stage]))
            if (problem.is_on_sheet(column.end)) n_lines = std::max(n_lines, column.n_levels);
        if (is_beam(drawing::shape_of(document_.model))) beam_sheet(n_lines);
        else frame_sheet(n_lines);
        table(table_of(scene(), Topic::Sheet));
        const tabular::Table history = table_of(scene(), Topic::Convergence);
        for (const std::string& note : history.notes) text(note);
    }

    /// As broad as its columns need, on as many pages as that takes.
    void beam_sheet(std::size_t n_lines)
    {
        const drawing::StructureShape shape = drawing::shape_of(document_.model);
        const ui::Theme theme = look_.full_theme();
        const double height = height_alone(Part::Sheet, shape, width, n_lines, theme);
        const std::vector<Bay> bays = bays_of_sheet(scene());
        ui::Painter probe({width, height}, fonts_);
        const double whole = breadth_of_beam(probe, panel_alone(Part::Sheet, shape, {width, height}, theme), bays);
        const Panel all = panel_alone(Part::Sheet, shape, {whole, height}, theme);
        const BayScale scale = sheet_bays(probe, all, scene());
        Panel drawn_out = all;
        drawn_out.bays = scale;
        for (const Stretch& stretch : cut_into_pages(drawn_out, bays, width)) {
            ui::Painter painter({width, height}, fonts_);
            Panel page = stretch_of_sheet(shape, {stretch.right - stretch.left, height}, whole, stretch.left, theme);
            page.bays = scale;
            draw_sheet(painter, page, scene());
            report_.blocks.push_back(ui::ReportFigure{painter.picture(), ""});
        }
    }

    /// That of the page, unless numbers got too small there.
    double breadth_of_beam(ui::Painter& probe, const Panel& page, const std::vector<Bay>& bays) const
    {
        constexpr double smallest = 0.75, legible = 0.9; // of the usual size of type
        const ColumnNeeds needs = column_needs(probe, page, scene());
        const double margins = width - page.camera.scale() * (bays.back().end - bays.front().start);
        const auto at = [&](double share) { return breadth_needed(bays, needs, share * needs.largest_type) + margins; };
        return bays.empty() || at(smallest) <= width ? width : at(legible);
    }

    /// Drawn larger until every column has room, and so printed smaller.
    void frame_sheet(std::size_t n_lines)
    {
        const drawing::StructureShape shape = drawing::shape_of(document_.model);
        const ui::Theme theme = look_.full_theme();
        const double height = height_alone(Part::Sheet, shape, width, n_lines, theme);
        for (double larger = 1.0;; larger *= 1.25) {
            constexpr double most = 4.0;
            const ui::Size size{larger * width, larger * height};
            ui::Painter painter(size, fonts_);
            const Panel panel = panel_alone(Part::Sheet, shape, size, theme);
            const std::size_t n_missing = draw_sheet(painter, panel, scene()).n_left_out;
            if (n_missing > 0 && larger < most) continue;
            report_.blocks.push_back(ui::ReportFigure{painter.picture(), ""});
            return;
        }
    }

    void write_diagrams()
    {
        const std::optional<femoop::Results> free = without_locks();
        if (!free) return;
        heading(2, tr_("Diagrams"));
        const Scene balanced = scene(&*free);
        for (const auto draw : {draw_moment_state, draw_shear_state, draw_deformed_state})
            figure(Part::Moments, 0, [&](ui::Painter& painter, const Panel& panel) { draw(painter, panel, balanced); });
    }

    /// What the sheets tend to: the inextensible structure, its case as the last one.
    std::optional<femoop::Results> without_locks() const
    {
        femoop::Model model = fc::inextensible_copy(document_.model);
        const femoop::CaseId load_case = document_.method.load_case;
        model.combinations.push_back({.id = "= " + model.case_name(load_case), .terms = {{load_case, 1.0}}});
        try {
            return femoop::analyse(model);
        } catch (const femoop::ModelError&) {
            return std::nullopt; // `remarks` say why
        }
    }

    void write_other_methods()
    {
        if (solution_.task->kani) {
            heading(2, tr_("Kani's method"));
            table(table_of(scene(), Topic::Kani));
        }
        if (solution_.task->equations) {
            heading(2, tr_("Slope-deflection equations"));
            table(table_of(scene(), Topic::Equations));
        }
    }

    Document document_;
    Solution solution_;
    Look look_;
    const ui::Fonts& fonts_;
    const ui::Catalogue& tr_;
    ui::Report report_;
};

} // namespace

ui::Report calculation(const Document& document, const Look& look, const ui::Fonts& fonts)
{
    return CalculationWriter(document, look, fonts).write();
}

} // namespace cross
