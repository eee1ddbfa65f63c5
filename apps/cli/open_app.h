#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cli {

/// An app that is opened instead of a command.
struct AskedApp {
    std::string program; ///< "frame"
    std::vector<std::string> arguments;
};

/// `cremona frame ...` and `cremona plane ...`; `cremona cross`, `mohr` and `euler` by themselves, since with more words they
/// are commands; and `cremona FILE...`, where there is a file of that name, in the app of what the first of them holds.
std::optional<AskedApp> asked_app(const std::vector<std::string>& arguments);

/// The app of what a file holds: by its ending `.eul` or `.mohr`, else a plane model, a sheet of moment distribution, or a
/// structure of members.
std::string app_of_file(const std::string& path);

} // namespace cli
