#include "tests/text_of.h"

#include <fstream>
#include <iterator>

#include "tests/source_folder.h"

std::string text_of(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string text_of_source(const std::string& path) { return text_of(std::filesystem::path(source_folder()) / path); }
