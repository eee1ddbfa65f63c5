#include "ui/context/offered_app.h"

#include <utility>

namespace ui {

OfferedApp::OfferedApp(AppCalls calls) : calls_(std::move(calls)) {}
OfferedApp::~OfferedApp() = default;

} // namespace ui
