// Of MMX nothing is used: Eigen includes this beside SSE2, which emscripten has in terms of WebAssembly.
