// Gives every file of a folder to a fuzz target once, in builds without libFuzzer.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::vector<std::uint8_t> bytes(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
    return {text.begin(), text.end()};
}

} // namespace

int main(int argc, char** argv)
{
    int n_inputs = 0;
    for (int i = 1; i < argc; ++i) {
        for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
            std::printf("%s\n", entry.path().c_str());
            std::fflush(stdout); // the last name printed is the guilty one
            const std::vector<std::uint8_t> input = bytes(entry.path());
            LLVMFuzzerTestOneInput(input.data(), input.size());
            ++n_inputs;
        }
    }
    std::printf("%d inputs\n", n_inputs);
    return n_inputs > 0 ? 0 : 1;
}
