#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/frame/session/commands.h"

namespace frame {

/// A table of results in a panel at the side: it is as high as its rows need, up to a dozen; where it is too wide it is
/// scrolled, never cut. `row(i)` fills the cells of the rows that are in sight.
void result_list(const char* id, const std::vector<std::string>& headings, std::size_t n_rows,
                 const std::function<void(std::size_t)>& row);

/// The first cell of a row: names a part, and selects it when it is clicked.
void part_cell(Session& session, const Part& part, const std::string& name);
void number_cell(const std::string& text); ///< at the right
/// Of the results: it can be asked where it comes from. \param part  of its row, if that has one
void number_cell(Workspace& workspace, const std::string& text, const PointedNumber& number,
                 const std::optional<Part>& part = {});
void name_cell(const std::string& text); ///< at the left

/// A heading that folds what stands under it. \returns whether it is unfolded
bool result_section(const std::string& title, const char* id);

} // namespace frame
