#pragma once

#include "femoop/model/model.h"
#include "ui/text/catalogue.h"

namespace cross {

/// What a sheet cannot be filled without and a small picture may not have room for: lengths, where forces act, moments
/// on joints. "Lengths: AB 12 m, BC 5 m. AB: 27 kN at 8 m from A. B: moment 10 kN·m clockwise." Nothing of large
/// structures.
std::string given_text(const femoop::Model& model, femoop::CaseId load_case, const ui::Catalogue& tr);

} // namespace cross
