#include <doctest/doctest.h>

#include <string>

#include "femoop/tabular/html.h"
#include "femoop/tabular/latex.h"
#include "femoop/tabular/markdown.h"

using namespace tabular;

TEST_SUITE_BEGIN("tabular");

namespace {

Table moments()
{
    Table table({"end", {"M", "kN*m"}});
    table.title = "Sheet";
    table.notes = {"Rounded to 2 digits."};
    table.add_row({"A_B", {-64.0, "−64.0"}});
    table.add_row({"sum", ""});
    table.n_sums = 1;
    return table;
}

} // namespace

TEST_CASE("The ten characters that mean something to LaTeX are escaped")
{
    CHECK(latex_text("$ { } ^ ~ \\ & % # _") ==
          "\\$ \\{ \\} \\textasciicircum{} \\textasciitilde{} \\textbackslash{} \\& \\% \\# \\_");
}

TEST_CASE("Greek letters take their index along, and a minus is one only before a number of its own")
{
    CHECK(latex_text("σ1") == "\\ensuremath{\\sigma_{1}}");
    CHECK(latex_text("τx′y′") == "\\ensuremath{\\tau_{x'y'}}");
    CHECK(latex_text("-3.5") == "\\ensuremath{-}3.5");
    CHECK(latex_text("(-3; −4)") == "(\\ensuremath{-}3; \\ensuremath{-}4)");
    CHECK(latex_text("N-3") == "N-3");
    CHECK(latex_text("2,226e+06 kN") == "2,226\\ensuremath{\\cdot 10^{6}} kN");
    CHECK(latex_text("-1.5e-05") == "\\ensuremath{-}1.5\\ensuremath{\\cdot 10^{-5}}");
    CHECK(latex_text("pile-3, 2e+1a") == "pile-3, 2e+1a");
}

TEST_CASE("A formula for LaTeX has powers, minus and decimal comma of mathematics")
{
    CHECK(latex_formula("−42,7 + 5,06e+01 x² - 3e-05 x³") == "-42{,}7 + 5{,}06\\cdot 10^{1} x^2 - 3\\cdot 10^{-5} x^3");
    CHECK(latex_formula("1 + …") == "1 + \\ldots");
}

TEST_CASE("A row of LaTeX cannot be taken for an option of the line above it")
{
    for (const char* name : {"[2cm]", "*"}) {
        Table table({""});
        table.add_row({name});
        CHECK(latex(table) == "\\begin{tabular}{l}\n{}" + std::string(name) + " \\\\\n\\end{tabular}\n");
    }
    CHECK(latex_text("two\nlines") == "two lines");
}

TEST_CASE("A table in LaTeX has its headings and its sums between rules, and none without headings")
{
    CHECK(latex(moments()) == "\\begin{tabular}{lr}\n\\hline\nend & M [kN*m] \\\\\n\\hline\n"
                              "A\\_B & \\ensuremath{-}64.0 \\\\\n\\hline\nsum &  \\\\\n\\hline\n\\end{tabular}\n");
    Table bare({"", ""});
    bare.add_row({"radius", "45 MPa"});
    CHECK(latex(bare) == "\\begin{tabular}{ll}\nradius & 45 MPa \\\\\n\\end{tabular}\n");
}

TEST_CASE("Markdown has title, notes and pipes, and shows what means something to it as it is")
{
    CHECK(markdown(moments()) == "### Sheet\n\nRounded to 2 digits.\n\n| end | M \\[kN\\*m\\] |\n|---|---:|\n"
                                 "| A\\_B | −64.0 |\n| sum |  |\n");
    CHECK(markdown_text("a|b\\c<d>\n`e`") == "a\\|b\\\\c\\<d\\><br>\\`e\\`");
}

TEST_CASE("HTML shows every text as it is, numbers to the right")
{
    CHECK(html_text("a<b> & \"c\" 'd'\ne") == "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;<br>\ne");
    CHECK(html(moments()) == "<table>\n<thead><tr><th>end</th><th class=\"n\">M [kN*m]</th></tr></thead>\n<tbody>\n"
                             "<tr><td>A_B</td><td class=\"n\">−64.0</td></tr>\n"
                             "<tr><td>sum</td><td class=\"n\"></td></tr>\n</tbody>\n</table>\n");
}

TEST_CASE("A part of a table keeps its words and its sums")
{
    const Table part = columns_of(moments(), {1});
    CHECK(part.title == "Sheet");
    CHECK(part.n_sums == 1);
    CHECK(part.columns[0].label() == "M [kN*m]");
    CHECK(part.rows[0].cells == std::vector<Cell>{{-64.0, "−64.0"}});
}

TEST_SUITE_END();
