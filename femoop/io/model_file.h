#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace femoop {

struct JsonReading;

/// The model file, format 1: one UTF-8 JSON object. The contract is courseware/reference/model-file.md, and
/// courseware/reference/model.schema.json says the same to editors.
///
/// Errors    ModelError with every error of the file, each with its place (`members[2] "BC": no node "D"`): what the
///           reader cannot understand and what `check` finds wrong with the structure, in one list
/// Accuracy  writing a model and reading it back gives the same model bit for bit
Model read_model(std::string_view text);
Model read_model(std::istream& input);
Model read_model_file(const std::filesystem::path& path);

/// A file read for a person who wants to hear everything: the model as far as it could be understood, and all errors
/// and warnings. The model is sound if none of the faults is an error.
struct ModelReading {
    Model model;
    std::vector<Fault> faults;

    bool is_sound() const;
};
ModelReading examine_model(std::string_view text);
ModelReading examine_model(JsonReading json); ///< of a text that was parsed
ModelReading examine_model_file(const std::filesystem::path& path);

/// The model as a file's text: one node, member and load a line, keys in a fixed order, quantities as they were typed.
std::string write_model(const Model& model);

/// \throws ModelError if the file cannot be written; an existing file is replaced whole or not at all.
void write_model_file(const Model& model, const std::filesystem::path& path);

} // namespace femoop
