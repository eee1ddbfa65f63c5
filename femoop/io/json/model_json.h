#pragma once

#include <Eigen/Core>

#include "femoop/io/json/json_writer.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

/// Begins what every output of a model begins with: {"cremona": 1, "units": {"length", "force"}; its object stays open.
void begin_output(JsonWriter& json, const Units& units);

/// A list of rows, each a list of numbers.
void write_rows(JsonWriter& json, const Eigen::MatrixXd& matrix, JsonWriter::Layout layout = JsonWriter::Layout::Line);

} // namespace femoop
