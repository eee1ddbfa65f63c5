// Trusses in the plane and in space.
#include <stdexcept>
#include <vector>

#include "femoop/typical/sketch.h"
#include "femoop/typical/typical.h"

namespace femoop {

namespace {

/// The chords of a plane truss; the pattern puts the web between them.
class TrussSketch {
public:
    explicit TrussSketch(const PlaneTruss& truss, std::string title)
        : truss_(truss), sketch_(std::move(title), AnalysisKind::Truss2d)
    {
        for (int i = 0; i <= truss.panels; ++i) lower_.push_back(sketch_.node("L" + std::to_string(i), x(i), 0));
        for (int i = 1; i <= truss.panels; ++i) sketch_.member(lower(i - 1), lower(i));
        for (int i = 1; i < truss.panels; ++i) sketch_.load(lower(i), Dof::uy, -truss.load);
        sketch_.support(lower(0), SupportKind::Pin);
        sketch_.support(lower(truss.panels), SupportKind::Roller);
    }

    Model warren() &&
    {
        add_upper_chord(0.5, truss_.panels);
        for (int i = 0; i < truss_.panels; ++i) {
            sketch_.member(lower(i), upper(i));
            sketch_.member(upper(i), lower(i + 1));
        }
        return std::move(sketch_).model();
    }

    /// Verticals, end posts, and in each inner panel a diagonal that falls (Pratt) or rises (Howe) to the middle.
    Model with_verticals(TrussPattern pattern) &&
    {
        add_trapezoid();
        for (int i = 1; i < truss_.panels; ++i) sketch_.member(lower(i), above(i));
        for (int i = 1; i < middle(); ++i)
            for (const Step step : {Step{i, i + 1}, Step{truss_.panels - i, truss_.panels - i - 1}}) {
                if (pattern == TrussPattern::Pratt) sketch_.member(above(step.outer), lower(step.inner));
                else sketch_.member(lower(step.outer), above(step.inner));
            }
        return std::move(sketch_).model();
    }

    /// The vertical in the middle has no node at half height: nothing would hold it across.
    Model k_shaped() &&
    {
        add_trapezoid();
        sketch_.member(lower(middle()), above(middle()));
        for (int i = 1; i < middle(); ++i)
            for (const Step step : {Step{i, i + 1}, Step{truss_.panels - i, truss_.panels - i - 1}}) {
                const NodeId half = sketch_.node("M" + std::to_string(step.outer), x(step.outer), 0.5 * truss_.height);
                sketch_.member(lower(step.outer), half);
                sketch_.member(half, above(step.outer));
                sketch_.member(half, above(step.inner));
                sketch_.member(half, lower(step.inner));
            }
        return std::move(sketch_).model();
    }

private:
    struct Step {
        int outer = 0, inner = 0; ///< panel points, counted from the left
    };

    double x(double i) const { return truss_.span * i / truss_.panels; }
    int middle() const { return truss_.panels / 2; }
    NodeId lower(int i) const { return lower_[static_cast<std::size_t>(i)]; }
    NodeId upper(int i) const { return upper_[static_cast<std::size_t>(i)]; }
    NodeId above(int i) const { return upper(i - 1); } ///< of a trapezoid: over the lower node i, 1 to panels - 1

    /// `n` nodes from the place `first`, in panels, on.
    void add_upper_chord(double first, int n)
    {
        for (int i = 0; i < n; ++i) {
            upper_.push_back(sketch_.node("U" + std::to_string(i + 1), x(first + i), truss_.height));
            if (i > 0) sketch_.member(upper(i - 1), upper(i));
        }
    }

    void add_trapezoid()
    {
        add_upper_chord(1.0, truss_.panels - 1);
        sketch_.member(lower(0), above(1));
        sketch_.member(above(truss_.panels - 1), lower(truss_.panels));
    }

    PlaneTruss truss_;
    Sketch sketch_;
    std::vector<NodeId> lower_, upper_;
};

/// A rectangular net of nodes, row by row, with members along both directions.
class Layer {
public:
    Layer(Sketch& sketch, char letter, int n_x, int n_y, double panel, double shift, double z) : n_x_(n_x)
    {
        for (int j = 0; j < n_y; ++j)
            for (int i = 0; i < n_x; ++i) {
                const std::string name = letter + std::to_string(j * n_x + i + 1);
                nodes_.push_back(sketch.node(name, i * panel + shift, j * panel + shift, z));
                if (i > 0) sketch.member(at(i - 1, j), at(i, j));
                if (j > 0) sketch.member(at(i, j - 1), at(i, j));
            }
    }
    NodeId at(int i, int j) const { return nodes_[static_cast<std::size_t>(j * n_x_ + i)]; }

private:
    int n_x_;
    std::vector<NodeId> nodes_;
};

} // namespace

Model PlaneTruss::model() const
{
    const bool is_warren = pattern == TrussPattern::Warren;
    require_within("panels", panels, is_warren ? 2 : 4, 40);
    if (!is_warren && panels % 2 != 0)
        throw std::invalid_argument("panels: this truss is symmetric about a vertical; wanted an even number");
    require_positive("span", span);
    require_positive("height", height);
    switch (pattern) {
    case TrussPattern::Pratt: return TrussSketch(*this, "Pratt truss").with_verticals(pattern);
    case TrussPattern::Howe: return TrussSketch(*this, "Howe truss").with_verticals(pattern);
    case TrussPattern::K: return TrussSketch(*this, "K-truss").k_shaped();
    case TrussPattern::Warren: break;
    }
    return TrussSketch(*this, "Warren truss").warren();
}

Model SpaceTruss::model() const
{
    require_within("panels_x", panels_x, 1, 30);
    require_within("panels_y", panels_y, 1, 30);
    require_positive("panel", panel);
    require_positive("height", height);
    Sketch sketch("Space truss", AnalysisKind::Truss3d);
    const Layer bottom(sketch, 'B', panels_x + 1, panels_y + 1, panel, 0.0, 0.0);
    const Layer top(sketch, 'T', panels_x, panels_y, panel, 0.5 * panel, height);
    for (int j = 0; j < panels_y; ++j)
        for (int i = 0; i < panels_x; ++i) {
            for (const int dj : {0, 1})
                for (const int di : {0, 1}) sketch.member(bottom.at(i + di, j + dj), top.at(i, j));
            sketch.load(top.at(i, j), Dof::uz, -load);
        }
    for (int j = 0; j <= panels_y; ++j)
        for (int i = 0; i <= panels_x; ++i)
            if (i == 0 || j == 0 || i == panels_x || j == panels_y) sketch.support(bottom.at(i, j), SupportKind::Pin);
    return std::move(sketch).model();
}

} // namespace femoop
