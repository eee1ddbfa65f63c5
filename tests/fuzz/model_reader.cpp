// Whatever the bytes, the reader returns or lists faults; and a sound model survives being written and read.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "femoop/io/model_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const femoop::ModelReading reading = femoop::examine_model(text);
    for (const femoop::Fault& fault : reading.faults)
        if (femoop::message(fault).empty()) std::abort();
    if (!reading.is_sound()) return 0;
    const std::string written = femoop::write_model(reading.model);
    if (femoop::read_model(written) == reading.model) return 0;
    std::cerr << "the model changed when it was written as\n" << written << '\n';
    std::abort();
}
