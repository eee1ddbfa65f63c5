#pragma once

#include <filesystem>

#include "femoop/files/whole_file.h"
#include "ui/files/draft.h"

inline ui::DraftFolder drafts_in(const std::filesystem::path& folder)
{
    return {folder, ".txt", files::write_whole_file};
}
