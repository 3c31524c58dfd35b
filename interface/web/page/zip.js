// Zip archives: zipOf() packs texts under their names, without compression; unzipped() reads any.
const crcTable = Uint32Array.from({ length: 256 }, (_, i) => {
    let value = i;
    for (let bit = 0; bit < 8; ++bit) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
    return value;
});
function crc32(bytes) {
    let sum = 0xffffffff;
    for (const byte of bytes) sum = crcTable[(sum ^ byte) & 0xff] ^ (sum >>> 8);
    return (sum ^ 0xffffffff) >>> 0;
}

// Little-endian numbers, each [value, bytes].
function record(...numbers) {
    const bytes = [];
    for (const [value, size] of numbers) for (let i = 0; i < size; ++i) bytes.push(Math.floor(value / 256 ** i) % 256);
    return Uint8Array.from(bytes);
}

function zipOf(files) {
    const parts = [];
    const entries = [];
    let offset = 0;
    const add = (list, ...pieces) => pieces.forEach((piece) => list.push(piece));
    for (const [name, content] of files) {
        const title = new TextEncoder().encode(name);
        const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
        // Version 2.0, names in UTF-8, stored; 1 January 2000.
        const common = [[20, 2], [0x800, 2], [0, 2], [0, 2], [0x2821, 2], [crc32(bytes), 4], [bytes.length, 4], [bytes.length, 4], [title.length, 2], [0, 2]];
        add(parts, record([0x04034b50, 4], ...common), title, bytes);
        add(entries, record([0x02014b50, 4], [20, 2], ...common, [0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]), title);
        offset += 30 + title.length + bytes.length;
    }
    const size = entries.reduce((sum, entry) => sum + entry.length, 0);
    const count = entries.length / 2;
    return new Blob([...parts, ...entries, record([0x06054b50, 4], [0, 2], [0, 2], [count, 2], [count, 2], [size, 4], [offset, 4], [0, 2])], { type: 'application/zip' });
}

// [[name, bytes], ...] of an archive. Throws where it is broken, encrypted or too large.
async function unzipped(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const [two, four] = [(at) => view.getUint16(at, true), (at) => view.getUint32(at, true)];
    let end = bytes.length - 22;
    while (four(end) !== 0x06054b50) --end;
    const files = [];
    let total = 0;
    for (let i = 0, entry = four(end + 16); i < two(end + 10); ++i) {
        const [method, sum, packed, size, title, local] = [two(entry + 10), four(entry + 16), four(entry + 20), four(entry + 24), two(entry + 28), four(entry + 42)];
        total += size;
        if (total > mostUnpacked) throw new Error('too large');
        const name = new TextDecoder().decode(bytes.subarray(entry + 46, entry + 46 + title));
        const begin = local + 30 + two(local + 26) + two(local + 28);
        const held = bytes.slice(begin, begin + packed);
        const content = method === 0 ? held : await decompressed(held, 'deflate-raw', size);
        if (crc32(content) !== sum) throw new Error('broken');
        if (!name.endsWith('/')) files.push([name, content]);
        entry += 46 + title + two(entry + 30) + two(entry + 32);
    }
    return files;
}

// Throws once there are more than `most` bytes, before the rest is unpacked.
async function decompressed(bytes, format, most = Infinity) {
    const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format)).getReader();
    const parts = [];
    let left = most;
    for (let next = await reader.read(); !next.done; next = await reader.read()) {
        left -= next.value.length;
        if (left < 0) throw new Error('too large');
        parts.push(next.value);
    }
    return new Uint8Array(await new Blob(parts).arrayBuffer());
}
