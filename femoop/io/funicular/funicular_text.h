#pragma once

#include <string>
#include <vector>

#include "femoop/io/json/json_writer.h"
#include "femoop/methods/funicular/chain.h"
#include "femoop/methods/funicular/funicular.h"
#include "femoop/methods/funicular/refusal.h"
#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"

namespace femoop::funicular {

/// Why not, and what to do; lower case, without a period.
std::string sentence(const Refusal& refusal, const Model& model, const Translator& tr);

/// How H comes of the rise that is known of the hinge or of a point, the reactions of the simple beam, and of a
/// three-hinged arch whether this is its line of thrust: a line each.
std::vector<std::string> funicular_lines(const Funicular& funicular, const Chain& chain, const Model& model,
                                         const Translator& tr);

/// What is read at a place: the ordinate, M0 = H times it, and the moment of an arch whose line of thrust this is.
std::string reading_line(const Funicular& funicular, const Chain& chain, double x, const Model& model,
                         const Translator& tr);

/// Members of an object that is open, as courseware/reference/command-line.md lists them.
void write_funicular(JsonWriter& json, const Funicular& funicular, const Chain& chain, const Model& model);

/// The chain and its lines, then the ordinates at its nodes as a table, and the force polygon: its pole, the corners of
/// the funicular polygon with their loads, and the places of the load line that the rays go to.
std::string funicular_text(const Funicular& funicular, const Chain& chain, const Model& model, const Translator& tr);

/// The same as a part of a LaTeX document, a section*.
std::string funicular_latex(const Funicular& funicular, const Chain& chain, const Model& model, const Translator& tr);

} // namespace femoop::funicular
