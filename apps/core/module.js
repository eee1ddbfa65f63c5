// What cremona.js and cremona_all.js have in common: how their program is loaded and asked.

// The content of a file beside this one.
async function bytes(name) {
    const address = new URL(name, import.meta.url);
    if (address.protocol !== 'file:') return new Uint8Array(await (await fetch(address)).arrayBuffer());
    const { readFile } = await import('node:fs/promises');
    return readFile(address);
}

// What is wrong with a document, or why it cannot be solved: `faults` as those of `check`.
export class ModelError extends Error {
    constructor(faults) {
        super(faults.map((fault) => fault.message).join('\n'));
        this.name = 'ModelError';
        this.faults = faults;
    }
}

// A program, with these files in its memory. `asked` gives what a function of it answers to texts, `answered` throws faults.
export async function load(create, wasm, files = {}) {
    const contents = await Promise.all(Object.entries(files).map(async ([path, name]) => [path, await bytes(name)]));
    const program = await create({ wasmBinary: await bytes(wasm) });
    for (const [path, content] of contents) {
        program.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
        program.FS.writeFile(path, content);
    }
    const asked = (name, ...texts) => {
        const given = texts.map((text) => program.allocateUTF8(text));
        try {
            return JSON.parse(program.UTF8ToString(program['_core_' + name](...given)));
        } finally {
            given.forEach((text) => program._free(text));
        }
    };
    const answered = (...question) => {
        const answer = asked(...question);
        if (answer.faults) throw new ModelError(answer.faults);
        return answer;
    };
    return { asked, answered };
}

// A document as text: that of its file, or the object of its JSON.
export const text = (document) => (typeof document === 'string' ? document : JSON.stringify(document));
