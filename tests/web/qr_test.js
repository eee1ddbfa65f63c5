// QR codes under node: node qr_test.js
'use strict';

const assert = require('node:assert');
const qr = require('../../ui/app/web/qr.js');
const anyLetters = require('./any_letters.js');

const letters = (n) => anyLetters(n, { seed: 7, first: 48, count: 70 });

const isFinder = (rows, x0, y0) => rows.slice(y0, y0 + 7).every((row, y) => row.slice(x0, x0 + 7).every(
    (isDark, x) => isDark === (Math.max(Math.abs(x - 3), Math.abs(y - 3)) !== 2)));

const claims = {
    'a polynomial of the standard generates the corrections'() { // of degree 7, as exponents of 2
        const power = (n) => (n === 0 ? 1 : qr.product(power(n - 1), 2));
        assert.deepStrictEqual(qr.generator(7), [87, 229, 146, 149, 238, 102, 21].map(power));
    },
    'a block with its corrections is divided without a rest'() {
        const divisor = qr.generator(10), block = Array.from(letters(30), (letter) => letter.charCodeAt(0));
        assert.deepStrictEqual(qr.remainder([...block, ...qr.remainder(block, divisor)], divisor), Array(10).fill(0));
    },
    'codes hold what the standard says'() { // codewords of data at level L, table 7
        for (const [version, n] of [[1, 19], [2, 34], [5, 108], [7, 156], [10, 274], [20, 861], [40, 2956]])
            assert.strictEqual(qr.capacity(version), n);
        assert.strictEqual(qr.codewords(40), 3706);
    },
    'the smallest code is taken, and none holds more than the largest'() {
        for (const [n, size] of [[17, 21], [18, 25], [230, 53], [231, 57], [271, 57], [2953, 177]])
            assert.strictEqual(qr.modules(letters(n)).length, size);
        assert.strictEqual(qr.modules(letters(2954)), null);
    },
    'three corners have finders, the fourth has none'() {
        for (const n of [5, 100, 1000]) {
            const rows = qr.modules(letters(n)), far = rows.length - 7;
            const corners = [[0, 0], [far, 0], [0, far], [far, far]];
            assert.deepStrictEqual(corners.map(([x, y]) => isFinder(rows, x, y)), [true, true, true, false]);
        }
    },
    'both copies of the format say level L and the same mask'() {
        for (const n of [5, 60, 700]) {
            const rows = qr.modules(letters(n)), size = rows.length;
            const places = [[0, 8], [1, 8], [2, 8], [3, 8], [4, 8], [5, 8], [7, 8], [8, 8],
                            [8, 7], [8, 5], [8, 4], [8, 3], [8, 2], [8, 1], [8, 0]];
            const others = [...Array.from({ length: 7 }, (_, i) => [8, size - 1 - i]),
                            ...Array.from({ length: 8 }, (_, i) => [size - 8 + i, 8])];
            const [first, second] = [places, others].map(
                (list) => list.reduce((sum, [x, y]) => 2 * sum + rows[y][x], 0) ^ 0x5412);
            assert.strictEqual(first, second);
            assert.strictEqual(first >> 13, 1);
        }
    },
    'dark and light are about as many'() {
        const rows = qr.modules('a'.repeat(500)), dark = rows.flat().filter(Boolean).length / rows.length ** 2;
        assert.ok(dark > 0.42 && dark < 0.58, dark);
    },
};

for (const [claim, holds] of Object.entries(claims)) {
    holds();
    console.log('ok', claim);
}
