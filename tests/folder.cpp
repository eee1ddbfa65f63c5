#include "tests/folder.h"

#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>

namespace fs = std::filesystem;

Folder::Folder()
{
    std::random_device random;
    do path_ = fs::temp_directory_path() / ("cremona-" + std::to_string(random()));
    while (!fs::create_directory(path_));
}

Folder::~Folder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& text) const
{
    std::ofstream file(path_ / name, std::ios::binary);
    file << text;
    if (!file) throw std::runtime_error("cannot write " + path(name));
    return path(name);
}

std::string Folder::read(const std::string& name) const
{
    std::ifstream file(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

long Folder::n_entries() const { return std::distance(fs::directory_iterator(path_), fs::directory_iterator()); }
