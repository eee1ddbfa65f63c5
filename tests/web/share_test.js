// Documents in links, under node: node share_test.js
'use strict';

const assert = require('node:assert');
const zlib = require('node:zlib');
const share = require('../../ui/app/web/share.js');
const anyLetters = require('./any_letters.js');

const url = (bytes) => Buffer.from(bytes).toString('base64url');
const packed = (text) => '#m=1.' + url(zlib.deflateSync(text));
const refused = (fragment, fault) => assert.rejects(share.text(fragment), { message: fault });

// Letters that do not compress, the same each time.
const noise = (size) => anyLetters(size, { seed: 1, first: 33, count: 90 });

const claims = {
    async 'what was packed comes out the same'() {
        for (const text of ['{}', '{"title": "Pórtico σ 梁 😀"}\n', 'x'.repeat(100000), '\u0000 "</script>'])
            assert.strictEqual(await share.text(await share.fragment(text)), text);
    },
    async 'a fragment is made of letters that no address changes'() {
        assert.match(await share.fragment(noise(5000)), /^#m=1\.[\w-]+$/);
    },
    async 'a document that is too large for a link is told'() {
        await assert.rejects(share.fragment(noise(20000)), { message: 'large' });
        await assert.rejects(share.fragment('x'.repeat(2 << 20)), { message: 'large' });
    },
    async 'a link that is cut anywhere is refused'() {
        const whole = packed('{"nodes": [1, 2, 3], "members": [4, 5, 6]}');
        for (let n = 3; n < whole.length; ++n) await refused(whole.slice(0, n), 'cut');
    },
    async 'no letter of a link can be another one and give another document'() {
        const document = '{"nodes": [1, 2, 3], "members": [4, 5, 6]}', whole = packed(document);
        let n_refused = 0;
        for (let n = 6; n < whole.length; ++n) {
            const other = whole.slice(0, n) + (whole[n] === 'A' ? 'B' : 'A') + whole.slice(n + 1);
            const read = await share.text(other).catch((fault) => { ++n_refused; return fault.message; });
            assert.ok(read === document || read === 'cut', read);
        }
        assert.ok(n_refused > whole.length - 10); // some bits at the end of a compressed text mean nothing
    },
    async 'what inflates to 10 MB is refused, before it is there'() {
        await refused(packed(Buffer.alloc(10 << 20)), 'large');
        await refused(packed(Buffer.alloc((1 << 20) + 1, 'x')), 'large');
        assert.strictEqual((await share.text(packed(Buffer.alloc(1 << 20, 'x')))).length, 1 << 20);
    },
    async 'a fragment that is too long is not unpacked'() { await refused('#m=1.' + 'A'.repeat(200000), 'large'); },
    async 'a later version says so'() {
        await refused(packed('{}').replace('#m=1.', '#m=2.'), 'later');
        await refused('#m=17.whatever', 'later');
    },
    async 'what is no link at all is refused'() {
        for (const other of ['#m=', '#m=1.', '#m=x', '#m=1.%3Cscript%3E', '#m=1.<b>', '#m=-1.AAAA', '#m=1.===='])
            await refused(other, 'cut');
    },
    async 'bytes that are no text are refused'() { await refused(packed(Buffer.from([0xff, 0xfe, 0x80])), 'cut'); },
};

(async () => {
    for (const [claim, holds] of Object.entries(claims)) {
        await holds();
        console.log('ok', claim);
    }
})().catch((error) => { console.error(error); process.exit(1); });
