// The core of Cremona as an ES module, for pages and for node:
//
//   import { solve, check, verify } from './cremona.js';
//   const results = solve(model);      // as `cremona solve --json` has them; throws a ModelError, whose faults say why not
//   const faults = check(model);       // [{ severity: 'error' or 'warning', message }]
//   const { checks } = verify(model);  // what the model expects, and whether it is so
//
// A model is the text of a model file, or the object of its JSON. Beside this file lie cremona_core.js and
// cremona_core.wasm.
import createCremona from './cremona_core.js';

async function program() {
    const address = new URL('cremona_core.wasm', import.meta.url);
    if (address.protocol !== 'file:') return (await fetch(address)).arrayBuffer();
    const { readFile } = await import('node:fs/promises');
    return readFile(address);
}

const core = await createCremona({ wasmBinary: await program() });

// What is wrong with a model, or why it cannot be solved: `faults` as those of `check`.
export class ModelError extends Error {
    constructor(faults) {
        super(faults.map((fault) => fault.message).join('\n'));
        this.name = 'ModelError';
        this.faults = faults;
    }
}

function asked(call, model) {
    const text = core.allocateUTF8(typeof model === 'string' ? model : JSON.stringify(model));
    try {
        return JSON.parse(core.UTF8ToString(call(text)));
    } finally {
        core._free(text);
    }
}

function answered(call, model) {
    const answer = asked(call, model);
    if (answer.faults) throw new ModelError(answer.faults);
    return answer;
}

export const solve = (model) => answered(core._core_solve, model);
export const verify = (model) => answered(core._core_verify, model);
export const check = (model) => asked(core._core_check, model).faults;
