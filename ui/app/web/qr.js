// QR codes (ISO/IEC 18004) of bytes, with the least error correction (L), of the smallest version that holds them.
'use strict';

var qr = (() => {
    // Of the versions 1 to 40: codewords of correction in a block, and blocks (table 9 of the standard).
    const correction = [7, 10, 15, 20, 26, 18, 20, 24, 30, 18, 20, 24, 26, 30, 22, 24, 28, 30, 28, 28, 28, 28, 30, 30,
                        26, 28, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30];
    const blocks = [1, 1, 1, 1, 1, 2, 2, 2, 2, 4, 4, 4, 4, 4, 6, 6, 6, 6, 7, 8, 8, 9, 9, 10, 12, 12, 12, 13, 14, 15, 16,
                    17, 18, 19, 19, 20, 21, 22, 24, 25];
    const masks = [
        (x, y) => (x + y) % 2, (x, y) => y % 2, (x) => x % 3, (x, y) => (x + y) % 3,
        (x, y) => (Math.floor(x / 3) + Math.floor(y / 2)) % 2, (x, y) => ((x * y) % 2) + ((x * y) % 3),
        (x, y) => (((x * y) % 2) + ((x * y) % 3)) % 2, (x, y) => (((x + y) % 2) + ((x * y) % 3)) % 2,
    ]; // a module is turned over where it is 0

    const side = (version) => 17 + 4 * version;

    // Along both axes, where the middles of the alignment patterns lie.
    function alignments(version) {
        if (version === 1) return [];
        const n = Math.floor(version / 7) + 2;
        const step = version === 32 ? 26 : Math.ceil((4 * version + 4) / (2 * n - 2)) * 2;
        const places = [6];
        for (let i = n - 2; i >= 0; --i) places.push(side(version) - 7 - step * i);
        return places;
    }

    // Codewords that have room beside the patterns.
    function codewords(version) {
        let modules = (16 * version + 128) * version + 64;
        const n = alignments(version).length;
        if (n > 0) modules -= (25 * n - 10) * n - 55;
        if (version >= 7) modules -= 36;
        return Math.floor(modules / 8);
    }

    const capacity = (version) => codewords(version) - correction[version - 1] * blocks[version - 1];
    const countBits = (version) => (version < 10 ? 8 : 16);

    function smallestVersion(nBytes) {
        for (let version = 1; version <= 40; ++version)
            if (4 + countBits(version) + 8 * nBytes <= 8 * capacity(version)) return version;
        return null;
    }

    // The mode, the count, the bytes, and what fills the rest.
    function data(bytes, version) {
        const bits = [];
        const append = (value, n) => { for (let i = n - 1; i >= 0; --i) bits.push((value >>> i) & 1); };
        const room = 8 * capacity(version);
        append(4, 4);
        append(bytes.length, countBits(version));
        for (const byte of bytes) append(byte, 8);
        append(0, Math.min(4, room - bits.length));
        append(0, (8 - (bits.length % 8)) % 8);
        for (let fill = 0xec; bits.length < room; fill ^= 0xec ^ 0x11) append(fill, 8);
        return Array.from({ length: room / 8 },
                          (_, i) => bits.slice(8 * i, 8 * i + 8).reduce((sum, bit) => 2 * sum + bit, 0));
    }

    // ---- Reed and Solomon, in the field of 256 elements with x^8 + x^4 + x^3 + x^2 + 1

    function product(a, b) {
        let sum = 0;
        for (let i = 7; i >= 0; --i) {
            sum = (sum << 1) ^ ((sum >>> 7) * 0x11d);
            sum ^= ((b >>> i) & 1) * a;
        }
        return sum;
    }

    // (x - 1)(x - 2)(x - 4) ..., its leading 1 left out.
    function generator(degree) {
        const coefficients = [...Array(degree - 1).fill(0), 1];
        for (let i = 0, root = 1; i < degree; ++i, root = product(root, 2))
            for (let j = 0; j < degree; ++j)
                coefficients[j] = product(coefficients[j], root) ^ (coefficients[j + 1] || 0);
        return coefficients;
    }

    function remainder(codes, divisor) {
        const rest = Array(divisor.length).fill(0);
        for (const code of codes) {
            const factor = code ^ rest.shift();
            rest.push(0);
            divisor.forEach((coefficient, i) => { rest[i] ^= product(coefficient, factor); });
        }
        return rest;
    }

    // The blocks with their corrections, one codeword of each in turn.
    function interleaved(codes, version) {
        const n = blocks[version - 1], divisor = generator(correction[version - 1]);
        const short = Math.floor(codes.length / n), nShort = n - (codes.length % n);
        const parts = [];
        for (let i = 0, begin = 0; i < n; ++i) {
            const size = short + (i < nShort ? 0 : 1);
            parts.push(codes.slice(begin, begin + size));
            begin += size;
        }
        const inTurn = (lists) => lists.at(-1).flatMap(
            (_, i) => lists.filter((list) => i < list.length).map((list) => list[i]));
        return [...inTurn(parts), ...inTurn(parts.map((part) => remainder(part, divisor)))];
    }

    // ---- the picture: rows of modules, true where dark

    const checked = (value, shift, divisor) => { // with the rest of a division of polynomials over 2
        let rest = value << shift;
        const degree = 31 - Math.clz32(divisor);
        for (let top = 31; top >= degree; --top) if ((rest >>> top) & 1) rest ^= divisor << (top - degree);
        return (value << shift) | rest;
    };

    class Picture {
        constructor(version) {
            this.version = version;
            this.size = side(version);
            this.dark = Array.from({ length: this.size }, () => Array(this.size).fill(false));
            this.isPattern = Array.from({ length: this.size }, () => Array(this.size).fill(false));
            this.drawPatterns();
        }

        set(x, y, isDark) {
            if (x < 0 || y < 0 || x >= this.size || y >= this.size) return;
            this.dark[y][x] = Boolean(isDark);
            this.isPattern[y][x] = true;
        }

        square(x, y, reach, isDark) { // isDark: of a module by its distance from the middle
            for (let dy = -reach; dy <= reach; ++dy)
                for (let dx = -reach; dx <= reach; ++dx)
                    this.set(x + dx, y + dy, isDark(Math.max(Math.abs(dx), Math.abs(dy))));
        }

        drawPatterns() {
            for (let i = 0; i < this.size; ++i) {
                this.set(6, i, i % 2 === 0);
                this.set(i, 6, i % 2 === 0);
            }
            const last = this.size - 4;
            for (const [x, y] of [[3, 3], [last, 3], [3, last]]) this.square(x, y, 4, (d) => d !== 2 && d !== 4);
            const places = alignments(this.version);
            const [first, end] = [places[0], places.at(-1)];
            for (const x of places)
                for (const y of places)
                    if (!((x === first && y !== end || x === end) && y === first || x === first && y === end))
                        this.square(x, y, 2, (d) => d !== 1);
            this.drawVersion();
            this.drawFormat(0);
        }

        drawVersion() {
            if (this.version < 7) return;
            const bits = checked(this.version, 12, 0x1f25);
            for (let i = 0; i < 18; ++i) {
                const along = this.size - 11 + (i % 3), across = Math.floor(i / 3);
                this.set(along, across, (bits >>> i) & 1);
                this.set(across, along, (bits >>> i) & 1);
            }
        }

        drawFormat(mask) {
            const levelL = 1;
            const bits = checked((levelL << 3) | mask, 10, 0x537) ^ 0x5412;
            const bit = (i) => (bits >>> i) & 1;
            for (let i = 0; i < 6; ++i) this.set(8, i, bit(i));
            this.set(8, 7, bit(6));
            this.set(8, 8, bit(7));
            this.set(7, 8, bit(8));
            for (let i = 9; i < 15; ++i) this.set(14 - i, 8, bit(i));
            for (let i = 0; i < 8; ++i) this.set(this.size - 1 - i, 8, bit(i));
            for (let i = 8; i < 15; ++i) this.set(8, this.size - 15 + i, bit(i));
            this.set(8, this.size - 8, true);
        }

        // Up and down in columns of two, from the right.
        drawCodes(codes) {
            let i = 0;
            for (let right = this.size - 1; right >= 1; right -= 2) {
                if (right === 6) right = 5;
                const goesUp = ((right + 1) & 2) === 0;
                for (let k = 0; k < this.size; ++k)
                    for (const x of [right, right - 1]) {
                        const y = goesUp ? this.size - 1 - k : k;
                        if (this.isPattern[y][x] || i >= 8 * codes.length) continue;
                        this.dark[y][x] = ((codes[i >>> 3] >>> (7 - (i & 7))) & 1) === 1;
                        ++i;
                    }
            }
        }

        turnOver(mask) {
            for (let y = 0; y < this.size; ++y)
                for (let x = 0; x < this.size; ++x)
                    if (!this.isPattern[y][x] && masks[mask](x, y) === 0) this.dark[y][x] = !this.dark[y][x];
        }

        // How hard it is to be read: runs, squares, what looks like a finder, too dark or too light.
        penalty() {
            const columns = this.dark[0].map((_, x) => this.dark.map((row) => row[x]));
            let sum = 0, nDark = 0;
            for (const line of [...this.dark, ...columns]) {
                const text = line.map((dark) => (dark ? '1' : '0')).join('');
                for (const run of text.match(/0{5,}|1{5,}/g) || []) sum += run.length - 2;
                sum += 40 * (text.match(/(?=10111010000|00001011101)/g) || []).length;
            }
            for (let y = 0; y < this.size; ++y)
                for (let x = 0; x < this.size; ++x) {
                    nDark += this.dark[y][x];
                    const square = [this.dark[y][x], this.dark[y][x - 1], this.dark[y - 1]?.[x], this.dark[y - 1]?.[x - 1]];
                    if (square.every((isDark) => isDark === square[0])) sum += 3;
                }
            return sum + 10 * Math.floor(Math.abs(20 * nDark - 10 * this.size ** 2) / this.size ** 2);
        }

        chooseMask() {
            let best = 0, least = Infinity;
            for (let mask = 0; mask < masks.length; ++mask) {
                this.drawFormat(mask);
                this.turnOver(mask);
                const penalty = this.penalty();
                if (penalty < least) [best, least] = [mask, penalty];
                this.turnOver(mask);
            }
            this.drawFormat(best);
            this.turnOver(best);
        }
    }

    // Rows of modules, true where dark, without the light margin of four; null where no code holds the text.
    function modules(text) {
        const bytes = new TextEncoder().encode(text);
        const version = smallestVersion(bytes.length);
        if (version === null) return null;
        const picture = new Picture(version);
        picture.drawCodes(interleaved(data(bytes, version), version));
        picture.chooseMask();
        return picture.dark;
    }

    return { modules, product, remainder, generator, capacity, codewords };
})();

if (typeof module !== 'undefined') module.exports = qr;
