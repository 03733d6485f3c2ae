// SPDX-License-Identifier: MIT
// Serves a folder to this machine: serve.mjs FOLDER [PORT]
import {createReadStream, statSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join, normalize} from 'node:path';
import {pathToFileURL} from 'node:url';

const types = {
    '.html': 'text/html; charset=utf-8',
    '.js': 'text/javascript; charset=utf-8',
    '.css': 'text/css; charset=utf-8',
    '.json': 'application/json',
    '.svg': 'image/svg+xml',
    '.png': 'image/png',
    '.wasm': 'application/wasm',
};

/** A server of a folder; listens on a free port where none is given. */
export function serve(folder, port = 0) {
    const server = createServer((request, answer) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
        const file = join(folder, path.endsWith('/') ? `${path}index.html` : path);
        if (!statSync(file, {throwIfNoEntry: false})?.isFile()) {
            answer.writeHead(404).end();
            return;
        }
        answer.writeHead(200, {'Content-Type': types[extname(file)] ?? 'application/octet-stream', 'Cache-Control': 'no-cache'});
        createReadStream(file).pipe(answer);
    });
    return new Promise((resolve, reject) => {
        server.once('error', reject);
        server.listen(port, '127.0.0.1', () => resolve({server, address: `http://localhost:${server.address().port}/`}));
    });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
    const {address} = await serve(process.argv[2], Number(process.argv[3] ?? 8000));
    console.log(address);
}
