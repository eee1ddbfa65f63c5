#include "apps/frame/window/options.h"

namespace frame {

namespace {

ui::ProgramWords words(const std::string& version)
{
    return {
        .name = "frame",
        .version = version,
        .purpose = "Shows a frame, truss or grillage at work: loads, supports, N, V, M, deformed shape; "
                   "every number can be changed and the results follow.",
        .options = {.files = "model files (.json) to open, each in a tab; - opens what is redirected here, as a copy "
                             "without a file",
                    .describe = "print the model and its results in words and leave; needs no display"}};
}

} // namespace

Options parse_options(int argc, const char* const* argv, const std::string& version)
{
    Options options;
    std::string units, show, load_case;
    const auto to = [](std::string& text) { return [&text](const std::string& typed) { text = typed; }; };
    ui::CommandLine line = ui::app_command_line(words(version), options);
    line.options.push_back(
        {"--units", "NAME",
         "units shown: file, si, kn-m, kn-cm or us; default as it was left, at first those that go with the file",
         to(units)});
    line.options.push_back(
        {"--show", "LIST", "what the picture shows, such as loads,N,V,M,deformed,reactions,labels", to(show)});
    line.options.push_back({"--case", "ID", "load case or combination to show; default the first", to(load_case)});
    ui::read(line, argc, argv);
    if (options.is_headless() && options.files.size() > 1)
        throw ui::OptionsEnd::mistake("frame: found " + std::to_string(options.files.size()) +
                                      " files, wanted one: only a window has room for several");
    if (!units.empty())
        options.settings.units = ui::NamedOption<ui::UnitSystem>{"frame: --units", units, "file, si, kn-m, kn-cm, us",
                                                                 ui::unit_system_named(units)}();
    if (!load_case.empty()) options.load_case = load_case;
    try {
        if (!show.empty()) options.show = parse_show(show);
    } catch (const ShowError& error) {
        throw ui::OptionsEnd::mistake(std::string("frame: ") + error.what());
    }
    return options;
}

} // namespace frame
