#pragma once

#include <filesystem>

#include "ui/files/draft.h"

inline ui::DraftFolder drafts_in(const std::filesystem::path& folder) { return {folder, ".txt"}; }
