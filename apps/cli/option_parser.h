#pragma once

/// What declares the options of a command; who declares some includes <CLI/CLI.hpp>, which takes long to read.
namespace CLI { // NOLINT(readability-identifier-naming): the name that its authors gave it
class App;
}
