#include "apps/frame/view/derivation/stiffness_map.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "femoop/io/derivation/derivation_text.h"
#include "femoop/load/case_terms.h"
#include "femoop/methods/derivation/renumbering.h"
#include "ui/paint/wrapped_lines.h"

namespace frame {

using Eigen::Index;
using femoop::derivation::Step;
using femoop::derivation::StepKind;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

constexpr double decades = 6.0; // from the largest number to the palest cell
constexpr double least_share = 0.18;

/// What stands above K and f; where ties leave fewer equations these are others.
struct SystemSymbols {
    std::string K = "K", f = "f";
};
SystemSymbols symbols_of(bool is_reduced)
{
    if (!is_reduced) return {};
    return {femoop::derivation::with_raised_powers("G^T K G"),
            femoop::derivation::with_raised_powers("G^T (f − K u0)")};
}

class StiffnessMap {
public:
    StiffnessMap(ui::Painter& painter, const femoop::SystemTrace& system, const Step& step, const femoop::Model& model,
                 const DerivationLook& look, const ui::Box& box, SystemSymbols symbols)
        : painter_(painter), system_(system), step_(step), model_(model), look_(look), symbols_(std::move(symbols))
    {
        small_ = look.theme.type().small;
        for (const femoop::SystemTrace::Unknown& unknown : system.unknowns)
            names_.push_back(std::to_string(names_.size() + 1) + "  " + femoop::unknown_name(model, unknown));
        double names = 0.0;
        for (const std::string& text : names_) names = std::max(names, painter.measure(text, faint()).width + 6.0);
        widest_ = painter.measure(std::to_string(names_.size()), faint()).width;
        const double head = 2.6 * small_, columns = n() + (step.load_case ? 1.6 : 0.0);
        const auto side = [&](double margin) {
            return std::min((box.width() - margin) / columns, (box.height() - head) / n());
        };
        has_names_ = names < 0.45 * box.width() && side(names) > 0.95 * small_;
        const double margin = has_names_ ? names : 0.0;
        cell_ = std::min(side(margin), 3.6 * small_);
        corner_ = {box.min.x + margin, box.min.y + head};
        right_ = box.max.x;
    }

    double bottom() const { return corner_.y + n() * cell_; }

    void draw() const
    {
        {
            const ui::LayerScope layer(painter_, ui::Layer::Areas);
            const double largest = scale(system_.K.coeffs().abs().maxCoeff());
            for (Index column = 0; column < system_.K.outerSize(); ++column)
                for (femoop::SparseMatrix::InnerIterator entry(system_.K, column); entry; ++entry)
                    draw_cell(at(entry.row(), column), entry.value(), largest);
            if (step_.load_case) draw_loads(loads_of(*step_.load_case));
        }
        draw_frame();
        draw_names();
        for (const Index row : step_.rows) draw_mark(row);
    }

private:
    double n() const { return static_cast<double>(system_.unknowns.size()); }
    static double scale(double largest) { return largest > 0.0 ? largest : 1.0; }
    bool is_of_member() const { return step_.kind == StepKind::Stiffness; }
    bool is_of_loads() const
    {
        return step_.kind == StepKind::FixedEndForces || step_.kind == StepKind::LoadRow ||
               step_.kind == StepKind::RightHandSide;
    }

    ui::TextStyle faint(Anchor anchor = Anchor::Right) const
    {
        ui::TextStyle style = look_.theme.text(Role::FaintLabel, anchor);
        style.size = small_;
        return style;
    }

    ui::Box at(Index row, Index column) const
    {
        const Point min = corner_ + cell_ * Point{static_cast<double>(column), static_cast<double>(row)};
        return {min, min + Point{cell_, cell_}};
    }
    ui::Box load_at(Index row) const
    {
        const ui::Box cell = at(row, 0);
        const Point shift{cell_ * (n() + 0.6), 0.0};
        return {cell.min + shift, cell.max + shift};
    }

    void draw_cell(const ui::Box& cell, double value, double largest) const
    {
        if (value == 0.0) return;
        const double share = std::clamp(1.0 + std::log10(std::abs(value) / largest) / decades, least_share, 1.0);
        const ui::Color ink = look_.theme.series(value > 0.0 ? 0 : 1).stroke.color;
        painter_.rectangle(cell.grown(cell_ > 5.0 ? -0.5 : 0.0), ui::mixed(look_.theme.background(), ink, share));
        if (value > 0.0 || cell_ < 6.0) return;
        const Point middle = cell.center(), arm{0.25 * cell_, 0.0};
        painter_.line(middle - arm, middle + arm,
                      {.color = share > 0.5 ? look_.theme.background() : ink, .width = std::max(1.0, 0.1 * cell_)});
    }

    Eigen::VectorXd loads_of(femoop::CaseId load_case) const
    {
        Eigen::VectorXd f = Eigen::VectorXd::Zero(system_.f.rows());
        for (const femoop::CaseTerms::Term& term : femoop::terms_of(model_, load_case).terms)
            f += term.factor * system_.f.col(static_cast<Index>(term.load_case));
        return f;
    }

    void draw_loads(const Eigen::VectorXd& f) const
    {
        const double largest = scale(f.cwiseAbs().maxCoeff());
        for (Index row = 0; row < f.size(); ++row) draw_cell(load_at(row), f[row], largest);
    }

    void outline(const ui::Box& box, const ui::Stroke& stroke) const
    {
        painter_.polyline({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, stroke,
                          ui::PathEnds::Closed);
    }

    void draw_frame() const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Lines);
        const ui::Stroke stroke{.color = look_.theme.stroke(Role::FaintLabel).color, .width = 1.0};
        const Index last = static_cast<Index>(system_.unknowns.size()) - 1;
        outline({at(0, 0).min, at(last, last).max}, stroke);
        if (step_.load_case) outline({load_at(0).min, load_at(last).max}, stroke);
    }

    /// Where the symbols stand: over their columns, but beside one another and on the sheet.
    struct SymbolPlaces {
        double K, f;
    };
    SymbolPlaces symbol_places(const ui::TextStyle& head) const
    {
        const double middle = corner_.x + 0.5 * n() * cell_;
        if (!step_.load_case) return {middle, 0.0};
        const double half = 0.5 * painter_.measure(symbols_.f, head).width;
        const double apart = 0.5 * painter_.measure(symbols_.K, head).width + small_ + half;
        const double f = std::min(std::max(load_at(0).center().x, middle + apart), right_ - half);
        return {std::min(middle, f - apart), f};
    }

    void draw_names() const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Labels);
        ui::TextStyle head = faint(Anchor::Bottom);
        head.color = look_.theme[Role::Label].text;
        head.weight = ui::Weight::Bold;
        const double y = corner_.y - (has_names_ ? 1.4 : 0.3) * small_;
        const auto [K, f] = symbol_places(head);
        painter_.text({K, y}, symbols_.K, head);
        if (step_.load_case) painter_.text({f, y}, symbols_.f, head);
        if (!has_names_) return;
        for (Index i = 0; i < static_cast<Index>(names_.size()); ++i) {
            const bool is_lit = std::ranges::find(step_.rows, i) != step_.rows.end();
            ui::TextStyle style = faint();
            if (is_lit) style.color = look_.theme[Role::Selection].text;
            if (is_lit) style.weight = ui::Weight::Bold;
            painter_.text({corner_.x - 4.0, at(i, 0).center().y}, names_[static_cast<std::size_t>(i)], style);
            if ((i + 1) % column_stride() != 0) continue;
            style.anchor = Anchor::Bottom;
            painter_.text({at(0, i).center().x, corner_.y - 2.0}, std::to_string(i + 1), style);
        }
    }

    /// Every so many columns bear their number: as many as do not touch.
    Index column_stride() const
    {
        for (const Index stride : {1, 2, 5, 10, 20})
            if (static_cast<double>(stride) * cell_ > widest_ + 0.4 * small_) return stride;
        return 50;
    }

    void draw_mark(Index row) const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Symbols);
        const ui::Stroke stroke{.color = look_.theme.stroke(Role::Member).color, // unlike that of any cell
                                .width = std::clamp(0.1 * cell_, 1.0, 3.0)};
        if (is_of_member())
            for (const Index column : step_.rows) outline(at(row, column), stroke);
        else if (!is_of_loads()) outline({at(row, 0).min, at(row, static_cast<Index>(names_.size()) - 1).max}, stroke);
        const bool has_load = step_.load_case && (is_of_loads() || step_.kind == StepKind::Equations);
        if (has_load) outline(load_at(row), stroke);
    }

    ui::Painter& painter_;
    const femoop::SystemTrace& system_;
    const Step& step_;
    const femoop::Model& model_;
    const DerivationLook& look_;
    SystemSymbols symbols_;
    double small_ = 0.0, cell_ = 0.0;
    double widest_ = 0.0; ///< of the numbers above the columns
    Point corner_;
    double right_ = 0.0; ///< end of the box
    bool has_names_ = false;
    std::vector<std::string> names_; ///< "4  B.ux"
};

void write(ui::Painter& painter, const std::string& text, const ui::TextStyle& style, const ui::Box& box)
{
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    double y = box.min.y;
    for (const std::string& line : ui::wrapped_lines(painter.fonts(), text, style, box.width())) {
        painter.text({box.min.x, y}, line, style);
        y += 1.35 * style.size;
    }
}

/// Why K is not drawn; nothing where it is.
std::string why_no_map(std::size_t n, const ui::Catalogue& tr)
{
    if (n == 0) return tr("Every displacement is held: K has no rows.");
    if (n <= most_unknowns_mapped) return {};
    return tr("K has {count} rows; it is drawn with {most} or fewer.",
              {{"count", std::to_string(n)}, {"most", std::to_string(most_unknowns_mapped)}});
}

/// The rows of a step among the equations that ties leave.
std::vector<Index> solved_rows(const femoop::SystemTrace& system, const std::vector<Index>& rows)
{
    if (!system.ties) return rows;
    std::vector<Index> solved;
    for (std::size_t i = 0; i < system.ties->independent.size(); ++i)
        if (std::ranges::find(rows, system.ties->independent[i]) != rows.end()) solved.push_back(static_cast<Index>(i));
    return solved;
}

/// What is solved, its unknowns where `place` puts them; the step's rows are marked.
void draw_order(ui::Painter& painter, const femoop::SystemTrace& system, const std::vector<Index>& rows,
                const femoop::Model& model, const DerivationLook& look, const ui::Box& box, const std::string& title,
                bool is_reduced)
{
    ui::TextStyle style = look.theme.text(Role::Label, Anchor::TopLeft);
    const std::size_t end = title.find('\n');
    write(painter, title.substr(0, end), style, box);
    write(painter, title.substr(end + 1), style, {box.min + Point{0.0, 1.35 * style.size}, box.max});
    Step lit;
    lit.kind = StepKind::Stiffness;
    lit.rows = rows;
    StiffnessMap(painter, system, lit, model, look, {box.min + Point{0.0, 2.9 * style.size}, box.max},
                 symbols_of(is_reduced))
        .draw();
}

} // namespace

void draw_stiffness_map(ui::Painter& painter, const femoop::derivation::Derivation& derivation, const Step& step,
                        const femoop::Model& model, const DerivationLook& look, const ui::Box& box)
{
    const bool is_reduced = step.kind == StepKind::ReducedEquations;
    const femoop::SystemTrace reduced = is_reduced ? femoop::derivation::as_given(derivation.system)
                                                   : femoop::SystemTrace{};
    const femoop::SystemTrace& system = is_reduced ? reduced : derivation.system;
    const std::string reason = why_no_map(system.unknowns.size(), look.tr);
    if (!reason.empty()) return write(painter, reason, look.theme.text(Role::FaintLabel, Anchor::TopLeft), box);
    Step shown = step;
    if (is_reduced) {
        shown.kind = StepKind::Equations;
        shown.rows = solved_rows(derivation.system, step.rows);
    }
    StiffnessMap(painter, system, shown, model, look, box, symbols_of(is_reduced)).draw();
}

void draw_numbering(ui::Painter& painter, const femoop::derivation::Derivation& derivation, const Step& step,
                    const femoop::Model& model, const DerivationLook& look, const ui::Box& box)
{
    const femoop::derivation::Renumbering& order = *step.renumbering;
    const std::string reason = why_no_map(order.place.size(), look.tr);
    if (!reason.empty()) return write(painter, reason, look.theme.text(Role::FaintLabel, Anchor::TopLeft), box);
    const std::vector<Index> given = solved_rows(derivation.system, step.rows);
    std::vector<Index> eliminated;
    for (const Index row : given) eliminated.push_back(order.place[static_cast<std::size_t>(row)]);
    const bool is_reduced = derivation.system.ties.has_value();
    const double gap = look.theme.type().normal, half = 0.5 * (box.width() - gap);
    const auto title = [&](const std::string& what, const femoop::derivation::Reach& reach) {
        return what + "\n" + look.tr("half bandwidth {width}", {{"width", std::to_string(reach.half_bandwidth)}});
    };
    draw_order(painter, femoop::derivation::as_given(derivation.system), given, model, look,
               {box.min, {box.min.x + half, box.max.y}}, title(look.tr("numbered as given"), order.given), is_reduced);
    draw_order(painter, femoop::derivation::as_eliminated(derivation.system), eliminated, model, look,
               {{box.max.x - half, box.min.y}, box.max}, title(look.tr("in the solver's order"), order.solved),
               is_reduced);
}

} // namespace frame
