#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/mohr/session/session.h"

namespace mohr {

/// The results as comma-separated values: group, name, value, unit; decimal points and every digit.
std::string csv(const Session& session);

/// A LaTeX document of its own: the circle or the three circles as a TikZ picture, and the results as tables.
std::string latex(const Session& session);

/// Writes the results to a .csv or a .tex. \returns why it cannot, or nothing; absent altogether for another ending
struct Exported {
    std::optional<ui::Phrase> reason{};
};
std::optional<Exported> export_results(const Session& session, const std::filesystem::path& path);

} // namespace mohr
