#include "apps/cross/report/tables.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "apps/cross/view/numbers.h"
#include "apps/cross/view/sheet_parts.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/io/cross/half_text.h"
#include "ui/text/language_manner.h"

namespace cross {

namespace fc = femoop::cross;

namespace {

/// Builds the tables of one scene.
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

    tabular::Table sheet() const
    {
        tabular::Table table(ends_head(tr_("Row")));
        add_symmetry(table);
        std::vector<tabular::Cell> factors{tr_("factors")};
        const std::vector<double> all = fc::factors_of(half_, scene_.document.method.digits);
        for (std::size_t e = 0; e < all.size(); ++e) {
            const auto joint = half_.is_on_sheet(fc::EndId(e)) ? half_.ends[e].joint : std::nullopt;
            factors.push_back(tabular::written_cell(joint && half_.is_balanced(*joint) ? numbers_.factor(all[e]) : ""));
        }
        table.add_row(std::move(factors));
        if (sheet_ == nullptr) {
            add_parts(table);
            table.add_row(row(tr_("together"), task_.all->moments));
            table.n_sums = 1;
            return table;
        }
        for (const fc::Row& written : fc::rows_of(half_, *sheet_))
            table.add_row(row(name_of(written), written.values, written.kind));
        table.n_sums = 1;
        add_drift(table);
        return table;
    }

    /// The loads, and so many times each sway.
    void add_parts(tabular::Table& table) const
    {
        for (const SheetPart& part : parts_of(scene_)) table.add_row(row(words_of(part, scene_), part.moments));
    }

    tabular::Table comparison() const
    {
        if (!task_.comparison) return missing();
        const fc::Comparison& c = *task_.comparison;
        tabular::Table table(
            head({tr_("member end"), tr_("distributed"), tr_("exact"), tr_("inextensible"), tr_("stiffness")}));
        table.notes = {tr_("Worked to the tolerance; the stiffness method takes axial strain into account.")};
        for (std::size_t e = 0; e < problem_.ends.size(); ++e) {
            const fc::End& end = problem_.ends[e];
            table.add_row({end.label, cell(end, c.distributed[e]), cell(end, c.limit[e]), cell(end, c.inextensible[e]),
                           cell(end, c.stiffness[e])});
        }
        for (std::size_t j = 0; j < problem_.joints.size(); ++j)
            table.notes.push_back(tr_("Joint {joint}: difference {moment}",
                                      {{"joint", name_of(fc::JointId(j))}, {"moment", amount(c.difference[j])}}));
        return table;
    }

    tabular::Table sways() const
    {
        if (problem_.sways.empty() && !problem_.halves.empty())
            return said(tr_("By symmetry the loads do not make it sway: it has one sheet."));
        if (problem_.sways.empty()) return said(tr_("Without a prop nothing moves: the structure cannot sway."));
        if (!task_.all) return missing();
        const fc::Superposition& all = *task_.all;
        std::vector<std::string> names{tr_("Prop"), "R_j0"};
        for (std::size_t k = 0; k < problem_.sways.size(); ++k) names.push_back("R_j" + std::to_string(k + 1));
        names.emplace_back("x");
        tabular::Table table(head(names));
        table.notes = {tr_("No prop may hold anything: R_jk is the force at prop j in the sheet of sway k, R_j0 in the "
                           "sheet of the loads.")};
        for (std::size_t j = 0; j < problem_.sways.size(); ++j) table.add_row(sway_row(all, j));
        for (std::size_t j = 0; j < problem_.sways.size(); ++j)
            table.notes.push_back(tr_("prop {node}", {{"node", model_[problem_.sways[j].prop].id}}) + ": " +
                                  equation(all, j));
        for (std::size_t j = 0; j < problem_.sways.size(); ++j)
            if (all.x[static_cast<Eigen::Index>(j)] == 0.0)
                table.notes.push_back(
                    tr_("The loads cause no sway at {node}.", {{"node", model_[problem_.sways[j].prop].id}}));
        return table;
    }

    tabular::Table convergence() const
    {
        if (sheet_ == nullptr) return missing();
        const std::vector<double> history = fc::convergence(*sheet_);
        tabular::Table table(head({tr_("Step"), tr_("Joint"), tr_("largest unbalance")}));
        for (std::size_t i = 0; i < history.size(); ++i) {
            const auto joint = i == 0 ? std::nullopt : sheet_->steps[i - 1].joint;
            const std::string name = i == 0 ? "" : joint ? name_of(*joint) : tr_("all");
            table.add_row({std::to_string(i), name, tabular::written_cell(numbers_.moment(history[i]))});
        }
        if (const auto rate = fc::rate(half_, *sheet_))
            table.notes.push_back(tr_("In one round of all joints the unbalance shrinks to {rate} of what it was.",
                                      {{"rate", numbers_.factor(*rate)}}));
        table.notes.push_back(tr_("Tolerance: {moment}", {{"moment", amount(sheet_->tolerance)}}));
        return table;
    }

    tabular::Table kani() const
    {
        if (!task_.kani) return missing();
        const fc::Kani& k = *task_.kani;
        tabular::Table table(ends_head(tr_("Cycle")));
        table.notes = {
            tr_("Rotation contributions M', cycle by cycle; M = FEM + 2 M' + M' of the far end + sway part.")};
        std::vector<tabular::Cell> factors{"μ"};
        for (const double factor : k.rotation_factor) factors.push_back(tabular::written_cell(signed_factor(factor)));
        table.add_row(std::move(factors));
        table.add_row(row(tr_("FEM"), problem_.loading.fixed_end));
        for (std::size_t i = 0; i < std::min<std::size_t>(k.cycles.size(), most_cycles); ++i)
            table.add_row(row(std::to_string(i + 1), k.cycles[i].rotation_contribution));
        if (!problem_.sways.empty() && !k.cycles.empty())
            table.add_row(row("M″", without_dust(k.cycles.back().sway_contribution)));
        table.add_row(row("M", k.moments));
        table.n_sums = 1;
        return table;
    }

    tabular::Table equations() const
    {
        if (!task_.equations) return missing();
        const fc::SlopeDeflection& s = *task_.equations;
        std::vector<std::string> names{""};
        for (Eigen::Index j = 0; j < s.x.size(); ++j) names.push_back(unknown(j));
        names.insert(names.end(), {"b", "x"});
        tabular::Table table(head(names));
        table.notes = {tr_("Moments at every joint and the work of every sway, A x = b, in the file's base units.")};
        for (Eigen::Index i = 0; i < s.x.size(); ++i) {
            std::vector<tabular::Cell> line{unknown(i)};
            for (Eigen::Index j = 0; j < s.x.size(); ++j) line.push_back(tabular::written_cell(plain(s.A(i, j))));
            line.push_back(tabular::written_cell(plain(s.b[i])));
            line.push_back(tabular::written_cell(plain(is_dust(s, i) ? 0.0 : s.x[i])));
            table.add_row(std::move(line));
        }
        return table;
    }

private:
    static constexpr std::size_t most_cycles = 40; // shown

    /// Why half is enough where it is worked; that it would be, where the whole is; why it is not, where it is asked
    /// for.
    void add_symmetry(tabular::Table& table) const
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
    void add_drift(tabular::Table& table) const
    {
        if (scene_.document.method.digits == 0 || sheet_->steps.empty()) return;
        const std::vector<double> off = fc::drift(half_, task_.loading(scene_.document.stage), *sheet_);
        std::vector<double> exact = sheet_->end.moments;
        for (std::size_t e = 0; e < exact.size(); ++e) exact[e] -= off[e];
        const Numbers unrounded = numbers_.unrounded();
        table.add_row(row(tr_("exact"), exact, unrounded));
        table.add_row(row(tr_("drift"), off, unrounded));
        table.n_sums += 2;
    }

    std::vector<tabular::Cell> row(const std::string& name, const std::vector<double>& values,
                                   const Numbers& numbers) const
    {
        std::vector<tabular::Cell> line{name};
        for (std::size_t e = 0; e < values.size(); ++e)
            line.push_back(tabular::written_cell(numbers.moment(problem_.ends[e], values[e])));
        return line;
    }

    static tabular::Table said(std::string sentence)
    {
        tabular::Table table;
        table.notes = {std::move(sentence)};
        return table;
    }

    tabular::Table missing() const
    {
        tabular::Table table = said(tr_("There is nothing to show here yet."));
        for (const femoop::Fault& fault : task_.remarks) table.notes.push_back(fault_text(fault, tr_));
        return table;
    }

    /// Names to the left, numbers to the right.
    static std::vector<tabular::Column> head(const std::vector<std::string>& names)
    {
        using enum tabular::Alignment;
        std::vector<tabular::Column> columns;
        for (const std::string& name : names) columns.push_back({name, "", columns.empty() ? Left : Right});
        return columns;
    }

    std::vector<tabular::Column> ends_head(const std::string& first) const
    {
        std::vector<std::string> names{first};
        for (const fc::End& end : problem_.ends) names.push_back(end.label);
        return head(names);
    }

    tabular::Cell cell(const fc::End& end, double moment) const
    {
        return tabular::written_cell(numbers_.moment(end, moment));
    }

    /// Zeros of balances and carry-overs are left blank, as on paper; beyond the axis, all but the sums.
    std::vector<tabular::Cell> row(const std::string& name, const std::vector<double>& values,
                                   fc::RowKind kind = fc::RowKind::FixedEnd) const
    {
        const bool is_sparse = kind == fc::RowKind::Balance || kind == fc::RowKind::CarryOver;
        std::vector<tabular::Cell> line{name};
        for (std::size_t e = 0; e < values.size(); ++e) {
            const bool is_blank = (is_sparse && values[e] == 0.0) ||
                                  (kind != fc::RowKind::Total && !half_.is_on_sheet(fc::EndId(e)));
            line.push_back(is_blank ? tabular::Cell() : cell(problem_.ends[e], values[e]));
        }
        return line;
    }

    std::string name_of(fc::JointId joint) const { return model_[problem_[joint].node].id; }

    std::string name_of(const fc::Row& written) const
    {
        switch (written.kind) {
        case fc::RowKind::FixedEnd: return tr_("FEM");
        case fc::RowKind::Balance: return written.joint ? tr_("BAL") + " " + name_of(*written.joint) : tr_("BAL");
        case fc::RowKind::CarryOver: return tr_("CO");
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

    std::vector<tabular::Cell> sway_row(const fc::Superposition& all, std::size_t j) const
    {
        const auto i = static_cast<Eigen::Index>(j);
        std::vector<tabular::Cell> line{model_[problem_.sways[j].prop].id,
                                        tabular::written_cell(force(0.0 - all.r[i]))};
        for (Eigen::Index k = 0; k < all.x.size(); ++k) line.push_back(tabular::written_cell(force(all.R(i, k))));
        line.push_back(tabular::written_cell(plain(all.x[i])));
        return line;
    }

    /// "−19.3 + 62.1 x1 = 0".
    std::string equation(const fc::Superposition& all, std::size_t j) const
    {
        const auto i = static_cast<Eigen::Index>(j);
        std::string text = plain(0.0 - all.r[i]);
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

} // namespace

tabular::Table table_of(const Scene& scene, Topic topic)
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

} // namespace cross
