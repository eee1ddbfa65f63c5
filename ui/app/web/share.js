// A link that holds a document: in its fragment, which a browser sends to no server.
//   #m=1.DATA   1: the version of this form; DATA: the document's text in UTF-8, compressed (zlib), in base64url
'use strict';

var share = (() => {
    const version = '1';
    const longest = 8000;        // fragment that is made: mail programs and course pages break longer ones
    const longestRead = 100000;  // fragment that is read
    const largest = 1 << 20;     // document that is unpacked [bytes]: a fragment can hold a thousand times its size

    // Its message: 'cut' (or otherwise damaged), 'later' (a later version's), 'large', 'old' (the browser is).
    class Fault extends Error {}

    function base64url(bytes) {
        const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
        return btoa(letters).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
    }

    function bytesOf(text) {
        if (!/^[\w-]+$/.test(text)) throw new Fault('cut');
        const letters = atob(text.replace(/-/g, '+').replace(/_/g, '/'));
        return Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    }

    // No more than the limit is ever held.
    async function through(transformer, bytes, limit) {
        const reader = new Blob([bytes]).stream().pipeThrough(transformer).getReader();
        const parts = [];
        let size = 0;
        for (let part = await reader.read(); !part.done; part = await reader.read()) {
            size += part.value.length;
            if (size > limit) {
                reader.cancel().catch(() => {});
                throw new Fault('large');
            }
            parts.push(part.value);
        }
        return new Uint8Array(await new Blob(parts).arrayBuffer());
    }

    async function fragment(text) {
        const bytes = new TextEncoder().encode(text);
        if (bytes.length > largest) throw new Fault('large');
        const made = `#m=${version}.${base64url(await through(new CompressionStream('deflate'), bytes, largest))}`;
        if (made.length > longest) throw new Fault('large');
        return made;
    }

    async function unpacked(asked) {
        const [, of, data] = /^#m=(\d{1,4})\.(.*)$/.exec(asked) || [];
        if (of === undefined) throw new Fault('cut');
        if (of !== version) throw new Fault('later');
        if (asked.length > longestRead) throw new Fault('large');
        if (typeof DecompressionStream === 'undefined') throw new Fault('old');
        const bytes = await through(new DecompressionStream('deflate'), bytesOf(data), largest);
        return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    }

    // Whatever is wrong with a fragment otherwise, it is damaged.
    async function text(asked) {
        try {
            return await unpacked(asked);
        } catch (error) {
            throw error instanceof Fault ? error : new Fault('cut');
        }
    }

    const isAsked = (hash) => hash.startsWith('#m=');
    // The link of an address' fragment, or of its ?model=1.DATA; nothing where it has none.
    function linkOf(hash, model) {
        if (isAsked(hash)) return hash;
        return /^\d{1,4}\./.test(model || '') ? '#m=' + model : '';
    }

    return { fragment, text, longest, isAsked, linkOf };
})();

if (typeof module !== 'undefined') module.exports = share;
