#pragma once

#include <string>
#include <vector>

#include "femoop/io/json/json_writer.h"
#include "femoop/methods/counting/counting.h"
#include "femoop/model/fault/translator.h"

namespace femoop::counting {

/// What the degree of indeterminacy is made of, in lines for the foot of a picture: the sum, its external and its
/// internal part, and where there is more to say a sentence each: motions, a foundation, nodes without members.
///
///     Degree of indeterminacy: 2 rings × 3 − 1 release + 6 reactions − 1 part × 3 = 8
std::vector<std::string> sum_lines(const Counting& counting, const Model& model, const Translator& tr);

/// Each ring, joint with releases and support with what it counts: "ring 1 of AB, BC, CD, DA: +3".
std::vector<std::string> item_lines(const Counting& counting, const Model& model, const Translator& tr);

/// Both.
std::string counting_text(const Counting& counting, const Model& model, const Translator& tr);

/// The same for a program: an object.
void write_counting(JsonWriter& json, const Counting& counting, const Model& model);

} // namespace femoop::counting
