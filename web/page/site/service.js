// Keeps the page for times without a network. The page asks for nothing else.
const cache = 'snell-{{version}}';
const files = {{files}};

self.addEventListener('install', (event) => {
    event.waitUntil(caches.open(cache).then((kept) => kept.addAll(files.map((name) => new Request(name, { cache: 'reload' })))).then(() => self.skipWaiting()));
});

// A page that is open has all that it needs: older versions go.
self.addEventListener('activate', (event) => {
    const old = (name) => name.startsWith('snell-') && name !== cache;
    event.waitUntil(caches.keys().then((names) => Promise.all(names.filter(old).map((name) => caches.delete(name)))).then(() => self.clients.claim()));
});

self.addEventListener('fetch', (event) => {
    if (event.request.method !== 'GET') return;
    event.respondWith(caches.open(cache).then((kept) => kept.match(event.request, { ignoreSearch: true })).then((found) => found ?? fetch(event.request)));
});
