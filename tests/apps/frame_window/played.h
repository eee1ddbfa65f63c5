#pragma once

#include "apps/frame/session/session.h"

#include <string>

/// The frame app with a file of the repository open, as a person begins.
frame::Session opened(const std::string& file);

/// Plays the script in a window of 1280 x 800 and compares what the window shows at its end.
void check_window(const std::string& name, frame::Session session, const std::string& script);
