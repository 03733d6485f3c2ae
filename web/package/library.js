// SPDX-License-Identifier: MIT
// The C library as wasm: its memory, and text that goes in and comes out.

const decoder = new TextDecoder();
const encoder = new TextEncoder();

export class Library {
    constructor(exports) {
        this.calls = exports;
    }

    /** Memory may grow with any call, and then has another buffer. */
    get view() {
        if (this.last_view?.buffer !== this.calls.memory.buffer)
            this.last_view = new DataView(this.calls.memory.buffer);
        return this.last_view;
    }

    /** The text at an address; null at none. */
    text(at) {
        if (at === 0)
            return null;
        const bytes = new Uint8Array(this.calls.memory.buffer);
        return decoder.decode(bytes.subarray(at, bytes.indexOf(0, at)));
    }

    /** What `use` gives of the addresses of blocks of bytes that are there while it runs. */
    with_bytes(blocks, use) {
        const addresses = [];
        try {
            for (const block of blocks) {
                const at = this.calls.malloc(Math.max(block.length, 1));
                if (at === 0)
                    throw new RangeError('crease: memory ran out');
                addresses.push(at);
                new Uint8Array(this.calls.memory.buffer).set(block, at);
            }
            return use(...addresses);
        } finally {
            addresses.forEach((at) => this.calls.free(at));
        }
    }

    with_text(text, use) {
        return this.with_bytes([encoder.encode(`${text}\0`)], use);
    }
}

async function bytes_of(source) {
    if (source instanceof WebAssembly.Module || source instanceof ArrayBuffer || ArrayBuffer.isView(source))
        return source;
    const url = new URL(source);
    if (url.protocol === 'file:') {
        const {readFile} = await import('node:fs/promises');
        return readFile(url);
    }
    const answer = await fetch(url);
    if (!answer.ok)
        throw new Error(`crease: ${url} cannot be read: ${answer.status} ${answer.statusText}`);
    return answer.arrayBuffer();
}

/** What a standalone module wants of its host. */
const imports = {
    env: {emscripten_notify_memory_growth() {}},
    wasi_snapshot_preview1: {
        proc_exit() {
            throw new RangeError('crease: memory ran out');
        },
    },
};

export async function load_library(source) {
    const found = await bytes_of(source);
    const made = await WebAssembly.instantiate(found, imports);
    const {exports} = found instanceof WebAssembly.Module ? made : made.instance;
    exports._initialize();
    return new Library(exports);
}
