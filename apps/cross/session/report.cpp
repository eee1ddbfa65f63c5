#include "apps/cross/session/report.h"

#include "apps/cross/session/exercise_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "apps/cross/view/numbers.h"
#include "apps/cross/view/sheet_parts.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/io/cross/cross_table.h"
#include "femoop/io/cross/half_text.h"

namespace cross {

namespace fc = femoop::cross;
using ui::translatable;

namespace {

/// Builds the tables of one session.
class Teller {
public:
    explicit Teller(const Scene& scene)
        : scene_(scene),
          tr_(scene.look.tr),
          model_(scene.document.model),
          task_(*scene.solution.task),
          problem_(task_.problem),
          half_(scene.solution.sheet_problem(scene.document)),
          sheet_(scene.solution.sheet(scene.document)),
          numbers_(scene.document, scene.solution, scene.look)
    {}

    TextTable sheet() const
    {
        TextTable table{.notes = {}, .head = ends_head(tr_("Row"))};
        add_symmetry(table);
        std::vector<std::string> factors{tr_("factors")};
        const std::vector<double> all = fc::factors_of(half_, scene_.document.method.digits);
        for (std::size_t e = 0; e < all.size(); ++e) {
            const auto joint = half_.is_on_sheet(fc::EndId(e)) ? half_.ends[e].joint : std::nullopt;
            factors.push_back(joint && half_.is_balanced(*joint) ? numbers_.factor(all[e]) : "");
        }
        table.rows.push_back(std::move(factors));
        if (sheet_ == nullptr) {
            add_parts(table);
            table.rows.push_back(row(tr_("together"), task_.all->moments));
            return table;
        }
        for (const fc::Row& written : fc::rows_of(half_, *sheet_))
            table.rows.push_back(row(name_of(written), written.values, written.kind));
        add_drift(table);
        return table;
    }

    /// The loads, and so many times each sway.
    void add_parts(TextTable& table) const
    {
        for (const SheetPart& part : parts_of(scene_)) table.rows.push_back(row(words_of(part, scene_), part.moments));
    }

    TextTable comparison() const
    {
        if (!task_.comparison) return missing();
        const fc::Comparison& c = *task_.comparison;
        TextTable table{
            .notes = {tr_("Worked to the tolerance; the stiffness method takes axial strain into account.")},
            .head = {tr_("member end"), tr_("distributed"), tr_("exact"), tr_("inextensible"), tr_("stiffness")}};
        for (std::size_t e = 0; e < problem_.ends.size(); ++e) {
            const fc::End& end = problem_.ends[e];
            table.rows.push_back({end.label, numbers_.moment(end, c.distributed[e]), numbers_.moment(end, c.limit[e]),
                                  numbers_.moment(end, c.inextensible[e]), numbers_.moment(end, c.stiffness[e])});
        }
        for (std::size_t j = 0; j < problem_.joints.size(); ++j)
            table.notes.push_back(tr_("Joint {joint}: difference {moment}",
                                      {{"joint", name_of(fc::JointId(j))}, {"moment", amount(c.difference[j])}}));
        return table;
    }

    TextTable sways() const
    {
        if (problem_.sways.empty() && !problem_.halves.empty())
            return {.notes = {tr_("By symmetry the loads do not make it sway: it has one sheet.")}};
        if (problem_.sways.empty()) return {.notes = {tr_("Without a prop nothing moves: the structure cannot sway.")}};
        if (!task_.all) return missing();
        const fc::Superposition& all = *task_.all;
        TextTable table{.notes = {tr_("No prop may hold anything: R_jk is the force at prop j in the sheet of sway k, "
                                      "R_j0 in the sheet of the loads.")},
                        .head = {tr_("Prop"), "R_j0"}};
        for (std::size_t k = 0; k < problem_.sways.size(); ++k) table.head.push_back("R_j" + std::to_string(k + 1));
        table.head.push_back("x");
        for (std::size_t j = 0; j < problem_.sways.size(); ++j) table.rows.push_back(sway_row(all, j));
        for (std::size_t j = 0; j < problem_.sways.size(); ++j)
            table.notes.push_back(tr_("prop {node}", {{"node", model_[problem_.sways[j].prop].id}}) + ": " +
                                  equation(all, j));
        return table;
    }

    TextTable convergence() const
    {
        if (sheet_ == nullptr) return missing();
        const std::vector<double> history = fc::convergence(*sheet_);
        TextTable table{.notes = {}, .head = {tr_("Step"), tr_("Joint"), tr_("largest unbalance")}};
        for (std::size_t i = 0; i < history.size(); ++i) {
            const auto joint = i == 0 ? std::nullopt : sheet_->steps[i - 1].joint;
            const std::string name = i == 0 ? "" : joint ? name_of(*joint) : tr_("all");
            table.rows.push_back({std::to_string(i), name, numbers_.moment(history[i])});
        }
        if (const auto rate = fc::rate(half_, *sheet_))
            table.notes.push_back(tr_("In one round of all joints the unbalance shrinks to {rate} of what it was.",
                                      {{"rate", numbers_.factor(*rate)}}));
        table.notes.push_back(tr_("Tolerance: {moment}", {{"moment", amount(sheet_->tolerance)}}));
        return table;
    }

    TextTable kani() const
    {
        if (!task_.kani) return missing();
        const fc::Kani& k = *task_.kani;
        TextTable table{
            .notes = {tr_(
                "Rotation contributions M', cycle by cycle; M = FEM + 2 M' + M' of the far end + sway part.")},
            .head = ends_head(tr_("Cycle"))};
        std::vector<std::string> factors{"μ"};
        for (const double factor : k.rotation_factor) factors.push_back(signed_factor(factor));
        table.rows.push_back(std::move(factors));
        table.rows.push_back(row("FEM", problem_.loading.fixed_end));
        for (std::size_t i = 0; i < std::min<std::size_t>(k.cycles.size(), most_cycles); ++i)
            table.rows.push_back(row(std::to_string(i + 1), k.cycles[i].rotation_contribution));
        if (!problem_.sways.empty() && !k.cycles.empty())
            table.rows.push_back(row("M″", without_dust(k.cycles.back().sway_contribution)));
        table.rows.push_back(row("M", k.moments));
        return table;
    }

    TextTable equations() const
    {
        if (!task_.equations) return missing();
        const fc::SlopeDeflection& s = *task_.equations;
        TextTable table{
            .notes = {tr_("Moments at every joint and the work of every sway, A x = b, in the file's base units.")},
            .head = {""}};
        for (Eigen::Index j = 0; j < s.x.size(); ++j) table.head.push_back(unknown(j));
        table.head.insert(table.head.end(), {"b", "x"});
        for (Eigen::Index i = 0; i < s.x.size(); ++i) {
            std::vector<std::string> line{unknown(i)};
            for (Eigen::Index j = 0; j < s.x.size(); ++j) line.push_back(plain(s.A(i, j)));
            line.push_back(plain(s.b[i]));
            line.push_back(plain(is_dust(s, i) ? 0.0 : s.x[i]));
            table.rows.push_back(std::move(line));
        }
        return table;
    }

private:
    static constexpr std::size_t most_cycles = 40; // shown

    /// Why half is enough where it is worked; that it would be, where the whole is; why it is not, where it is asked
    /// for.
    void add_symmetry(TextTable& table) const
    {
        const auto tr = [&](std::string_view text) { return tr_(text); };
        if (sheet_ == nullptr) return;
        if (half_.mirror) {
            table.notes = fc::half_text(model_, half_, tr);
            return;
        }
        if (!task_.by_halves) {
            if (scene_.document.method.extent == fc::Extent::Half)
                table.notes.push_back(fault_text(*task_.why_not_by_halves, tr_));
            return;
        }
        const fc::Problem* const half = offered_half();
        table.notes.push_back(half != nullptr ? fc::half_text(model_, *half, tr).front()
                                              : tr_("By symmetry the loads do not cause this sway."));
        table.notes.push_back(tr_("Method › Half of it, by symmetry takes this shortcut."));
    }

    /// Of the sheet that is worked as a whole; null for a sway that does not happen.
    const fc::Problem* offered_half() const
    {
        const std::size_t stage = scene_.document.stage;
        const fc::Problem& offered = *task_.by_halves;
        if (stage == 0) return &offered.of_sheet(0);
        const auto sway = std::ranges::find(offered.sways, problem_.sways[stage - 1].prop, &fc::Sway::prop);
        if (sway == offered.sways.end()) return nullptr;
        return &offered.of_sheet(1 + static_cast<std::size_t>(sway - offered.sways.begin()));
    }

    /// What the rounding of every number cost.
    void add_drift(TextTable& table) const
    {
        if (scene_.document.method.digits == 0 || sheet_->steps.empty()) return;
        const std::vector<double> off = fc::drift(half_, task_.loading(scene_.document.stage), *sheet_);
        std::vector<double> exact = sheet_->end.moments;
        for (std::size_t e = 0; e < exact.size(); ++e) exact[e] -= off[e];
        const Numbers unrounded = numbers_.unrounded();
        table.rows.push_back(row(tr_("exact"), exact, unrounded));
        table.rows.push_back(row(tr_("drift"), off, unrounded));
    }

    std::vector<std::string> row(const std::string& name, const std::vector<double>& values,
                                 const Numbers& numbers) const
    {
        std::vector<std::string> line{name};
        for (std::size_t e = 0; e < values.size(); ++e) line.push_back(numbers.moment(problem_.ends[e], values[e]));
        return line;
    }

    TextTable missing() const
    {
        TextTable table{.notes = {tr_("There is nothing to show here yet.")}};
        for (const femoop::Fault& fault : task_.remarks) table.notes.push_back(fault_text(fault, tr_));
        return table;
    }

    std::vector<std::string> ends_head(const std::string& first) const
    {
        std::vector<std::string> head{first};
        for (const fc::End& end : problem_.ends) head.push_back(end.label);
        return head;
    }

    /// Zeros of balances and carry-overs are left blank, as on paper; beyond the axis, all but the sums.
    std::vector<std::string> row(const std::string& name, const std::vector<double>& values,
                                 fc::RowKind kind = fc::RowKind::FixedEnd) const
    {
        const bool is_sparse = kind == fc::RowKind::Balance || kind == fc::RowKind::CarryOver;
        std::vector<std::string> line{name};
        for (std::size_t e = 0; e < values.size(); ++e) {
            const bool is_blank = (is_sparse && values[e] == 0.0) ||
                                  (kind != fc::RowKind::Total && !half_.is_on_sheet(fc::EndId(e)));
            line.push_back(is_blank ? "" : numbers_.moment(problem_.ends[e], values[e]));
        }
        return line;
    }

    std::string name_of(fc::JointId joint) const { return model_[problem_[joint].node].id; }

    std::string name_of(const fc::Row& written) const
    {
        switch (written.kind) {
        case fc::RowKind::FixedEnd: return "FEM";
        case fc::RowKind::Balance: return written.joint ? "BAL " + name_of(*written.joint) : "BAL";
        case fc::RowKind::CarryOver: return "CO";
        case fc::RowKind::Total: return "Σ";
        }
        return "";
    }

    /// An unknown that is nothing but rounding beside what its row of the equations adds up.
    static bool is_dust(const fc::SlopeDeflection& s, Eigen::Index i)
    {
        return std::abs(s.A(i, i) * s.x[i]) < 1e-9 * s.b.lpNorm<Eigen::Infinity>();
    }
    std::vector<double> without_dust(std::vector<double> moments) const
    {
        double largest = 0.0;
        for (const double moment : task_.all->moments) largest = std::max(largest, std::abs(moment));
        for (double& moment : moments)
            if (std::abs(moment) < 1e-9 * largest) moment = 0.0;
        return moments;
    }

    std::string amount(double moment) const { return numbers_.moment(moment) + " " + numbers_.moment_unit(); }
    std::string force(double value) const
    {
        return drawing::with_minus(numbers_.units().text(value, ui::Measure::Force));
    }
    std::string plain(double value) const
    {
        return drawing::with_minus(ui::number_text(value, numbers_.units().format()));
    }
    std::string signed_factor(double value) const
    {
        return value < 0.0 ? "−" + numbers_.factor(-value) : numbers_.factor(value);
    }

    std::vector<std::string> sway_row(const fc::Superposition& all, std::size_t j) const
    {
        const auto i = static_cast<Eigen::Index>(j);
        std::vector<std::string> line{model_[problem_.sways[j].prop].id, force(-all.r[i])};
        for (Eigen::Index k = 0; k < all.x.size(); ++k) line.push_back(force(all.R(i, k)));
        line.push_back(plain(all.x[i]));
        return line;
    }

    /// "−19.3 + 62.1 x1 = 0".
    std::string equation(const fc::Superposition& all, std::size_t j) const
    {
        const auto i = static_cast<Eigen::Index>(j);
        std::string text = plain(-all.r[i]);
        for (Eigen::Index k = 0; k < all.x.size(); ++k)
            text += (all.R(i, k) < 0.0 ? " − " : " + ") + plain(std::abs(all.R(i, k))) + " x" + std::to_string(k + 1);
        return text + " = 0";
    }

    std::string unknown(Eigen::Index i) const
    {
        const auto n = static_cast<std::size_t>(i), n_joints = problem_.joints.size();
        if (n < n_joints) return "θ" + name_of(fc::JointId(n));
        return "Δ" + model_[problem_.sways[n - n_joints].prop].id;
    }

    const Scene& scene_;
    const ui::Catalogue& tr_;
    const femoop::Model& model_;
    const Task& task_;
    const fc::Problem& problem_;
    const fc::Problem& half_; ///< what the sheet is worked on: `problem_` unless by symmetry
    const fc::Sheet* sheet_;
    Numbers numbers_;
};

std::string in_quotes(const std::string& text, char mark)
{
    if (text.find_first_of(std::string("\"\r\n") + mark) == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

/// Characters that mean something to LaTeX, and those that it writes in mathematics.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> latex_signs{{{"&", "\\&"},
                                                                                     {"%", "\\%"},
                                                                                     {"#", "\\#"},
                                                                                     {"_", "\\_"},
                                                                                     {"$", "\\$"},
                                                                                     {"{", "\\{"},
                                                                                     {"}", "\\}"},
                                                                                     {"^", "\\textasciicircum{}"},
                                                                                     {"~", "\\textasciitilde{}"},
                                                                                     {"\\", "\\textbackslash{}"},
                                                                                     {"<", "\\textless{}"},
                                                                                     {">", "\\textgreater{}"},
                                                                                     {"−", "$-$"},
                                                                                     {"Σ", "$\\Sigma$"},
                                                                                     {"θ", "$\\theta$"},
                                                                                     {"Δ", "$\\Delta$"},
                                                                                     {"μ", "$\\mu$"},
                                                                                     {"″", "$''$"}}};

std::string in_latex(std::string_view text)
{
    std::string out;
    while (!text.empty()) {
        const auto* const sign = std::ranges::find_if(latex_signs,
                                                      [&](const auto& one) { return text.starts_with(one.first); });
        const bool is_plain = sign == latex_signs.end();
        out += is_plain ? text.substr(0, 1) : sign->second;
        text.remove_prefix(is_plain ? 1 : sign->first.size());
    }
    return out;
}

std::string in_lines(const std::vector<femoop::Fault>& faults, const ui::Catalogue& tr)
{
    std::string words;
    for (const femoop::Fault& fault : faults) words += fault_text(fault, tr) + "\n";
    return words;
}

} // namespace

TextTable table_of(const Session& session, Topic topic)
{
    if (session.hides_results() || (topic == Topic::Exercises && session.paper() != nullptr))
        return exercise_table(session);
    return table_of(session.scene(), topic);
}

TextTable table_of(const Scene& scene, Topic topic)
{
    const Teller teller(scene);
    switch (topic) {
    case Topic::Sheet: return teller.sheet();
    case Topic::Comparison: return teller.comparison();
    case Topic::Sways: return teller.sways();
    case Topic::Convergence: return teller.convergence();
    case Topic::Kani: return teller.kani();
    case Topic::Equations: return teller.equations();
    case Topic::Exercises: break;
    }
    return {};
}

std::string as_csv(const TextTable& table, ui::Language language)
{
    const char mark = language == ui::Language::Portuguese ? ';' : ',';
    std::string text;
    const auto add = [&](const std::vector<std::string>& row) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            std::string cell = row[i];
            if (cell.starts_with("−")) cell = "-" + cell.substr(std::string_view("−").size()); // for spreadsheets
            text += (i == 0 ? "" : std::string(1, mark)) + in_quotes(cell, mark);
        }
        text += "\n";
    };
    add(table.head);
    std::ranges::for_each(table.rows, add);
    return text;
}

std::string as_latex(const TextTable& table)
{
    std::string text = "\\begin{tabular}{l" + std::string(table.head.size() - 1, 'r') + "}\n\\hline\n";
    const auto add = [&](const std::vector<std::string>& row) {
        for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : " & ") + in_latex(row[i]);
        text += " \\\\\n";
    };
    add(table.head);
    text += "\\hline\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (i + 1 == table.rows.size()) text += "\\hline\n";
        add(table.rows[i]);
    }
    return text + "\\hline\n\\end{tabular}\n";
}

std::string in_words(const Session& session)
{
    if (session.hides_results()) return exercise_in_words(session);
    const auto& task = session.solution().task;
    if (!task) return in_lines(session.solution().faults, session.tr());
    if (!task->all || !task->comparison) return in_lines(task->remarks, session.tr());
    const fc::Worked worked{session.document().model, task->problem, task->procedure, *task->all, *task->comparison};
    return fc::sheet_text(worked, [&](std::string_view text) { return session.tr()(text); });
}

std::optional<ui::Refusal> why_no_words(const Session& session)
{
    constexpr int bad_input = 2, mechanism = 3;
    if (session.hides_results()) return std::nullopt;
    const auto& task = session.solution().task;
    if (!task) return ui::Refusal{in_words(session), bad_input};
    if (!task->all || !task->comparison) return ui::Refusal{in_words(session), mechanism};
    return std::nullopt;
}

std::string status_text(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    if (!session.solution().task) return tr("this structure cannot be distributed");
    if (session.paper() != nullptr) return exercise_name(session) + "   ·   " + score_words(session);
    const fc::Sheet* const sheet = session.sheet();
    if (sheet == nullptr) return tr("All sheets together");
    const Numbers numbers(session.document(), session.solution(), session.look);
    const std::string unit = " " + numbers.moment_unit();
    const std::string largest = numbers.moment(fc::largest_unbalance(sheet->end)) + unit;
    return tr("step {n}   ·   largest unbalance {moment}   ·   tolerance {tolerance}",
              {{"n", std::to_string(sheet->steps.size())},
               {"moment", largest},
               {"tolerance", numbers.moment(sheet->tolerance) + unit}});
}

} // namespace cross
