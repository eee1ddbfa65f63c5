#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cross/document/pupil.h"
#include "apps/cross/document/turn_tree.h"
#include "femoop/methods/cross/distribution.h"
#include "femoop/model/model.h"

namespace cross {

/// How the sheets of a structure are worked. Saved in the file's `cross` block.
struct Method {
    femoop::CaseId load_case;
    femoop::cross::Order order = femoop::cross::Order::Largest;
    std::vector<std::string> joints; ///< Order::Listed: names, again and again
    std::optional<double> tolerance; ///< in the file's unit of moments; 0.001 of the largest fixed-end moment if absent
    int digits = 0;                  ///< every number is rounded to so many significant ones; 0: exact
    femoop::cross::FarEnds far_ends = femoop::cross::FarEnds::Modified;
    /// Half of it by symmetry, where structure and loads have any; an exercise is of the whole.
    femoop::cross::Extent extent = femoop::cross::Extent::Whole;

    friend bool operator==(const Method&, const Method&) = default;
};

/// What the app edits: a structure with its loads, how it is distributed, and how far the sheets are: all of
/// it is saved.
struct Document {
    femoop::Model model;
    Method method{};
    /// One for every sheet: the loads with all props in place, then each sway. As many as were begun.
    std::vector<TurnTree> plays{};
    /// The sheet that is worked on; past the last of them: all together.
    std::size_t stage = 0;
    /// A pupil fills the sheet: nothing of it is shown until it is right.
    std::optional<Pupil> pupil{};

    friend bool operator==(const Document&, const Document&) = default;
};

/// The same without what was worked: after the structure or the method changed, joints may be others.
Document unworked(Document document);

/// What a document's sheets are worked on. \throws femoop::ModelError
femoop::cross::Problem problem_of(const Document& document);

/// About how much memory it takes [bytes]: a history is bounded by it.
std::size_t memory_footprint(const Document& document);

bool is_same_task(const Document& a, const Document& b); ///< of equal model, method and exercise

} // namespace cross
