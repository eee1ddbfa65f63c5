#pragma once

#include <string>

#include "femoop/methods/virtual_work/virtual_work.h"
#include "femoop/model/fault/translator.h"

namespace femoop::virtual_work {

/// The integrals stretch by stretch with their formulas, then joints and supports, and their sum.
std::string virtual_work_text(const VirtualWork& work, const Model& model, const Translator& tr);

/// The same for a program, with every digit.
std::string virtual_work_json(const VirtualWork& work, const Model& model);

} // namespace femoop::virtual_work
