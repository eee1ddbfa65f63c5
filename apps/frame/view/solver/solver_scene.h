#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "apps/frame/view/solver/solver_picture.h"

namespace frame {

/// What became of a block by the step that is drawn.
enum class BlockState : std::uint8_t {
    Held,       ///< has no unknowns
    Untouched,  ///< no front has met it
    Waiting,    ///< some front left it, and this one has it not
    Left,       ///< is left in this front
    Eliminated, ///< by this front
    Done        ///< before
};

/// One step of a walk and the means to draw it. Lives while one sheet is drawn.
class SolverScene {
public:
    /// \pre the trace has its details, and unknowns
    SolverScene(ui::Painter& painter, const femoop::SolverTrace& trace, const SolverLook& look);

    ui::Painter& painter() const { return painter_; }
    const femoop::SolverTrace& trace() const { return trace_; }
    const femoop::EliminationWalk& walk() const { return walk_; }
    const SolverLook& look() const { return look_; }
    const ui::Theme& theme() const { return look_.theme; }
    const ui::Catalogue& tr() const { return look_.tr; }
    std::size_t step() const { return step_; }
    const femoop::EliminationWalk::Front& front() const { return walk_.fronts[step_]; }
    BlockState state(std::int32_t block) const { return states_[static_cast<std::size_t>(block)]; }
    std::int32_t block_at(std::int32_t place) const { return walk_.order[static_cast<std::size_t>(place)]; }
    std::string name_of(std::int32_t block) const; ///< cut short where it is long
    std::string name_at(std::int32_t place) const { return name_of(block_at(place)); }
    std::string names(std::int32_t first, std::int32_t end) const; ///< of places; of many only the first
    std::string names(std::span<const femoop::EliminationWalk::Entry> entries) const;

    double px(double logical) const { return logical * theme().symbol_scale(); } ///< in the theme's symbol size
    ui::TextStyle small(ui::Role role, ui::Anchor anchor) const;
    /// The style, smaller where the words would be broader than the width.
    ui::TextStyle fitted(const std::string& words, ui::TextStyle style, double width) const;
    /// A disc for what is eliminated now, a square for what is left, a ring for what was, a dot for what was not met, a
    /// small square for what waits elsewhere, a cross for what is held.
    void draw_mark(BlockState state, ui::Point at, double radius) const;
    /// The looks of what is eliminated, left and filled in.
    const ui::RoleStyle& eliminated() const { return theme()[ui::Role::Selection]; }
    const ui::RoleStyle& left() const { return theme()[ui::Role::Changed]; }
    const ui::RoleStyle& filled() const { return theme()[ui::Role::Created]; }

    /// Of fill-in beside entries of K, which in print are black too.
    ui::Color fill_color() const { return on_paper(filled().stroke.color, 0.55); }
    /// A colour as it is, and in print so much nearer to that of the paper.
    ui::Color on_paper(ui::Color color, double share) const
    {
        return theme().name() == ui::ThemeName::Print ? mixed(color, theme().background(), share) : color;
    }

    /// A picture's title and a note below it; returns the room that is left.
    ui::Box draw_title(const ui::Box& box, const std::string& title, const std::string& note) const;

private:
    std::string joined(const std::vector<std::string>& names) const;

    ui::Painter& painter_;
    const femoop::SolverTrace& trace_;
    const SolverLook& look_;
    const femoop::EliminationWalk& walk_;
    std::size_t step_;
    std::vector<BlockState> states_;
};

/// Each fills its box.
void draw_walk_on_structure(const SolverScene& scene, const ui::Box& box);
void draw_elimination_tree(const SolverScene& scene, const ui::Box& box);
void draw_front_matrix(const SolverScene& scene, const ui::Box& box);
void draw_factors(const SolverScene& scene, const ui::Box& box);

} // namespace frame
