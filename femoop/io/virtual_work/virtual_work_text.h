#pragma once

#include <string>

#include "femoop/methods/virtual_work/virtual_work.h"
#include "femoop/model/fault/translator.h"

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

/// The same for a program, with every digit.
std::string virtual_work_json(const VirtualWork& work, const Model& model);

} // namespace femoop::virtual_work
