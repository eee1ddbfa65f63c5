#pragma once

#include <string>
#include <vector>

#include "tests/folder.h"

namespace cli_test {

/// What a run of the real program left behind.
struct Run {
    int status = -1; ///< exit status; -1 if a signal ended it
    std::string out; ///< stdout
    std::string err; ///< stderr
};

/// Runs `cremona` with these arguments and this standard input, in the top folder of the sources.
Run cremona(const std::vector<std::string>& arguments, const std::string& input = "");

/// The same for a line as a person types it, through the shell: `cremona solve examples/portal.json | head -1`.
Run shell(const std::string& line);

/// A cantilever AB, 4 m long, E I = 20000 kN m2, with 12 kN down at its tip in case P and combination U = 1.5 P.
std::string cantilever();
namespace of_cantilever {
inline constexpr double L = 4.0, EI = 2.0e4, P = 12.0;
}
/// The same without a support: it floats in three ways.
std::string floating();

/// How many times `part` stands in `text`.
std::size_t count(const std::string& text, const std::string& part);
inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace cli_test
