// The core of Cremona for structures of members, as an ES module for pages and for node:
//
//   import { solve, check } from './cremona.js';
//   const results = solve(model); // as `cremona solve --json` has them; throws a ModelError, whose faults say why not
//   const faults = check(model);  // [{ severity: 'error' or 'warning', message }]
//
// A model is the text of a model file, or the object of its JSON. Beside this file lie module.js, cremona_core.js and
// cremona_core.wasm; cremona_all.js has more.
import createCremona from './cremona_core.js';
import { ModelError, load, text } from './module.js';

const core = await load(createCremona, 'cremona_core.wasm');

export { ModelError };
export const solve = (model) => core.answered('solve', text(model));
export const check = (model) => core.asked('check', text(model)).faults;
