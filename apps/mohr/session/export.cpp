#include "apps/mohr/session/export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <string_view>
#include <system_error>

#include "apps/mohr/session/report.h"
#include "apps/mohr/view/axis.h"
#include "apps/mohr/view/names.h"
#include "femoop/files/whole_file.h"
#include "femoop/io/json/table_json.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/tabular/latex.h"
#include "femoop/tabular/markdown.h"
#include "femoop/tabular/separated.h"
#include "ui/files/ending.h"
#include "ui/workbench/file_sentences.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::translatable;

namespace {

/// The diagram in centimetres.
class Drawing {
public:
    explicit Drawing(const Session& session)
        : session_(session),
          s_(session.solution()),
          frame_(fitting_frame(session.document(), s_, Content::Circles)),
          scale_(width / std::max(frame_.high - frame_.low, 2.0 * frame_.reach))
    {}

    std::string text()
    {
        out_ << "\\begin{tikzpicture}[>=stealth]\n";
        add_axes();
        if (is_in_space(session_.document().subject)) add_space();
        else add_plane();
        out_ << "\\end{tikzpicture}\n";
        return out_.str();
    }

private:
    static constexpr double width = 9.0;

    std::string at(double normal, double shear) const
    {
        const auto cm = [&](double v) { return femoop::number_text(std::round(1e4 * scale_ * v) / 1e4 + 0.0); };
        return "(" + cm(normal) + "," + cm(shear) + ")";
    }
    std::string cm(double length) const { return femoop::number_text(std::round(1e4 * scale_ * length) / 1e4); }

    void add_axes()
    {
        const Names names = names_of(session_.document().subject);
        const double past = 0.08 * (frame_.high - frame_.low), low = std::min(frame_.low, 0.0) - past,
                     high = std::max(frame_.high, 0.0) + past;
        const double reach = 1.15 * frame_.reach, tip = s_.rule == fm::ShearRule::ClockwiseUp ? reach : -reach;
        out_ << "  \\draw[->] " << at(low, 0.0) << " -- " << at(high, 0.0) << " node[right] {"
             << tabular::latex_text(axis_title(names.normal, s_.unit)) << "};\n";
        out_ << "  \\draw[->] " << at(0.0, -tip) << " -- " << at(0.0, tip) << " node[right] {"
             << tabular::latex_text(axis_title(names.shear, s_.unit)) << "};\n";
    }

    void add_circle(const fm::Circle& circle, std::string_view style)
    {
        out_ << "  \\draw[" << style << "] " << at(circle.centre, 0.0) << " circle (" << cm(circle.radius) << ");\n";
    }

    void add_point(double normal, double shear, const std::string& name, std::string_view side)
    {
        out_ << "  \\fill " << at(normal, shear) << " circle (0.05) node[" << side << "] {" << tabular::latex_text(name)
             << "};\n";
    }

    void add_plane()
    {
        const auto face = [&](double angle) { return fm::face_point(s_.plane, angle, fm::ShearRule::ClockwiseUp); };
        const fm::CirclePoint x = face(0.0), y = face(0.5 * std::numbers::pi), n = face(s_.angle);
        const fm::CirclePoint p = fm::pole(s_.plane, fm::ShearRule::ClockwiseUp);
        const Names names = names_of(session_.document().subject);
        add_circle(s_.circle, "thick");
        out_ << "  \\draw " << at(x.normal, x.shear) << " -- " << at(y.normal, y.shear) << ";\n";
        out_ << "  \\draw[dashed] " << at(x.normal, x.shear) << " -- " << at(p.normal, p.shear) << " -- "
             << at(n.normal, n.shear) << ";\n";
        const auto side = [](const fm::CirclePoint& point) { return point.shear < 0.0 ? "below" : "above"; };
        add_point(x.normal, x.shear, "X", side(x));
        add_point(y.normal, y.shear, "Y", side(y));
        add_point(n.normal, n.shear, "N", "right");
        add_point(p.normal, p.shear, "P", side(p));
        add_point(s_.circle.centre, 0.0, "C", "below");
        add_point(s_.principal.first, 0.0, names.first, "above right");
        add_point(s_.principal.second, 0.0, names.second, "above left");
    }

    void add_space()
    {
        const Names names = names_of(session_.document().subject);
        for (const fm::Circle& circle : fm::circles(s_.space_principal)) add_circle(circle, "thick");
        const std::array<std::string, 3> words{names.first, names.second, names.third};
        constexpr std::array<std::string_view, 3> sides{"below right", "below", "below left"};
        for (std::size_t i = 0; i < 3; ++i) add_point(s_.space_principal.values[i], 0.0, words[i], sides[i]);
        add_point(s_.on_plane.normal_component, s_.on_plane.shear, "N", "right");
    }

    const Session& session_;
    const Solution& s_;
    Frame frame_;
    double scale_;
    std::ostringstream out_;
};

/// Names and values with their units, both as words.
tabular::Table words_of(const tabular::Table& group)
{
    tabular::Table words = columns_of(group, {0, 1});
    words.columns[1].alignment = tabular::Alignment::Left;
    return words;
}

} // namespace

tabular::Table result_list(const Session& session)
{
    tabular::Table list({"group", "name", "value", "unit"});
    for (const tabular::Table& group : result_tables(session))
        for (const tabular::Row& row : group.rows)
            list.add_row({group.title, row.cells[0], row.cells[1], row.cells[2]});
    return list;
}

std::string latex(const Session& session)
{
    std::string text = "\\documentclass{article}\n\\usepackage[T1]{fontenc}\n\\usepackage[utf8]{inputenc}"
                       "\n\\usepackage{tikz}\n\\begin{document}\n"
                       "\\begin{center}\n" +
                       Drawing(session).text() + "\\end{center}\n\n";
    for (const tabular::Table& group : result_tables(session))
        text += "\\noindent\\begin{minipage}{\\linewidth}\n\\textbf{" + tabular::latex_text(group.title) + "}\n\n" +
                tabular::latex(words_of(group)) + "\\end{minipage}\n\n\\medskip\n";
    return text + "\\end{document}\n";
}

std::string markdown(const Session& session)
{
    std::string text;
    for (const tabular::Table& group : result_tables(session))
        text += (text.empty() ? "" : "\n") + tabular::markdown(words_of(group));
    return text;
}

std::optional<Exported> export_results(const Session& session, const std::filesystem::path& path)
{
    std::function<std::string()> text;
    if (ui::has_ending(path, ".csv")) text = [&] { return tabular::separated(result_list(session)); };
    else if (ui::has_ending(path, ".json")) text = [&] { return femoop::table_json(result_list(session)); };
    else if (ui::has_ending(path, ".md")) text = [&] { return markdown(session); };
    else if (ui::has_ending(path, ".tex")) text = [&] { return latex(session); };
    else return std::nullopt;
    if (session.is_concealing())
        return Exported{ui::Message(translatable("The results are shown when the exercise is done."))};
    const std::error_code error = files::write_whole_file(path, text());
    if (!error) return Exported{};
    return Exported{ui::not_written(path, error.message())};
}

} // namespace mohr
