// A zip archive without compression: texts under their names.
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
