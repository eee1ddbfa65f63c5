#pragma once

namespace femoop {

/// While it lives, OpenMP loops that its thread begins run in that thread alone. Does nothing where the program has no
/// OpenMP.
class SerialLoops {
public:
    SerialLoops();
    ~SerialLoops();
    SerialLoops(const SerialLoops&) = delete;
    SerialLoops& operator=(const SerialLoops&) = delete;

private:
    int levels_; ///< of nested parallel loops that were allowed before
};

/// While any lives, OpenBLAS works in whatever thread calls it: its number of threads is one setting for the process,
/// which comes back with the last of them. Does nothing with another BLAS.
class SerialBlas {
public:
    SerialBlas();
    ~SerialBlas();
    SerialBlas(const SerialBlas&) = delete;
    SerialBlas& operator=(const SerialBlas&) = delete;
};

} // namespace femoop
