// The site can be opened again without a network (service_worker.js): what this page has loaded is kept.
'use strict';

if (navigator.serviceWorker && location.protocol.startsWith('http')) {
    const folder = document.currentScript.src.replace(/[^/]*$/, '');
    navigator.serviceWorker.register(folder + 'service_worker.js').catch((error) => console.info('not kept: ' + error));
    window.keepLoaded = async () => { // again when a program has loaded more
        const worker = (await navigator.serviceWorker.ready).active;
        worker.postMessage([location.href, ...performance.getEntriesByType('resource').map((entry) => entry.name)]);
    };
    window.addEventListener('load', window.keepLoaded);
}
