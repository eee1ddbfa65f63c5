#include "apps/mohr/session/export.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string_view>
#include <utility>

#include "apps/mohr/session/report.h"
#include "apps/mohr/view/axis.h"
#include "apps/mohr/view/names.h"
#include "femoop/io/whole_file.h"
#include "femoop/model/quantity/number_text.h"
#include "ui/files/ending.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::translatable;

namespace {

std::string quoted(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
}

/// With the minus signs that spreadsheets read.
std::string plain(std::string text)
{
    constexpr std::string_view minus = "−";
    for (auto at = text.find(minus); at != std::string::npos; at = text.find(minus))
        text.replace(at, minus.size(), "-");
    return text;
}

using Sign = std::pair<std::string_view, std::string_view>;

/// Letters that take what follows them as an index.
constexpr std::array<Sign, 7> tex_letters{{{"σ", "\\sigma"},
                                           {"τ", "\\tau"},
                                           {"ε", "\\varepsilon"},
                                           {"γ", "\\gamma"},
                                           {"θ", "\\theta"},
                                           {"ν", "\\nu"},
                                           {"φ", "\\varphi"}}};

constexpr std::array<Sign, 23> tex_signs{{
    {"′", "\\ensuremath{'}"},
    {"°", "\\ensuremath{^\\circ}"},
    {"−", "\\ensuremath{-}"},
    {"·", "\\ensuremath{\\cdot}"},
    {"√", "\\ensuremath{\\surd}"},
    {"⁰", "\\ensuremath{^0}"},
    {"¹", "\\ensuremath{^1}"},
    {"²", "\\ensuremath{^2}"},
    {"³", "\\ensuremath{^3}"},
    {"⁴", "\\ensuremath{^4}"},
    {"⁻", "\\ensuremath{^{-}}"},
    {"⁶", "\\ensuremath{^{6}}"},
    {"–", "--"},
    {"_", "\\_"},
    {"%", "\\%"},
    {"&", "\\&"},
    {"#", "\\#"},
    {"$", "\\$"},
    {"{", "\\{"},
    {"}", "\\}"},
    {"^", "\\textasciicircum{}"},
    {"~", "\\textasciitilde{}"},
    {"\\", "\\textbackslash{}"},
}};

template <std::size_t N> const Sign* sign_at(std::string_view text, const std::array<Sign, N>& signs)
{
    const auto found = std::ranges::find_if(signs, [&](const Sign& sign) { return text.starts_with(sign.first); });
    return found == signs.end() ? nullptr : &*found;
}

/// The letters, digits and primes at the beginning of a text: an index. They are taken from it.
std::string index_of(std::string_view& text)
{
    constexpr std::string_view prime = "′";
    std::string index;
    while (!text.empty()) {
        const bool is_prime = text.starts_with(prime);
        const bool is_plain = std::isalnum(static_cast<unsigned char>(text.front())) != 0;
        if (!is_prime && !is_plain) break;
        index += is_prime ? '\'' : text.front();
        text.remove_prefix(is_prime ? prime.size() : 1);
    }
    return index;
}

/// Plain text as LaTeX writes it: Greek letters with their indices, and a minus before a number, are mathematics.
std::string tex(std::string_view text)
{
    std::string out;
    while (!text.empty()) {
        if (const Sign* letter = sign_at(text, tex_letters)) {
            text.remove_prefix(letter->first.size());
            const std::string index = index_of(text);
            out += "\\ensuremath{" + std::string(letter->second) + (index.empty() ? "" : "_{" + index + "}") + "}";
            continue;
        }
        const Sign* const sign = sign_at(text, tex_signs);
        const bool is_minus = text.front() == '-' && text.size() > 1 && text[1] >= '0' && text[1] <= '9';
        if (sign != nullptr) out += sign->second;
        else out += is_minus ? "\\ensuremath{-}" : std::string(1, text.front());
        text.remove_prefix(sign != nullptr ? sign->first.size() : 1);
    }
    return out;
}

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
             << tex(axis_title(names.normal, s_.unit)) << "};\n";
        out_ << "  \\draw[->] " << at(0.0, -tip) << " -- " << at(0.0, tip) << " node[right] {"
             << tex(axis_title(names.shear, s_.unit)) << "};\n";
    }

    void add_circle(const fm::Circle& circle, std::string_view style)
    {
        out_ << "  \\draw[" << style << "] " << at(circle.centre, 0.0) << " circle (" << cm(circle.radius) << ");\n";
    }

    void add_point(double normal, double shear, const std::string& name, std::string_view side)
    {
        out_ << "  \\fill " << at(normal, shear) << " circle (0.05) node[" << side << "] {" << tex(name) << "};\n";
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

} // namespace

std::string csv(const Session& session)
{
    std::string text = "group,name,value,unit\n";
    for (const ResultGroup& group : result_groups(session))
        for (const ResultLine& line : group.lines) {
            const std::string value = line.number ? femoop::number_text(*line.number + 0.0) : line.value;
            text += quoted(group.heading) + "," + quoted(line.name) + "," + quoted(plain(value)) + "," +
                    quoted(line.unit) + "\n";
        }
    return text;
}

std::string latex(const Session& session)
{
    std::string text = "\\documentclass{article}\n\\usepackage[T1]{fontenc}\n\\usepackage[utf8]{inputenc}"
                       "\n\\usepackage{tikz}\n\\begin{document}\n"
                       "\\begin{center}\n" +
                       Drawing(session).text() + "\\end{center}\n\n";
    for (const ResultGroup& group : result_groups(session)) {
        text += "\\noindent\\begin{minipage}{\\linewidth}\n\\textbf{" + tex(group.heading) +
                "}\n\n\\begin{tabular}{ll}\n";
        for (const ResultLine& line : group.lines) text += tex(line.name) + " & " + tex(line.value) + " \\\\\n";
        text += "\\end{tabular}\n\\end{minipage}\n\n\\medskip\n";
    }
    return text + "\\end{document}\n";
}

std::optional<Exported> export_results(const Session& session, const std::filesystem::path& path)
{
    const bool is_csv = ui::has_ending(path, ".csv");
    if (!is_csv && !ui::has_ending(path, ".tex")) return std::nullopt;
    if (session.is_concealing())
        return Exported{ui::Phrase(translatable("The results are shown when the exercise is done."))};
    const std::error_code error = femoop::write_whole_file(path, is_csv ? csv(session) : latex(session));
    if (!error) return Exported{};
    return Exported{ui::Phrase(translatable("{file} cannot be written: {reason}"),
                               {{"file", path.filename().string()}, {"reason", error.message()}})};
}

} // namespace mohr
