#pragma once

#include <functional>

#include "ui/workspace/export_to_app.h"

namespace ui {

/// Lets the page around an app have a copy of the document, which it asks for where a link that holds it is wanted
/// (ui/app/web/share.js). On a desktop nobody asks.
class OfferedCopy {
public:
    using Copy = std::function<ExportToApp()>;

    explicit OfferedCopy(Copy copy);
    ~OfferedCopy();
    OfferedCopy(const OfferedCopy&) = delete;
    OfferedCopy& operator=(const OfferedCopy&) = delete;

    const Copy& copy() const { return copy_; }

private:
    Copy copy_;
};

} // namespace ui
