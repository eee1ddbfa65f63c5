#include "tests/golden/text_alone.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace golden {

std::map<std::string, std::string> text_alone(const std::filesystem::path& list)
{
    std::ifstream file(list);
    if (!file) throw std::runtime_error(list.string() + " is not there");
    std::map<std::string, std::string> kinds;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        std::istringstream words(line);
        std::string name, kind;
        if (!(words >> name >> kind)) throw std::runtime_error(list.string() + ": " + line);
        kinds.emplace(name, kind);
    }
    return kinds;
}

} // namespace golden
