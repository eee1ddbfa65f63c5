#pragma once

#include "apps/frame/session/session.h"

#include <string>

/// The frame app with a file of the repository open, as a person begins.
frame::Session opened(const std::string& file);
