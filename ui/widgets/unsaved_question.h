#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ui/text/catalogue.h"

namespace ui {

enum class UnsavedAnswer : std::uint8_t { Save, GiveUp, Cancel };

/// Asks what to do with changes of a file that are not saved; call it in every frame until it is answered.
std::optional<UnsavedAnswer> ask_about_unsaved(const std::string& file_name, const Catalogue& tr);

} // namespace ui
