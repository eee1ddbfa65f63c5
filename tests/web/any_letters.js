// Letters at random, of `count` from the code `first` on, the same each time.
'use strict';

module.exports = (length, { seed, first, count }) => {
    let state = seed, text = '';
    while (text.length < length) {
        state = (48271 * state) % 2147483647;
        text += String.fromCharCode(first + (state % count));
    }
    return text;
};
