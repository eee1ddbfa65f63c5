#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/frame/session/commands.h"

namespace frame {

/// The cells of a row of results, from the left. They are gone through twice, first to be measured: the columns have
/// their widths from the first frame on.
class ResultRow {
public:
    /// Names a part, and selects it when it is clicked.
    void part(Session& session, const Part& part, const std::string& name);
    /// \returns whether the row is clicked
    bool choice(const std::string& name, bool is_chosen);
    void number(const std::string& text); ///< at the right
    /// Of the results: it can be asked where it comes from. \param part  of its row, if that has one
    void number(Workspace& workspace, const std::string& text, const PointedNumber& number,
                const std::optional<Part>& part = {});
    void name(const std::string& text); ///< at the left

private:
    friend class ResultColumns;
    explicit ResultRow(std::vector<float>* widths, bool is_stacked) : widths_(widths), is_stacked_(is_stacked) {}
    bool begin_cell(const std::string& text);                                 ///< whether it is drawn now
    bool first_cell(const std::string& text, const char* id, bool is_chosen); ///< whether it is clicked

    std::vector<float>* widths_; ///< of the columns, to be made broad enough; null: the cells are drawn
    bool is_stacked_;            ///< the first cell stands above the others
    std::size_t column_ = 0;
};

/// A table of results in a panel at the side: it is as high as its rows need, up to a dozen; where it is too wide each
/// first cell stands above the others of its row, and where that is too wide, too, it is scrolled, never cut.
/// `row(cells, i)` fills the cells of the rows that are in sight.
void result_list(const char* id, const std::vector<std::string>& headings, std::size_t n_rows,
                 const std::function<void(ResultRow&, std::size_t)>& row);

/// A heading that folds what stands under it. \returns whether it is unfolded
bool result_section(const std::string& title, const char* id);

} // namespace frame
