#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "apps/frame/report/report.h"
#include "femoop/io/model_file.h"
#include "tests/folder.h"
#include "tests/source_folder.h"
#include "tests/text_of.h"
#include "ui/paint/surface/golden_text.h"
#include "ui/report/html.h"
#include "ui/report/pages.h"

using namespace frame;

namespace {

ui::Report report_of(const std::string& file, ReportOptions options = {})
{
    const Document document{femoop::read_model_file(source_folder() + "/" + file)};
    return make_report(document.model, solve(document), options, ui::Fonts());
}

template <class Block> std::vector<Block> all(const ui::Report& report)
{
    std::vector<Block> found;
    for (const ui::ReportBlock& block : report.blocks)
        if (const auto* const one = std::get_if<Block>(&block)) found.push_back(*one);
    return found;
}

/// Its rows say "name 0", "name 1" and so on.
tabular::Table table_of(const std::string& name, int n_rows)
{
    tabular::Table table({"Row"});
    for (int i = 0; i < n_rows; ++i) table.add_row({name + " " + std::to_string(i)});
    return table;
}

/// The place of the first page on which the string stands.
std::optional<std::size_t> page_of(const std::vector<ui::PdfPage>& pages, const std::string& string)
{
    for (std::size_t i = 0; i < pages.size(); ++i)
        for (const ui::PlacedPicture& placed : pages[i].pictures)
            if (ui::golden_text(placed.picture).find(" \"" + string + "\"\n") != std::string::npos) return i;
    return std::nullopt;
}

/// The first table whose first column has this heading.
tabular::Table table_with(const ui::Report& report, const std::string& heading)
{
    for (const tabular::Table& table : all<tabular::Table>(report))
        if (table.columns.front().heading == heading) return table;
    return {};
}

/// The cells under the heading that begins like this; none where the table has no such column.
std::vector<std::string> column_of(const tabular::Table& table, const std::string& heading)
{
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].heading.starts_with(heading))
            for (const tabular::Row& row : table.rows) cells.push_back(row.cells[i].shown);
    return cells;
}

bool says(const ui::Report& report, const std::string& words)
{
    const std::string html = ui::report_html(report, ui::Fonts());
    return html.find(words) != std::string::npos;
}

} // namespace

TEST_SUITE("frame report")
{
    TEST_CASE("A report has the data, the figures and the results of every case, and the check of equilibrium")
    {
        const ui::Report report = report_of("examples/portal.json");
        // The structure, for each of 3 cases and 2 combinations: loads, N, V, M, deformed shape; bands of N, V, M.
        CHECK(all<ui::ReportFigure>(report).size() == 1 + 5 * 5 + 3);
        CHECK(says(report, "58.52")); // M in the middle of BC under G
        CHECK(says(report, "Envelope of all cases"));
        CHECK(says(report, "Largest force out of balance"));
        CHECK(!says(report, "nan"));
    }

    TEST_CASE("The table of sections has what a profile or a shape comes to, and a typed value wins")
    {
        Document document{femoop::read_model_file(source_folder() + "/examples/portal.json")};
        document.model.sections[1].Iz = femoop::Quantity(4.2e-4); // of IPE 400, whose table has 23130 cm^4
        const ui::Report report = make_report(document.model, solve(document), {}, ui::Fonts());
        const tabular::Table sections = table_with(report, "Section");
        // EN 10365, HEB 240 and IPE 400, in cm
        CHECK(column_of(sections, "A ") == std::vector<std::string>{"106", "84.5"});
        CHECK(column_of(sections, "Iz ") == std::vector<std::string>{"11260", "42000"});
        CHECK(column_of(sections, "Depth h ") == std::vector<std::string>{"24", "40"});
        for (const char* unused : {"Iy ", "J ", "Asy "}) CHECK(column_of(sections, unused).empty());
        CHECK(says(report, "Properties that were not typed are calculated from the profile or the shape."));
    }

    TEST_CASE("Shear areas stand in the table of sections where a member has shear strain, and no others in a plane")
    {
        Document document{femoop::read_model_file(source_folder() + "/examples/continuous_beam.json")};
        document.model.sections[0] = {.id = "s",
                                      .shape = femoop::SectionShape{.kind = femoop::SectionShapeKind::Rectangle}};
        document.model.sections[0].shape->b = 0.3;
        document.model.sections[0].shape->h = 0.5;
        document.model.members[0].theory = femoop::BeamTheory::Timoshenko;
        const ui::Report report = make_report(document.model, solve(document), {}, ui::Fonts());
        const tabular::Table sections = table_with(report, "Section");
        CHECK(column_of(sections, "Asy ") == std::vector<std::string>{"1250"}); // 5/6 b h
        CHECK(column_of(sections, "Asz ").empty());
    }

    TEST_CASE("A section that cannot be stays as it was typed in the report")
    {
        Document document{femoop::read_model_file(source_folder() + "/examples/portal.json")};
        document.model.sections[0].profile = "HEB 241";
        const ui::Report report = make_report(document.model, solve(document), {}, ui::Fonts());
        CHECK(column_of(table_with(report, "Section"), "A ").at(0).empty());
        CHECK(says(report, "HEB 241"));
    }

    TEST_CASE("The page needs no other file, and what the model says cannot break it")
    {
        Document document{femoop::read_model_file(source_folder() + "/examples/portal.json")};
        document.model.title = "<script>alert(\"A & B\")</script>";
        const ui::Report report = make_report(document.model, solve(document), {}, ui::Fonts());
        const std::string html = ui::report_html(report, ui::Fonts());
        CHECK(html.find("<script>") == std::string::npos);
        CHECK(html.find("&lt;script&gt;alert(&quot;A &amp; B&quot;)") != std::string::npos);
        for (const char* link : {"src=", "href=\"http", "@import"}) CHECK(html.find(link) == std::string::npos);
    }

    TEST_CASE("A model that cannot be solved is reported with the reason")
    {
        const ui::Report report = report_of("examples/mechanism.json");
        CHECK(says(report, "Not solved"));
        CHECK(says(report, "sway"));
    }

    TEST_CASE("A report about the data has the loads of every case and no result, and says so")
    {
        const ui::Report report = report_of("examples/portal.json", {.about = ReportAbout::Data});
        CHECK(all<ui::ReportFigure>(report).size() == 1 + 5);
        CHECK(says(report, "12 kN/m"));
        CHECK(!says(report, "58.52"));
        CHECK(!says(report, "54.27"));
        CHECK(says(report, "The results are hidden."));
    }

    TEST_CASE("In Portuguese a report is Portuguese, with decimal commas")
    {
        ReportOptions options;
        options.view.tr = ui::Catalogue(ui::Language::Portuguese);
        options.view.numbers.mark = ui::DecimalMark::Comma;
        const ui::Report report = report_of("examples/portal.json", options);
        CHECK(report.language == "pt-BR");
        CHECK(says(report, "58,52"));
        CHECK(says(report, "Equilíbrio"));
    }

    TEST_CASE("The matrices are those of the trace, if they are wanted")
    {
        ReportOptions options;
        CHECK(!says(report_of("examples/portal.json", options), "Matrices of the members"));
        options.matrices = true;
        CHECK(says(report_of("examples/portal.json", options), "Matrices of the members"));
    }

    TEST_CASE("A truss that is worked out by hand is worked out in the report, where statics alone gives its forces")
    {
        ReportOptions options;
        CHECK(!says(report_of("examples/pratt_truss.json", options), "Joint by joint"));
        options.truss = TrussMethod::Joints;
        const ui::Report joints = report_of("examples/pratt_truss.json", options);
        CHECK(says(joints, "N(L0U1) = −93.75 (compression)"));
        options.truss = TrussMethod::Cremona;
        CHECK(says(report_of("examples/pratt_truss.json", options), "Sides of the diagram"));
        CHECK(!says(report_of("tests/cases/members/TR-002.json", options), "Sides of the diagram"));
        CHECK(!says(report_of("examples/portal.json", options), "Sides of the diagram"));
        options.truss = TrussMethod::ZeroForces;
        CHECK(says(report_of("examples/pratt_truss.json", options), "L3U3 carries nothing: 1 of 21 bars."));
    }

    TEST_CASE("A long table goes on with its headings on the next page, and nothing stands outside the paper")
    {
        ui::Report report;
        tabular::Table table({"Node", {"x", "m", tabular::Alignment::Right}});
        for (int i = 0; i < 200; ++i) table.add_row({"N" + std::to_string(i), std::to_string(i)});
        report.blocks.emplace_back(ui::ReportHeading{2, "Nodes"});
        report.blocks.emplace_back(table);
        const ui::Fonts fonts;
        const std::vector<ui::PdfPage> pages = ui::report_pages(report, fonts);
        CHECK(pages.size() >= 3);
        for (const ui::PdfPage& page : pages) {
            for (const ui::PlacedPicture& placed : page.pictures) {
                for (const ui::Box& box : placed.picture.text_boxes(fonts)) {
                    CHECK(placed.corner.x + placed.scale * box.max.x <= page.size.width);
                    CHECK(placed.corner.y + placed.scale * box.max.y <= page.size.height);
                }
            }
        }
    }

    TEST_CASE("A table too wide for the paper goes on below itself in type that can be read, its rows named again")
    {
        ui::Report report;
        tabular::Table table({"Node"});
        table.add_row({"N1"});
        for (int i = 0; i < 30; ++i) {
            table.columns.push_back({"column " + std::to_string(i), "", tabular::Alignment::Right});
            table.rows[0].cells.push_back("value " + std::to_string(i));
        }
        report.blocks.emplace_back(table);
        const std::vector<ui::PdfPage> pages = ui::report_pages(report, ui::Fonts());
        REQUIRE(pages.size() == 1);
        const std::string words = ui::golden_text(pages[0].pictures.back().picture);
        CHECK(words.find("\"value 29\"") != std::string::npos);
        std::size_t n_named = 0;
        for (std::size_t at = words.find("\"N1\""); at != std::string::npos; at = words.find("\"N1\"", at + 1))
            ++n_named;
        CHECK(n_named > 2);
        for (const ui::Box& box : pages[0].pictures.back().picture.text_boxes(ui::Fonts())) {
            CHECK(box.max.x <= pages[0].size.width);
            CHECK(box.size().height >= 8.0);
        }
    }

    TEST_CASE("A heading stands on the page of the table under it, with three of its rows or all of a short one")
    {
        const ui::Fonts fonts;
        for (int n_before = 30; n_before < 75; ++n_before) { // rows, so that the heading comes anywhere on the page
            CAPTURE(n_before);
            ui::Report report;
            report.blocks.emplace_back(table_of("before", n_before));
            report.blocks.emplace_back(ui::ReportHeading{2, "Chapter"});
            report.blocks.emplace_back(ui::ReportHeading{3, "Part"});
            report.blocks.emplace_back(table_of("short", 5));
            report.blocks.emplace_back(ui::ReportHeading{3, "Long part"});
            report.blocks.emplace_back(table_of("long", 40));
            const std::vector<ui::PdfPage> pages = ui::report_pages(report, fonts);
            const std::optional<std::size_t> page = page_of(pages, "Chapter");
            for (const char* words : {"Part", "short 0", "short 4"}) CHECK(page_of(pages, words) == page);
            for (const char* words : {"long 0", "long 2"}) CHECK(page_of(pages, words) == page_of(pages, "Long part"));
        }
    }

    TEST_CASE("Every page of a report tells its number, how many there are, and of which report it is")
    {
        ui::Report report;
        report.title = "Portal frame";
        report.blocks.emplace_back(table_of("row", 180));
        const std::vector<ui::PdfPage> pages = ui::report_pages(report, ui::Fonts());
        REQUIRE(pages.size() == 3);
        CHECK(page_of(pages, "1 / 3") == 0);
        CHECK(page_of(pages, "3 / 3") == 2);
        CHECK(page_of({pages.begin() + 1, pages.end()}, "Portal frame") == 0);
    }

    TEST_CASE("A report calls a structure what people call it, and one member is not many")
    {
        Document document{femoop::read_model_file(source_folder() + "/examples/bent_cantilever.json")};
        CHECK(says(make_report(document.model, solve(document), {}, ui::Fonts()), "space frame, 3 nodes, 2 members"));
        const ui::Report truss = report_of("examples/truss.json");
        CHECK(says(truss, "plane truss, "));
        CHECK(!says(truss, "truss2d"));
        ReportOptions portuguese;
        portuguese.view.tr = ui::Catalogue(ui::Language::Portuguese);
        CHECK(says(report_of("examples/grillage.json", portuguese), "grelha, "));
    }

    TEST_CASE("The pages are written as one PDF document")
    {
        const Folder folder;
        const ui::Fonts fonts;
        const auto pages = ui::report_pages(report_of("examples/portal.json"), fonts);
        ui::write_pdf(folder.path() / "report.pdf", pages, fonts, {.background = ui::rgb(0xFFFFFF), .title = "Portal"});
        const std::string content = text_of(folder.path() / "report.pdf");
        CHECK(content.starts_with("%PDF"));
        CHECK(content.find("/Count " + std::to_string(pages.size())) != std::string::npos);
    }
}
