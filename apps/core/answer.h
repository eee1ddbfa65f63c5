#pragma once

#include <functional>
#include <string>
#include <vector>

#include "femoop/io/json/json_writer.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace core {

/// What the module answers: texts of JSON.

/// {"faults": [{"severity": "error" or "warning", "message"}]}
std::string faults_alone(const std::vector<femoop::Fault>& faults);

/// What `answer` says; of a model that cannot be solved its faults.
std::string unless_refused(const std::function<std::string()>& answer);

/// As `cremona solve --json`.
std::string solved(const femoop::Model& model);

/// Until the next call.
const char* kept(std::string text);

} // namespace core
