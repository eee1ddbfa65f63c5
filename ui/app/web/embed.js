// An app within a page of somebody else: <iframe src="frame.html?model=/examples/truss.json&panels=none&locked=1">,
// and the messages by which that page asks it:
//   { cremona: 1, id, set: MODEL }       the document, as the text of a file or as the object of its JSON
//   { cremona: 1, id, get: 'model' }     its text; 'results': as `cremona solve --json` has them, an object, null where
//                                        there are none; 'description': document and results in words
//   { cremona: 1, id, run: 'view.fit', argument: '' }   a command by its name
// Each is answered by { cremona: 1, id, ok: true, value } or { cremona: 1, id, ok: false, reason }. By itself the app
// sends { cremona: 1, event: 'ready', app } once, and { cremona: 1, event: 'change', app } when the document has become
// another. It hears the page around it alone, if that is of the same origin or of one that the address names:
// &allow=https://course.example
'use strict';

var embed = (() => {
    const largest = 1 << 24; // document that is taken [characters]
    const allowed = [location.origin, ...new URLSearchParams(location.search).getAll('allow')];
    const isAllowed = (origin) => origin !== 'null' && allowed.includes(origin);
    const ending = () => ({ euler: '.eul', mohr: '.mohr' }[document.body.dataset.app] || '.json');

    function setModel(model) {
        const text = typeof model === 'string' ? model : JSON.stringify(model);
        if (typeof text !== 'string' || text.length > largest) return 'the model is no text, or too large';
        const path = '/tmp/model' + ending();
        FS.writeFile(path, text);
        return Module.replaceDocument(path);
    }

    function value(name) {
        const results = () => { const text = Module.results(); return text ? JSON.parse(text) : null; };
        return new Map([['model', () => Module.copyOfDocument()[0]], ['results', results],
                        ['description', () => Module.description()]]).get(name);
    }

    // What is asked is data of another page: of a wrong kind, it is refused.
    function answer(asked) {
        const done = (reason) => (reason ? { ok: false, reason } : { ok: true, value: null });
        if (!Module.runCommand) return { ok: false, reason: 'the program has ended' };
        if ('set' in asked) return done(setModel(asked.set));
        if ('run' in asked) return done(Module.runCommand(String(asked.run), String(asked.argument || '')));
        const give = value(asked.get);
        return give ? { ok: true, value: give() } : { ok: false, reason: 'wanted set, get or run' };
    }

    function tryToAnswer(asked) {
        try {
            return answer(asked);
        } catch (error) {
            return { ok: false, reason: String(error.message) };
        }
    }

    const waiting = []; // for the program
    let isReady = false;
    function reply(event) {
        event.source.postMessage({ cremona: 1, id: event.data.id, ...tryToAnswer(event.data) }, event.origin);
    }

    window.addEventListener('message', (event) => {
        const isOurs = event.data && typeof event.data === 'object' && event.data.cremona === 1;
        if (!isOurs || event.source !== window.parent || window.parent === window || !isAllowed(event.origin)) return;
        if (isReady) reply(event);
        else waiting.push(event);
    });

    // Of the page around this one: of browsers that do not tell, by whom this page was asked for.
    function parentOrigin() {
        if (location.ancestorOrigins) return location.ancestorOrigins[0];
        return document.referrer ? new URL(document.referrer).origin : 'null';
    }

    function tellParent(event) {
        if (isAllowed(parentOrigin()))
            window.parent.postMessage({ cremona: 1, event, app: document.body.dataset.app }, parentOrigin());
    }

    function followChanges(before) {
        if (!Module.copyOfDocument) return;
        const now = Module.copyOfDocument()[0];
        if (now !== before) tellParent('change');
        setTimeout(() => followChanges(now), 250);
    }

    // The program draws from its first frame on.
    function begin() {
        if (window.parent === window) return;
        if (!Module.copyOfDocument) return void setTimeout(begin, 50);
        isReady = true;
        tellParent('ready');
        waiting.splice(0).forEach(reply);
        followChanges(Module.copyOfDocument()[0]);
    }

    // ---- locked: it is looked at, moved and zoomed, and read under the pointer; nothing changes it but messages

    const stop = (event) => event.stopImmediatePropagation();
    function withMiddleButton(event) {
        if (!event.isTrusted || event.target.id !== 'canvas') return;
        stop(event);
        event.preventDefault();
        const { clientX, clientY, screenX, screenY } = event;
        const place = { clientX, clientY, screenX, screenY };
        event.target.dispatchEvent(new MouseEvent(event.type, { button: 1, bubbles: true, ...place }));
    }
    if (new URLSearchParams(location.search).get('locked') === '1') {
        for (const kind of ['keydown', 'keyup', 'keypress', 'paste', 'dblclick'])
            window.addEventListener(kind, stop, true);
        for (const kind of ['mousedown', 'mouseup']) window.addEventListener(kind, withMiddleButton, true);
        for (const kind of ['touchstart', 'touchmove'])
            window.addEventListener(kind, (event) => { if (event.touches.length < 2) stop(event); }, true);
    }

    return { begin };
})();
