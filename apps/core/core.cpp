// What cremona.js calls: text in, text out.
#include <emscripten.h>

#include <string_view>

#include "apps/core/answer.h"
#include "femoop/io/model_file.h"

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* core_solve(const char* model)
{
    return core::kept(core::unless_refused([&] {
        const femoop::ModelReading reading = femoop::examine_model(std::string_view(model));
        return reading.is_sound() ? core::solved(reading.model) : core::faults_alone(reading.faults);
    }));
}

EMSCRIPTEN_KEEPALIVE const char* core_check(const char* model)
{
    return core::kept(core::faults_alone(femoop::examine_model(std::string_view(model)).faults));
}

} // extern "C"
