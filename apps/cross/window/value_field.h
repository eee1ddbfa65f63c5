#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "apps/cross/session/typed_value.h"

namespace cross {

/// The field in which a value of the structure is typed, on the picture itself: Enter or a click elsewhere takes it,
/// Esc leaves it as it was. What cannot be taken stays, with the reason beneath.
class ValueField {
public:
    /// \param at  where the value is written, in the picture
    void open(const Session& session, const TypedValue& value, ui::Point at);
    bool is_open() const { return value_.has_value(); }
    /// \param corner  of the picture in the window, \param scale  physical pixels of a logical one
    void show(Session& session, ui::Point corner, float scale);

private:
    void edit(Session& session);
    void confirm(Session& session);

    std::optional<TypedValue> value_;
    ui::Point at_{};
    std::string text_, opening_, reason_;
    std::size_t n_solved_ = 0; ///< Session::n_solved of what it speaks of
    int n_openings_ = 0;
    bool is_fresh_ = false;
};

} // namespace cross
