#pragma once

#include <filesystem>
#include <string>

#include "apps/cross/document/document.h"

namespace cross {

/// What the app begins with when no file is named: a continuous beam of three spans (examples/three_spans.json).
Document starting_document();

/// The model of a file with the method of its `cross` block. \throws femoop::ModelError
Document read_document(const std::string& text);
Document read_document_file(const std::filesystem::path& path);

/// The model as a file's text, with the method, what was worked and a pupil's exercise as its `cross` block. What such
/// a block says of the expected sheet stays while the method is what the block asks for.
std::string write_document(const Document& document);

} // namespace cross
