#pragma once

/// How many samples a test takes at random: `all`, but `few` under sanitizers, where each takes twenty times as long. What
/// these look for, such as a read out of bounds, shows in few; whether a claim holds in all is asked without them.
constexpr unsigned samples([[maybe_unused]] unsigned all, [[maybe_unused]] unsigned few)
{
#if defined(__SANITIZE_ADDRESS__)
    return few;
#else
    return all;
#endif
}
