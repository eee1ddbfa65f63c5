#pragma once

#include <cstddef>
#include <string>

#include "femoop/methods/virtual_work/virtual_work.h"
#include "femoop/model/fault/translator.h"
#include "femoop/tabular/table.h"

namespace femoop::virtual_work {

/// What stands above the forces of a work, "under the loads, F", and above those that do it, "under the unit load, f";
/// and the unit of the work.
struct WorkCaptions {
    std::string real, unit;
    std::string unit_of_work{}; ///< none where it has no single one
};
/// The tables of a work: integrals stretch by stretch with their formulas, then joints and supports.
std::string work_text(const Work& work, const WorkCaptions& captions, const Model& model, const Translator& tr);

/// The integrals stretch by stretch with their formulas, then joints and supports, and their sum.
std::string virtual_work_text(const VirtualWork& work, const Model& model, const Translator& tr);

/// The same as a part of a LaTeX document, a section*: an integral for each stretch of a member.
std::string virtual_work_latex(const VirtualWork& work, const Model& model, const Translator& tr);

/// How a member of varying depth is integrated; empty where there is none.
std::string taper_sentence(const Work& work, const Translator& tr);

/// The number, or 0 where it is round-off beside the largest part of the work.
double without_round_off(double value, const Work& work);

/// Why a node has no rotation that a unit couple could work on: its members turn there each by themselves.
std::string free_rotation_text(const Model& model, NodeId node, const Translator& tr);

/// All of it in one table with its sum, for a sheet beside the diagrams: a row for each stretch of a member, joint and
/// support, in the model's units. Where there are more than `most_rows`, those that are least are one row together.
/// \pre most_rows > 0
tabular::Table work_table(const VirtualWork& work, const Model& model, const Translator& tr, std::size_t most_rows);
/// Its columns that can stand below the others where there is little room: the product of the two forces, its integral
/// and the stiffness.
inline constexpr std::size_t foldable_columns[] = {5, 6, 7};
/// And those that may be shortened: the two forces.
inline constexpr std::size_t formula_columns[] = {3, 4};

/// The same for a program, with every digit.
std::string virtual_work_json(const VirtualWork& work, const Model& model);

} // namespace femoop::virtual_work
