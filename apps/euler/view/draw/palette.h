#pragma once

#include "apps/euler/view/look.h"
#include "apps/euler/view/marks.h"
#include "apps/euler/view/subject.h"

#include <optional>
#include <span>
#include <vector>

namespace euler {

/// How every entity of a picture looks: its own colour, and what its marks make of it.
///
/// A face has the colour of its outer loop, and a half-edge that of its loop. While a step is shown, what it left alone
/// is pale; while a pick is asked, what the operator does not take is grey.
class Palette {
public:
    Palette(std::span<const Subject> subjects, const Look& look);

    const ui::Theme& theme() const { return theme_; }
    const MarkTable& marks(std::size_t subject) const { return marks_[subject]; }
    const topology::Solid& solid(std::size_t subject) const { return *subjects_[subject].solid; }

    ui::Color face(std::size_t subject, topology::FaceId f) const;
    ui::Color hatching(std::size_t subject, topology::FaceId f) const;
    ui::Stroke edge(const Part& part, bool is_hidden, std::optional<std::size_t> series) const;
    ui::Stroke arrow(std::size_t subject, topology::HalfEdgeId h, bool is_hidden) const;
    ui::Color vertex(const Part& part, bool is_hidden) const;
    /// The broad pale line or disc below what may be picked, is selected or lies under the pointer.
    std::optional<ui::Color> halo(const Part& part) const;
    ui::TextStyle name(const Part& part, bool is_hidden) const;

private:
    /// The role of what a step or a preview did with it.
    std::optional<ui::Role> step_role(const Part& part) const;
    ui::Color pale(ui::Color color, double share) const { return ui::mixed(color, theme_.background(), share); }
    ui::Color gray() const { return theme_.stroke(ui::Role::HiddenEdge).color; }

    std::span<const Subject> subjects_;
    ui::Theme theme_;
    std::vector<MarkTable> marks_; ///< by subject
};

} // namespace euler
