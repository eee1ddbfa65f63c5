// The calculation as a report: what it has for which structure, and that its numbers are those of the method.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apps/cross/document/file.h"
#include "apps/cross/report/calculation.h"
#include "femoop/methods/cross/superposition.h"
#include "ui/paint/surface/golden_text.h"
#include "ui/report/html.h"

using namespace cross;
namespace fc = femoop::cross;

namespace {

template <class Block> std::vector<Block> all(const ui::Report& report)
{
    std::vector<Block> found;
    for (const ui::ReportBlock& block : report.blocks)
        if (const auto* const one = std::get_if<Block>(&block)) found.push_back(*one);
    return found;
}

std::string headings(const ui::Report& report)
{
    std::string text;
    for (const auto& heading : all<ui::ReportHeading>(report))
        if (heading.level == 2) text += heading.text + "; ";
    return text;
}

ui::Report report_of(const Document& document, ui::Language language = ui::Language::English)
{
    Look look;
    look.tr = ui::Catalogue(language);
    return calculation(document, look, ui::Fonts());
}

/// The last row of the first table that begins with a row of that name.
std::vector<std::string> total_of_sheet(const ui::Report& report)
{
    for (const auto& table : all<tabular::Table>(report))
        for (const auto& row : table.rows)
            if (row.cells.front().shown == "Σ") return shown_texts(row);
    return {};
}

} // namespace

TEST_CASE("A calculation of a frame that sways has every sheet and the equations and the other methods")
{
    const ui::Report report = report_of(read_document_file("examples/portal.json"));
    CHECK(headings(report) ==
          "Structure and loads; Factors and fixed-end moments; Sheet of the loads; Sheet of the sway at B; Sways; "
          "All sheets together; Final moments; Diagrams; Kani's method; Slope-deflection equations; ");
    CHECK(all<ui::ReportFigure>(report).size() == 7);
}

TEST_CASE("The totals of a reported sheet are those of the distribution whatever was begun by hand")
{
    Document document = starting_document();
    document.plays.resize(1);
    document.plays[0].advance(femoop::cross::JointId(std::size_t{0}));
    const std::vector<std::string> total = total_of_sheet(report_of(document));
    CHECK(total == std::vector<std::string>{"Σ", "0.00", "−86.47", "86.54", "−108.99", "108.99", "−71.51"});
}

TEST_CASE("A sheet that was balanced by hand is reported as it was worked")
{
    Document document = starting_document();
    const Solution solution = solve(document);
    document.plays.resize(1);
    for (int i = 0; i < 12; ++i) document.plays[0].advance(std::nullopt); // all at once
    Solution worked = solution;
    work(worked, document);
    REQUIRE(worked.sheets[0].is_balanced);
    CHECK(balanced_document(document, worked).plays[0] == document.plays[0]);
    CHECK(balanced_document(starting_document(), solution).plays[0].length() ==
          solution.task->all->held.sheet.steps.size());
}

TEST_CASE("Rounded sheets are reported with what they would be exactly and the drift between")
{
    Document document = starting_document();
    document.method.digits = 3;
    const ui::Report report = report_of(document);
    bool has_drift = false;
    for (const auto& table : all<tabular::Table>(report))
        has_drift = has_drift ||
                    std::ranges::any_of(table.rows, [](const auto& row) { return row.cells[0].shown == "drift"; });
    CHECK(has_drift);
}

namespace {

/// Three spans and twelve more.
Document fifteen_spans()
{
    Document document = starting_document();
    femoop::Model& model = document.model;
    for (int i = 0; i < 12; ++i) {
        femoop::Node node = model.nodes.back();
        node.id = "N" + std::to_string(i);
        node.at[0] = femoop::Quantity(20.0 + 5.0 * (i + 1));
        femoop::Member member = model.members.back();
        member.id = "M" + std::to_string(i);
        member.nodes = {femoop::NodeId(model.nodes.size() - 1), model.add(std::move(node))};
        model.add(std::move(member));
    }
    return document;
}

std::size_t n_written(const std::string& text, const ui::Report& report)
{
    std::size_t n = 0;
    for (const auto& figure : all<ui::ReportFigure>(report)) {
        const std::string told = ui::golden_text(figure.picture);
        for (std::size_t at = told.find(text); at != std::string::npos; at = told.find(text, at + 1)) ++n;
    }
    return n;
}

} // namespace

TEST_CASE("Each column of a long beam's sheet is printed once, whole, beside its member end")
{
    const Document document = fifteen_spans();
    const Solution solution = solve(document);
    const ui::Report report = report_of(document);
    for (const fc::End& end : solution.task->problem.ends) {
        CAPTURE(end.label);
        CHECK(n_written('"' + end.label + '"', report) == 1);
    }
    CHECK(n_written("without room", report) == 0);
}

TEST_CASE("No table of a calculation is broader than a page however many spans there are")
{
    const Document document = fifteen_spans();
    for (const auto& table : all<tabular::Table>(report_of(document))) CHECK(table.columns.size() <= 11);
}

TEST_CASE("What cannot be distributed is reported with the reason")
{
    Document document = starting_document();
    document.model.analysis = femoop::AnalysisKind::Truss2d;
    CHECK(headings(report_of(document)) == "Not distributed; ");
}

TEST_CASE("A calculation speaks Portuguese and is one page of the web with its figures in it")
{
    const ui::Report report = report_of(starting_document(), ui::Language::Portuguese);
    CHECK(headings(report).starts_with("Estrutura e cargas; "));
    const std::string html = ui::report_html(report, ui::Fonts());
    CHECK(html.find("<html lang=\"pt-BR\">") != std::string::npos);
    CHECK(html.find("<svg") != std::string::npos);
    CHECK(html.find("<figcaption>") == std::string::npos);
}
