#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop {
class JsonValue;
}

namespace femoop::plane {

/// The file of a plane model, format 1: a JSON object whose `analysis` is plane_stress, plane_strain or axisymmetric.
/// The contract is courseware/reference/plane-model-file.md.
///
/// Accuracy  writing a model and reading it back gives the same model bit for bit

/// A file read for a person who wants to hear everything: the model as far as it could be understood, and all errors
/// and warnings. The model is sound if none of the faults is an error.
struct PlaneReading {
    PlaneModel model;
    std::vector<Fault> faults;
    bool is_sound() const;
};

/// Does the file's `analysis` name a plane model, or, where it names none of any kind, do its lists?
bool is_plane_model(JsonValue file);

PlaneReading examine_plane_model(JsonValue file, std::vector<Fault> faults = {});
PlaneReading examine_plane_model(std::string_view text); ///< \pre the text is that of a plane model, or no model
PlaneModel read_plane_model(std::string_view text);      ///< \throws ModelError with every error

/// The model as a file's text: one point, element and load a line, keys in a fixed order, quantities as they were typed.
/// A curve that a mesh has in several runs becomes as many curves, its fields along it those of its parts.
std::string write_plane_model(const PlaneModel& model);

} // namespace femoop::plane
