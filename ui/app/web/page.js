// The page around an app: what the person gives it and what it gives back. Files live in the browser's memory:
//   /examples    those of the suite
//   /documents   opened by this page or dropped on it, and saved; kept from one visit to the next
//   /home        drafts of unsaved work and settings; kept too
// What the app writes into the first two is handed over as a download.
'use strict';

const language = new URLSearchParams(location.search).get('lang') || navigator.language;
const allTexts = {
    en: { open: 'Open a file…', over: 'The program has ended; load the page again to start it.',
          old: 'This browser is too old for this file: it cannot unpack it (DecompressionStream).' },
    pt: { open: 'Abrir um arquivo…', over: 'O programa terminou; recarregue a página para iniciá-lo.',
          old: 'Este navegador é antigo demais para este arquivo: não consegue descompactá-lo (DecompressionStream).' },
};
const texts = allTexts[language.startsWith('pt') ? 'pt' : 'en'];

const kept = ['/documents', '/home'];
const delivered = ['/documents', '/examples'];
const message = document.getElementById('message');

function tell(text) { message.textContent = text; }

// What the address asks for: ?open=/examples/truss.json&lang=pt_BR&theme=dark
function programArguments() {
    const asked = new URLSearchParams(location.search);
    const words = [];
    if (asked.has('handed')) words.push('-');
    for (const file of asked.getAll('open')) words.push(file);
    for (const option of ['lang', 'theme'])
        if (asked.has(option)) words.push('--' + option, asked.get(option));
    return words;
}

// A document that the page of another app gave to this one.
function handedDocument() {
    const key = new URLSearchParams(location.search).get('handed');
    const text = key && localStorage.getItem(key);
    if (key) localStorage.removeItem(key);
    return new TextEncoder().encode(text || '');
}

function openApp(program, text, options) {
    const key = 'cremona.handed.' + Date.now();
    localStorage.setItem(key, text);
    const address = new URL(program + '.html', location.href);
    address.searchParams.set('handed', key);
    const words = options.split('\n');
    for (let i = 0; i + 1 < words.length; i += 2)
        if (words[i] === '--lang' || words[i] === '--theme') address.searchParams.set(words[i].slice(2), words[i + 1]);
    return window.open(address) !== null;
}

// Kept files are read before the program starts; where the browser keeps none they last as long as the page.
function readKeptFiles() {
    for (const folder of kept) {
        FS.mkdirTree(folder);
        FS.mount(IDBFS, {}, folder);
    }
    addRunDependency('kept files');
    FS.syncfs(true, (error) => {
        if (error) console.warn('no files are kept: ' + error);
        removeLocks('/home');
        forEachDelivered((path, time) => handedOver.set(path, time));
        FS.chdir('/documents');
        removeRunDependency('kept files');
    });
}

// Of pages that are no more.
function removeLocks(folder) {
    for (const name of FS.readdir(folder)) {
        const path = folder + '/' + name;
        if (name === '.' || name === '..') continue;
        if (FS.isDir(FS.stat(path).mode)) removeLocks(path);
        else if (name.endsWith('.lock')) FS.unlink(path);
    }
}

let isKeeping = false;
function keepFiles() {
    if (isKeeping) return;
    isKeeping = true;
    FS.syncfs(false, () => { isKeeping = false; });
}

// The files of the folders that are delivered, with the time of their last change. Hidden ones are not yet whole.
function forEachDelivered(visit) {
    for (const folder of delivered)
        for (const name of FS.readdir(folder)) {
            const path = folder + '/' + name;
            if (!name.startsWith('.') && FS.isFile(FS.stat(path).mode)) visit(path, FS.stat(path).mtime.getTime());
        }
}

const handedOver = new Map(); // path: time of the change that the person has
function deliverNewFiles() {
    forEachDelivered((path, time) => {
        if (handedOver.get(path) === time) return;
        handedOver.set(path, time);
        download(path);
    });
}

function download(path) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([FS.readFile(path)]));
    link.download = path.slice(path.lastIndexOf('/') + 1);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

async function openFiles(files) {
    for (const file of files) {
        const path = '/documents/' + file.name.replace(/[/\\]/g, '_');
        FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
        handedOver.set(path, FS.stat(path).mtime.getTime());
        Module.openedFiles.push(path);
    }
    Module.canvas.focus();
}

function setEnvironment() {
    ENV.HOME = '/home';
    ENV.CREMONA_FONT_DIR = '/fonts';
    ENV.LANG = language.replace('-', '_') + '.UTF-8';
}

function listen() {
    const chooser = document.getElementById('file');
    document.getElementById('open').onclick = () => chooser.click();
    document.getElementById('open').textContent = texts.open;
    const entrance = document.querySelector('footer a');
    if (entrance && texts === allTexts.pt) entrance.href = 'index.pt_BR.html';
    chooser.onchange = () => { openFiles([...chooser.files]); chooser.value = ''; };
    document.addEventListener('dragover', (event) => event.preventDefault());
    document.addEventListener('drop', (event) => {
        event.preventDefault();
        openFiles([...event.dataTransfer.files]);
    });
    Module.canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    window.addEventListener('beforeunload', (event) => {
        if (document.title.startsWith('*')) event.preventDefault(); // unsaved changes
    });
    document.addEventListener('visibilitychange', keepFiles);
}

var Module = {
    canvas: document.getElementById('canvas'),
    arguments: programArguments(),
    openedFiles: [],
    openApp: openApp,
    preRun: [setEnvironment, readKeptFiles],
    stdin: (() => {
        const bytes = handedDocument();
        let next = 0;
        return () => (next < bytes.length ? bytes[next++] : null);
    })(),
    printErr: (text) => { console.warn(text); tell(text); },
    whenOver: () => tell(texts.over),
    onRuntimeInitialized: () => {
        tell('');
        setInterval(deliverNewFiles, 500);
        setInterval(keepFiles, 5000);
        Module.canvas.focus();
    },
};
listen();
