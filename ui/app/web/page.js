// The page around an app: what the person gives it and what it gives back. Files live in the browser's memory:
//   /examples    those of the suite
//   /documents   opened by this page or dropped on it, and saved; kept from one visit to the next
//   /home        drafts of unsaved work and settings; kept too
// What the app writes into the first two is handed over as a download.
'use strict';

const address = new URLSearchParams(location.search);
const language = address.get('lang') || navigator.language;
const allTexts = {
    en: { open: 'Open a file…', copy: 'Copy link',
          copied: 'The link was copied. It holds the document itself: {n} characters.',
          code: 'QR code', close: 'Close',
          here: 'The link, to be copied from here:',
          tooLarge: 'This document is too large for a link; send the file instead:',
          cut: 'The document in this link cannot be read: the link was cut off, or changed on its way.',
          later: 'This link was made by a later version of Cremona, and cannot be read by this one.',
          large: 'The document in this link is too large, and was not opened.',
          over: 'The program has ended; load the page again to start it.',
          print: 'Print…', words: 'The document and its results in words', keys: 'Keys for numbers',
          tooOld: 'This browser is too old: it needs WebAssembly with exceptions and vectors ' +
                  '(Chrome or Edge 95, Firefox 100, Safari 16.4, or later).',
          old: 'This browser is too old for this: it cannot unpack it (DecompressionStream).' },
    pt: { open: 'Abrir um arquivo…', copy: 'Copiar link',
          copied: 'O link foi copiado. Contém o próprio documento: {n} caracteres.',
          code: 'Código QR', close: 'Fechar',
          here: 'O link, para ser copiado daqui:',
          tooLarge: 'Este documento é grande demais para um link; envie o arquivo:',
          cut: 'O documento deste link não pode ser lido: o link foi cortado, ou mudado no caminho.',
          later: 'Este link foi feito por uma versão posterior do Cremona, e não pode ser lido por esta.',
          large: 'O documento deste link é grande demais, e não foi aberto.',
          over: 'O programa terminou; recarregue a página para iniciá-lo.',
          print: 'Imprimir…', words: 'O documento e seus resultados em palavras', keys: 'Teclas para números',
          tooOld: 'Este navegador é antigo demais: precisa de WebAssembly com exceções e vetores ' +
                  '(Chrome ou Edge 95, Firefox 100, Safari 16.4, ou posterior).',
          old: 'Este navegador é antigo demais para isto: não consegue descompactar (DecompressionStream).' },
};
const texts = allTexts[language.startsWith('pt') ? 'pt' : 'en'];

const kept = ['/documents', '/home'];
const delivered = ['/documents', '/examples'];
const message = document.getElementById('message');
const app = document.body.dataset.app;
const options = ['lang', 'theme', ...({ frame: ['show', 'case'], euler: ['step'] }[app] || [])]; // of an address

// Always as text: what a document holds is never read as HTML.
function tell(...parts) { message.replaceChildren(...parts); }

// A program of one function, which catches, and has a vector.
function hasExceptionsAndVectors() {
    const program = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0,
                     10, 13, 1, 11, 0, 6, 64, 65, 0, 253, 15, 26, 25, 11, 11];
    return typeof WebAssembly === 'object' && WebAssembly.validate(new Uint8Array(program));
}

// A page within another's shows what it is asked to (embed.js), and nothing that this browser keeps.
const isEmbedded = window.parent !== window;
const isLocked = address.get('locked') === '1';
const isBare = isLocked || address.get('panels') === 'none';
const link = share.linkOf(location.hash, address.get('model'));

// What the address asks for: #m=1.DATA, or ?open=/examples/truss.json; and &lang=pt_BR&theme=dark
function programArguments() {
    const words = [];
    const files = [...address.getAll('open'), ...address.getAll('model')];
    if (link || address.has('handed')) words.push('-');
    else for (const file of files) words.push(file);
    for (const option of options) if (address.get(option)) words.push(`--${option}=${address.get(option)}`);
    if (isBare) words.push('--bare');
    if (isLocked) words.push('--no-tools');
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) words.push('--still');
    return words;
}

// A document that the page of another app gave to this one, or that the link holds: what the program reads as input.
let input = '';
function readHandedDocument() {
    const key = address.get('handed');
    if (key) input = localStorage.getItem(key) || '';
    if (key) localStorage.removeItem(key);
    if (link) readLink();
}

let warning = ''; // that stays when the program has begun
function readLink() {
    addRunDependency('document of the link');
    share.text(link).then((text) => { input = text; }, (fault) => {
        warning = texts[fault.message];
        Module.arguments.splice(Module.arguments.indexOf('-'), 1);
    }).finally(() => removeRunDependency('document of the link'));
}

// The address of this page with the document that is shown, and how it is shown.
async function linkToDocument([text, ...shown]) {
    const address = new URL(location.pathname, location.href);
    for (let i = 0; i + 1 < shown.length; i += 2)
        if (options.includes(shown[i].slice(2))) address.searchParams.set(shown[i].slice(2), shown[i + 1]);
    return address.href + await share.fragment(text);
}

async function copyLink() {
    const copy = Module.copyOfDocument();
    if (copy.length === 0) return; // the program has told why
    const link = await linkToDocument(copy).catch(() => null);
    if (link === null) tell(texts.tooLarge + ' ', fileLink(copy[0]));
    else if (await isCopied(link)) tell(texts.copied.replace('{n}', link.length) + ' ', ...codeButton(link));
    else tell(texts.here + ' ', fieldWith(link));
    Module.canvas.focus();
}

// A code of more is too fine for a telephone; and none reads a file of this machine.
function codeButton(link) {
    const longestCode = 2000;
    if (link.length > longestCode || !link.startsWith('http')) return [];
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = texts.code;
    button.onclick = () => showCode(qr.modules(link));
    return [button];
}

function showCode(modules) {
    const dialog = document.getElementById('code');
    const margin = 4, across = modules.length + 2 * margin; // modules, light ones around
    const pixels = Math.max(2, Math.floor(Math.min(innerWidth, innerHeight, 1000) * 0.8 / across)); // of a module
    const canvas = dialog.querySelector('canvas');
    canvas.width = canvas.height = pixels * across;
    const context = canvas.getContext('2d');
    context.fillStyle = '#fff';
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.fillStyle = '#000';
    modules.forEach((row, y) => row.forEach((isDark, x) => {
        if (isDark) context.fillRect(pixels * (x + margin), pixels * (y + margin), pixels, pixels);
    }));
    dialog.querySelector('button').textContent = texts.close;
    dialog.showModal();
}

async function isCopied(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false; // not allowed, or a page that did not come by https or from this machine
    }
}

function fieldWith(text) {
    const field = document.createElement('input');
    field.readOnly = true;
    field.value = text;
    field.onfocus = () => field.select();
    return field;
}

function fileLink(text) {
    const link = document.createElement('a');
    link.download = 'document' + ({ euler: '.eul', mohr: '.mohr' }[app] || '.json');
    link.href = URL.createObjectURL(new Blob([text]));
    link.textContent = link.download;
    return link;
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
        if (!isEmbedded) FS.mount(IDBFS, {}, folder);
    }
    addRunDependency('kept files');
    FS.syncfs(true, async (error) => {
        if (error) console.warn('no files are kept: ' + error);
        removeLocks('/home');
        forEachDelivered((path, time) => handedOver.set(path, time));
        FS.chdir('/documents');
        if (beginsInPortuguese()) await loadPortuguese();
        removeRunDependency('kept files');
    });
}

// As the program itself decides: by the address, else as it was left, else by the browser.
function beginsInPortuguese() {
    const settings = `/home/.local/state/cremona/${app}/settings`;
    const left = FS.analyzePath(settings).exists ? FS.readFile(settings, { encoding: 'utf8' }) : '';
    const asLeft = /^language (\S+)/m.exec(left);
    return (address.get('lang') || (asLeft ? asLeft[1] : language)).startsWith('pt');
}

// What the program translates by, which it does not hold itself: most people read one language.
async function loadPortuguese() {
    if (Module.portuguese !== undefined) return;
    const fetched = () => fetch('pt_BR.po').then((answer) => answer.text());
    Module.portuguese = await (Module.packedPortuguese || fetched)().catch(() => undefined);
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
    if (isKeeping || isEmbedded) return;
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
        if (path.endsWith('.html')) tell(path.slice(path.lastIndexOf('/') + 1) + ' ', printButton(path));
    });
}

// A report becomes a PDF by the browser's own print.
function printButton(path) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = texts.print;
    button.onclick = () => {
        const frame = document.createElement('iframe');
        frame.style = 'position: fixed; width: 0; height: 0; border: 0; visibility: hidden'; // laid out, and not seen
        frame.src = URL.createObjectURL(new Blob([FS.readFile(path)], { type: 'text/html' }));
        frame.onload = () => {
            frame.contentWindow.onafterprint = () => frame.remove();
            frame.contentWindow.print();
        };
        document.body.append(frame);
    };
    return button;
}

// The document in words beside the picture, a paragraph a line: of a change those lines are read that are others.
const region = document.getElementById('words');
function showWords() {
    const begin = performance.now();
    const lines = (Module.description ? Module.description() : '').split('\n').filter((line) => line);
    const took = performance.now() - begin;
    const old = [...region.children].map((paragraph) => paragraph.textContent);
    let first = 0, last = 0; // lines that stay, at the beginning and at the end
    const fewer = Math.min(lines.length, old.length);
    while (first < fewer && lines[first] === old[first]) ++first;
    while (last < fewer - first && lines[lines.length - 1 - last] === old[old.length - 1 - last]) ++last;
    [...region.children].slice(first, old.length - last).forEach((paragraph) => paragraph.remove());
    const changed = lines.slice(first, lines.length - last).map((line) => {
        const paragraph = document.createElement('p');
        paragraph.textContent = line;
        return paragraph;
    });
    if (region.children[first]) region.children[first].before(...changed);
    else region.append(...changed);
    setTimeout(showWords, Math.max(2000, 50 * took));
}

// Keys for numbers, while a field is typed into on a screen that is touched.
const keypad = document.getElementById('keypad');
let isTouched = false;
function makeKeypad() {
    for (const key of [...'1234567890.,-e', 'Backspace', 'Tab', 'Enter']) {
        const button = document.createElement('button');
        button.type = 'button';
        button.textContent = { Backspace: '⌫', Tab: '⇥', Enter: '⏎', '-': '−' }[key] || key;
        button.setAttribute('aria-label', key);
        button.onpointerdown = (event) => {
            event.preventDefault(); // the picture keeps the keyboard
            for (const kind of ['keydown', 'keyup'])
                Module.canvas.dispatchEvent(new KeyboardEvent(kind, { key: key, bubbles: true, cancelable: true }));
        };
        keypad.append(button);
    }
    keypad.setAttribute('aria-label', texts.keys);
    window.addEventListener('pointerdown', (event) => { isTouched = event.pointerType === 'touch'; }, true);
    setInterval(() => { keypad.hidden = !(isTouched && Module.wantsText); }, 100);
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
    document.body.classList.toggle('bare', isBare);
    region.setAttribute('aria-label', texts.words);
    makeKeypad();
    const chooser = document.getElementById('file');
    document.getElementById('open').onclick = () => chooser.click();
    document.getElementById('open').textContent = texts.open;
    const entrance = document.querySelector('footer a');
    if (entrance && texts === allTexts.pt) entrance.href = 'index.pt_BR.html';
    document.getElementById('copy').onclick = copyLink;
    document.getElementById('copy').hidden = typeof CompressionStream === 'undefined';
    document.getElementById('copy').textContent = texts.copy;
    window.addEventListener('hashchange', () => { if (share.isAsked(location.hash)) location.reload(); });
    chooser.onchange = () => { openFiles([...chooser.files]); chooser.value = ''; };
    document.addEventListener('dragover', (event) => event.preventDefault());
    document.addEventListener('drop', (event) => {
        event.preventDefault();
        if (!isLocked) openFiles([...event.dataTransfer.files]);
    });
    Module.canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    window.addEventListener('beforeunload', (event) => {
        if (document.title.startsWith('*') && !isEmbedded) event.preventDefault(); // unsaved changes
    });
    document.addEventListener('visibilitychange', keepFiles);
}

var Module = {
    canvas: document.getElementById('canvas'),
    arguments: programArguments(),
    openedFiles: [],
    openApp: openApp,
    preRun: [setEnvironment, readKeptFiles, readHandedDocument],
    stdin: () => null,
    printErr: (text) => {
        console.warn(text);
        tell(hasExceptionsAndVectors() ? text : texts.tooOld);
    },
    whenOver: () => {
        document.getElementById('copy').disabled = true;
        tell(texts.over);
    },
    onRuntimeInitialized: () => {
        FS.unlink('/dev/stdin'); // a device, of which an app would read no document
        FS.writeFile('/dev/stdin', input);
        tell(warning);
        setTimeout(showWords, 1000);
        setTimeout(loadPortuguese, 1000); // for who changes the language
        if (window.keepLoaded) window.keepLoaded(); // offline.js, where there is a server
        document.getElementById('copy').disabled = false;
        setInterval(deliverNewFiles, 500);
        setInterval(keepFiles, 5000);
        embed.begin();
        if (!isEmbedded) Module.canvas.focus();
    },
};
listen();
