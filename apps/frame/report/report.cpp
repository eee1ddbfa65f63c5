#include "apps/frame/report/report.h"

#include <algorithm>
#include <utility>

#include "apps/drawing/draw.h"
#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/measures.h"
#include "apps/drawing/results/case_numbers.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_cases.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/report/calculated_sections.h"
#include "apps/frame/tables/data_table.h"
#include "apps/frame/tables/result_table.h"
#include "apps/frame/tables/table_kind.h"
#include "femoop/analysis/trace.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/io/truss/truss_sheet.h"
#include "femoop/result/components.h"
#include "femoop/result/structure_words.h"
#include "ui/paint/painter.h"
#include "ui/text/language_manner.h"
#include "ui/text/number_format.h"

namespace frame {

using namespace femoop;
using ui::translatable;

namespace {

// As broad as the page; a beam needs less of its height than a frame.
ui::Size figure_size(const Model& model)
{
    constexpr double flat = 0.15; // height of what counts as a beam, of its length
    Eigen::Vector3d least = Eigen::Vector3d::Zero(), most = least;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Eigen::Vector3d place = position_of(model, NodeId(i));
        least = i == 0 ? place : least.cwiseMin(place).eval();
        most = i == 0 ? place : most.cwiseMax(place).eval();
    }
    const bool is_beam = is_plane(model.analysis) && most.y() - least.y() <= flat * (most.x() - least.x());
    return {680.0, is_beam ? 240.0 : 400.0};
}

class ReportWriter {
public:
    ReportWriter(const Model& model, const Solution& solution, const ReportOptions& options, const ui::Fonts& fonts)
        : model_(model),
          solution_(solution),
          options_(options),
          fonts_(fonts),
          tr_(options.view.tr),
          manner_{display_units(model, options.view), options.view.tr}
    {}

    ui::Report write()
    {
        heading(1, model_.title.empty() ? tr_("Structure without a title") : model_.title);
        if (!model_.notes.empty()) text(model_.notes);
        write_structure();
        write_data();
        if (!solution_.results) write_faults();
        else if (options_.about == ReportAbout::Data) write_loads();
        else write_results();
        if (options_.matrices && solution_.results) write_matrices();
        report_.title = model_.title;
        report_.language = ui::language_tag(tr_.language());
        return std::move(report_);
    }

private:
    void heading(int level, std::string words) { report_.blocks.push_back(ui::ReportHeading{level, std::move(words)}); }
    void text(std::string words) { report_.blocks.push_back(ui::ReportText{std::move(words)}); }

    // Columns in which nothing stands are left out, and tables in which nothing but names would be left.
    static std::vector<std::size_t> used_columns(const Table& table)
    {
        std::vector<std::size_t> used;
        for (std::size_t i = 1; i < table.headings.size(); ++i) {
            const auto says = [i](const Row& row) { return i < row.cells.size() && !row.cells[i].value.shown.empty(); };
            if (std::ranges::any_of(table.rows, says)) used.push_back(i);
        }
        return used;
    }

    // A table that is too broad for a page is cut between groups of columns; each part begins with the names.
    void table(const Table& table, std::size_t group = 1)
    {
        constexpr std::size_t most = 12; // columns beside the names
        const std::vector<std::size_t> used = used_columns(table);
        const std::size_t step = std::max(group, most / group * group);
        for (std::size_t begin = 0; begin < std::max<std::size_t>(1, used.size()); begin += step) {
            std::vector<std::size_t> columns{0};
            const std::size_t end = std::min(used.size(), begin + step);
            for (std::size_t i = begin; i < end; ++i) columns.push_back(used[i]);
            part_of(table, columns);
        }
    }

    void part_of(const Table& table, const std::vector<std::size_t>& columns)
    {
        tabular::Table block;
        for (const std::size_t i : columns) block.columns.push_back(table.headings[i].column);
        for (const Row& row : table.rows) {
            std::vector<tabular::Cell> cells;
            for (const std::size_t i : columns) cells.push_back(i < row.cells.size() ? row.cells[i].value : "");
            block.add_row(std::move(cells));
        }
        report_.blocks.push_back(std::move(block));
    }

    template <class Draw> void figure(std::string caption, Draw&& draw)
    {
        ui::Painter painter(figure_size(model_), fonts_);
        draw(painter);
        report_.blocks.push_back(ui::ReportFigure{painter.picture(), std::move(caption)});
    }
    DrawOptions view(ShowSet show, CaseId load_case = {}) const
    {
        DrawOptions view = options_.view;
        view.theme = ui::ThemeName::Print;
        view.show = show;
        view.load_case = load_case;
        view.is_envelope = false;
        view.layout = Layout::Overlay;
        return view;
    }

    void write_structure()
    {
        heading(2, tr_("Structure"));
        text(kind_text(model_.analysis, tr_) + ", " + size_text(model_, tr_) + degree());
        figure(tr_("Names of nodes and members, dimensions"), [&](ui::Painter& painter) {
            using enum Show;
            const ShowSet dimensions{options_.dimensions.empty() ? Dimensions : DrawnDimensions};
            draw(painter, {.model = model_, .dimensions = options_.dimensions},
                 view(ShowSet{NodeNames, MemberNames, Values} | dimensions));
        });
    }
    std::string degree() const
    {
        const bool has_degree = solution_.results && !model_.members.empty();
        if (!has_degree || solution_.results->indeterminacy().has_foundation) return "";
        return ", " + tr_("degree of indeterminacy {total}",
                          {{"total", std::to_string(solution_.results->indeterminacy().total())}});
    }

    void write_data()
    {
        const Model written_out = with_calculated_sections(model_);
        for (const TableKind kind : all_table_kinds) {
            if (is_result(kind)) continue;
            const Table data = data_table(written_out, kind, manner_);
            if (data.rows.empty() || used_columns(data).empty()) continue;
            heading(3, tr_(title(kind)));
            table(data);
            if (kind == TableKind::Sections && written_out.sections != model_.sections)
                text(tr_("Properties that were not typed are calculated from the profile or the shape."));
        }
    }

    void write_faults()
    {
        heading(2, tr_("Not solved"));
        for (const Fault& fault : solution_.faults) text(sentence(fault, tr_));
    }

    void write_results()
    {
        const std::vector<CaseId> solved = solution_.solved_cases();
        for (const CaseId id : solved) write_case(id);
        for (const BlankCase& blank : solution_.blank) write_blank(blank);
        if (solved.size() > 1) write_envelope();
    }

    void write_blank(const BlankCase& blank)
    {
        const std::string& name = model_.case_name(blank.id);
        heading(2, tr_("Case {case}", {{"case", name}}));
        text(tr_("Case {case} has no results.", {{"case", name}}));
        for (const Fault& fault : blank.faults) text(sentence(fault, tr_));
    }

    void write_envelope()
    {
        const Results& results = *solution_.results;
        heading(2, envelope_text(model_, options_.view));
        for (const MemberComponent component : section_force_components(model_.analysis)) {
            figure(force_label(component), [&](ui::Painter& painter) {
                DrawOptions bands = view({show_of(component), Show::Values});
                bands.is_envelope = true;
                draw(painter, {model_, &results}, bands);
            });
        }
        const TabledResults chosen{model_, results, CaseId(0), envelope_cases(model_, options_.view)};
        for (const TableKind kind : {TableKind::Envelope, TableKind::ReactionEnvelope}) {
            heading(3, tr_(title(kind)));
            table(result_table(chosen, kind, manner_), kind == TableKind::Envelope ? 6 : 4);
        }
    }

    void write_loads()
    {
        using enum Show;
        heading(2, tr_("Loads"));
        for (std::size_t i = 0; i < model_.n_cases(); ++i) {
            figure(tr_("Case {case}", {{"case", model_.case_name(CaseId(i))}}), [&](ui::Painter& painter) {
                draw(painter, {model_}, view({Loads, Values, NodeNames}, CaseId(i)));
            });
        }
        text(tr_("The results are hidden."));
    }

    void write_case(CaseId id)
    {
        using enum Show;
        const Results& results = *solution_.results;
        heading(2, tr_("Case {case}", {{"case", results[id].name()}}));
        const auto draw_case = [&](const std::string& caption, ShowSet show) {
            figure(caption, [&](ui::Painter& painter) { draw(painter, {model_, &results}, view(show, id)); });
        };
        draw_case(tr_("Loads and reactions"), {Loads, Reactions, Values, NodeNames});
        for (const MemberComponent component : section_force_components(model_.analysis))
            draw_case(force_label(component), {show_of(component), Values});
        draw_case(tr_("Deformed shape"), {Deformed, Values});
        for (const TableKind kind :
             {TableKind::Reactions, TableKind::Displacements, TableKind::MemberEnds, TableKind::Extremes}) {
            heading(3, tr_(title(kind)));
            table(result_table({model_, results, id}, kind, manner_), kind == TableKind::Extremes ? 4 : 1);
        }
        write_equilibrium(results[id]);
        if (options_.truss) write_truss(*options_.truss, id);
    }

    /// The picture with all stages, and the sheet to it.
    void write_truss(TrussMethod method, CaseId id)
    {
        const Results& results = *solution_.results;
        if (truss::why_no_truss(model_, results)) return;
        const truss::Truss truss = truss::truss_of(model_, results, id);
        if (why_not(method, truss)) return;
        const TrussPicture picture = truss_picture(method, model_, truss, tr_);
        const truss::Sheet sheet = sheet_of(method, truss, id);
        write_paragraph(sheet.front());
        figure(picture.stage().lines.front(), [&](ui::Painter& painter) {
            using enum Show;
            draw(painter, {.model = model_, .results = &results, .truss = &picture},
                 view({Show::Truss, Values, NodeNames}, id));
        });
        for (std::size_t i = 1; i < sheet.size(); ++i) write_paragraph(sheet[i]);
    }

    truss::Sheet sheet_of(TrussMethod method, const truss::Truss& truss, CaseId id) const
    {
        switch (method) {
        case TrussMethod::ZeroForces: return zero_force_sheet(model_, truss, id, tr_);
        case TrussMethod::Joints: return joint_sheet(model_, truss, id, tr_);
        case TrussMethod::Cremona: break;
        }
        return diagram_sheet(model_, truss, id, tr_);
    }

    void write_paragraph(const truss::Paragraph& paragraph)
    {
        switch (paragraph.kind) {
        case truss::ParagraphKind::Title: return heading(3, paragraph.text);
        case truss::ParagraphKind::Heading: return heading(4, paragraph.text);
        case truss::ParagraphKind::Table: report_.blocks.emplace_back(paragraph.table); return;
        case truss::ParagraphKind::Sentence:
        case truss::ParagraphKind::Equation: return text(paragraph.text);
        }
    }

    std::string force_label(MemberComponent component) const
    {
        return manner_.units.label(std::string(name(component, model_.analysis)), measure_of(component));
    }

    Show show_of(MemberComponent component) const
    {
        const bool is_in_space = model_.analysis == AnalysisKind::Frame3d;
        switch (component) {
        case MemberComponent::N: return Show::N;
        case MemberComponent::Vy: return is_in_space ? Show::Vy : Show::V;
        case MemberComponent::Vz: return Show::Vz;
        case MemberComponent::T: return Show::T;
        case MemberComponent::My: return Show::My;
        default: return is_in_space ? Show::Mz : Show::M;
        }
    }

    void write_equilibrium(const CaseResult& result)
    {
        heading(3, tr_("Equilibrium"));
        const Equilibrium equilibrium = result.equilibrium();
        const CaseNumbers numbers(result, manner_.units);
        Table sums{{{tr_("Force")}, number_heading(tr_("Loads")), number_heading(tr_("Reactions"))}, {}};
        for (const Dof dof : equilibrium_dofs(model_.analysis)) {
            const ui::Measure measure = force_measures.of(dof);
            const auto cell = [&](const NodeVector& of) { return Cell{numbers.text(of[index(dof)], measure)}; };
            sums.rows.push_back({std::nullopt,
                                 {Cell{"Σ" + std::string(force_name(dof))}, cell(equilibrium.sum_loads),
                                  cell(equilibrium.sum_reactions)}});
        }
        table(sums);
        text(tr_(
            "Largest force out of balance: {residual} of the largest load",
            {{"residual", ui::number_text(equilibrium.residual, {.digits = 2, .mark = options_.view.numbers.mark})}}));
    }

    void write_matrices()
    {
        heading(2, tr_("Matrices of the members"));
        text(tr_(
            "In the file's base units and radians; rows and columns in the order of the named degrees of freedom."));
        const Model solved = solved_model(model_, solution_);
        for (std::size_t i = 0; i < model_.members.size(); ++i) {
            const MemberTrace traced = trace(solved, MemberId(i));
            heading(3, tr_("Member {id}", {{"id", traced.member}}));
            heading(4, tr_("Stiffness in the member's own axes"));
            matrix(traced, traced.local_stiffness);
            heading(4, tr_("Transformation to the axes of the nodes"));
            matrix(traced, traced.transformation);
        }
    }
    void matrix(const MemberTrace& traced, const Eigen::MatrixXd& values)
    {
        Table rows{{{""}}, {}};
        for (const std::string& dof : traced.dofs) rows.headings.push_back(number_heading(dof));
        for (Eigen::Index i = 0; i < values.rows(); ++i) {
            Row row{std::nullopt, {Cell{traced.dofs.at(static_cast<std::size_t>(i))}}};
            for (Eigen::Index j = 0; j < values.cols(); ++j)
                row.cells.push_back({with_minus(ui::number_text(values(i, j), options_.view.numbers))});
            rows.rows.push_back(std::move(row));
        }
        table(rows);
    }

    const Model& model_;
    const Solution& solution_;
    const ReportOptions& options_;
    const ui::Fonts& fonts_;
    const ui::Catalogue& tr_;
    Manner manner_;
    ui::Report report_;
};

} // namespace

ui::Report make_report(const Model& model, const Solution& solution, const ReportOptions& options,
                       const ui::Fonts& fonts)
{
    return ReportWriter(model, solution, options, fonts).write();
}

} // namespace frame
