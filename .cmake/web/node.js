// A program that runs under node sees the environment of its caller.
Module['preRun'] = () => Object.assign(ENV, process.env);
