#pragma once

#include <string>
#include <vector>

namespace ui {

/// A document that another program of the suite goes on with, as a copy that has no file.
struct ExportToApp {
    std::string program;                ///< "cross"
    std::string document;               ///< the text of a file
    std::vector<std::string> options{}; ///< of its command line
};

} // namespace ui
