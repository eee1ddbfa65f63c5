// All of Cremona that needs no hand, as an ES module for pages and for node; of plane models too:
//
//   import { solve, check, verify, render, cross, mohr, euler } from './cremona_all.js';
//   solve(model), check(model)          // as of cremona.js
//   verify(model)                       // { checks: [{ what, verdict, expected, result, tolerance }], passed, failed, skipped }
//   render(model, { show: 'loads,M' })  // the text of an SVG
//   cross(model, { method: 'kani' })    // as `cremona cross --json`
//   mohr({ stress: [50, -10, 40] })     // as `cremona mohr --json`
//   euler(script)                       // as `cremona euler --json`
//
// All throw a ModelError, whose faults say why not. Beside this file lie module.js, cremona_all_core.js and .wasm, and fonts/.
import createCremonaAll from './cremona_all_core.js';
import { ModelError, load, text } from './module.js';

const folder = '/usr/share/fonts/truetype/dejavu/';
const core = await load(createCremonaAll, 'cremona_all_core.wasm', {
    [folder + 'DejaVuSans.ttf']: 'fonts/DejaVuSans.ttf',
    [folder + 'DejaVuSans-Bold.ttf']: 'fonts/DejaVuSans-Bold.ttf',
});

// A line "key=value" each; a list has commas.
const lines = (details) => Object.entries(details).map(([key, value]) => `${key}=${value}`.replaceAll('\n', ' ')).join('\n');

export { ModelError };
export const solve = (model) => core.answered('solve', text(model));
export const check = (model) => core.asked('check', text(model)).faults;
export const verify = (model) => core.answered('verify', text(model));
export const render = (model, details = {}) => core.answered('render', text(model), lines(details)).svg;
export const cross = (model, details = {}) => core.answered('cross', text(model), lines(details));
export const mohr = (state) => core.answered('mohr', lines(state));
export const euler = (script) => core.answered('euler', script);
