#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/mohr/session/session.h"
#include "femoop/tabular/table.h"

namespace mohr {

/// The results in rows of group, name, value and unit, as programs read them: every digit and a decimal point.
tabular::Table result_list(const Session& session);

/// A LaTeX document of its own: the circle or the three circles as a TikZ picture, and the results as tables.
std::string latex(const Session& session);

/// The results as tables with headings, for a page of notes.
std::string markdown(const Session& session);

/// Writes the results to a .csv, .json, .md or .tex. \returns why it cannot, or nothing; absent altogether for another
/// ending
struct Exported {
    std::optional<ui::Message> reason{};
};
std::optional<Exported> export_results(const Session& session, const std::filesystem::path& path);

} // namespace mohr
