// The site without a network: the server's files while it answers, what is kept of them where it does not. Kept are the
// pages that are read, from the first visit on, and of the apps those that were opened.
'use strict';

const ourCaches = `cremona ${self.registration.scope} `;
const cacheName = ourCaches + '@version@'; // of other versions nothing is kept
const readPages = @pages@;

self.addEventListener('install', (event) => {
    self.skipWaiting();
    event.waitUntil(caches.open(cacheName).then((cache) => cache.addAll(readPages)));
});

self.addEventListener('activate', (event) => event.waitUntil((async () => {
    const others = (await caches.keys()).filter((name) => name.startsWith(ourCaches) && name !== cacheName);
    await Promise.all(others.map((name) => caches.delete(name)));
    await self.clients.claim();
})()));

const isOurs = (address) => address.startsWith(self.registration.scope);

self.addEventListener('fetch', (event) => {
    if (event.request.method === 'GET' && isOurs(event.request.url)) event.respondWith(answer(event.request));
});

const withoutQuestion = (address) => address.replace(/[?#].*/, ''); // a page is one file, whatever it is asked to open

async function answer(request) {
    const cache = await caches.open(cacheName);
    const file = withoutQuestion(request.url);
    try {
        const answered = await fetch(request);
        if (answered.status === 200) await cache.put(file, answered.clone());
        return answered;
    } catch (error) {
        const kept = await cache.match(file);
        if (kept) return kept;
        throw error;
    }
}

// What a page had loaded before this worker was there.
self.addEventListener('message', (event) => event.waitUntil((async () => {
    const cache = await caches.open(cacheName);
    for (const file of event.data.filter(isOurs).map(withoutQuestion))
        if (!await cache.match(file)) await cache.add(file);
})()));
