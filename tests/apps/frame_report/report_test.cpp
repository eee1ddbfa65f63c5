#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "apps/frame/report/html.h"
#include "apps/frame/report/pages.h"
#include "femoop/io/model_file.h"
#include "tests/folder.h"

using namespace frame;

namespace {

Report report_of(const std::string& file, ReportOptions options = {})
{
    const Document document{femoop::read_model_file(CREMONA_SOURCE_DIR "/" + file)};
    return make_report(document.model, solve(document), options, ui::Fonts());
}

template <class Block> std::vector<Block> all(const Report& report)
{
    std::vector<Block> found;
    for (const ReportBlock& block : report.blocks)
        if (const auto* const one = std::get_if<Block>(&block)) found.push_back(*one);
    return found;
}

bool says(const Report& report, const std::string& words)
{
    const std::string html = report_html(report, ui::Fonts());
    return html.find(words) != std::string::npos;
}

} // namespace

TEST_SUITE("frame report")
{
    TEST_CASE("A report has the data, the figures and the results of every case, and the check of equilibrium")
    {
        const Report report = report_of("examples/portal.json");
        // The structure, and for each of 3 cases and 2 combinations: loads, N, V, M, deformed shape.
        CHECK(all<ReportFigure>(report).size() == 1 + 5 * 5);
        CHECK(says(report, "58.52")); // M in the middle of BC under G
        CHECK(says(report, "Envelope of all cases"));
        CHECK(says(report, "Largest force out of balance"));
        CHECK(!says(report, "nan"));
    }

    TEST_CASE("The page needs no other file, and what the model says cannot break it")
    {
        Document document{femoop::read_model_file(CREMONA_SOURCE_DIR "/examples/portal.json")};
        document.model.title = "<script>alert(\"A & B\")</script>";
        const Report report = make_report(document.model, solve(document), {}, ui::Fonts());
        const std::string html = report_html(report, ui::Fonts());
        CHECK(html.find("<script>") == std::string::npos);
        CHECK(html.find("&lt;script&gt;alert(&quot;A &amp; B&quot;)") != std::string::npos);
        for (const char* link : {"src=", "href=\"http", "@import"}) CHECK(html.find(link) == std::string::npos);
    }

    TEST_CASE("A model that cannot be solved is reported with the reason")
    {
        const Report report = report_of("examples/mechanism.json");
        CHECK(says(report, "Not solved"));
        CHECK(says(report, "sway"));
    }

    TEST_CASE("In Portuguese a report is Portuguese, with decimal commas")
    {
        ReportOptions options;
        options.view.tr = ui::Catalogue(ui::Language::Portuguese);
        options.view.numbers.mark = ui::DecimalMark::Comma;
        const Report report = report_of("examples/portal.json", options);
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

    TEST_CASE("A long table goes on with its headings on the next page, and nothing stands outside the paper")
    {
        Report report;
        ReportTable table{{{"Node", false}, {"x [m]", true}}, {}};
        for (int i = 0; i < 200; ++i) table.rows.push_back({"N" + std::to_string(i), std::to_string(i)});
        report.blocks.emplace_back(ReportHeading{2, "Nodes"});
        report.blocks.emplace_back(table);
        const ui::Fonts fonts;
        const std::vector<ui::PdfPage> pages = report_pages(report, fonts);
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

    TEST_CASE("The pages are written as one PDF document")
    {
        const Folder folder;
        const ui::Fonts fonts;
        const auto pages = report_pages(report_of("examples/portal.json"), fonts);
        ui::write_pdf(folder.path() / "report.pdf", pages, fonts, {.background = ui::rgb(0xFFFFFF), .title = "Portal"});
        std::ifstream file(folder.path() / "report.pdf", std::ios::binary);
        const std::string content{std::istreambuf_iterator<char>(file), {}};
        CHECK(content.starts_with("%PDF"));
        CHECK(content.find("/Count " + std::to_string(pages.size())) != std::string::npos);
    }
}
