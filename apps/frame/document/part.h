#pragma once

#include <cstddef>
#include <vector>

#include "apps/drawing/part.h"
#include "apps/frame/document/drawing_names.h"
#include "femoop/model/model.h"
#include "ui/text/message.h"

namespace frame {

struct Document;

/// False where the document no longer has it, as after an undo.
bool has(const Document& document, const Part& part);
bool has(const femoop::Model& model, const Part& part); ///< of what is the model's own

/// "Node B", "Load on member BC". \pre has(document, part)
ui::Message title(const Document& document, const Part& part);
ui::Message title(const femoop::Model& model, const Part& part); ///< of what is the model's own

/// Every part of the model, in the order of the file.
std::vector<Part> parts(const femoop::Model& model);

/// The place of the load case that a load or settlement belongs to. \pre the part is one
std::size_t load_case_of(const Part& load);

/// The loads and settlements of all load cases that act on this node or member.
std::vector<Part> loads_on(const femoop::Model& model, const Part& part);

} // namespace frame
