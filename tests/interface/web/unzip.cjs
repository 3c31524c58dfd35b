// The texts in a zip archive without compression, by their names.
'use strict';

function unzip(bytes) {
    const end = bytes.lastIndexOf(Buffer.from('PK\x05\x06', 'latin1'));
    const files = new Map();
    let entry = bytes.readUInt32LE(end + 16);
    for (let i = 0; i < bytes.readUInt16LE(end + 10); ++i) {
        const [size, title, extra, comment] = [bytes.readUInt32LE(entry + 24), bytes.readUInt16LE(entry + 28), bytes.readUInt16LE(entry + 30), bytes.readUInt16LE(entry + 32)];
        const local = bytes.readUInt32LE(entry + 42);
        const begin = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
        files.set(bytes.toString('utf8', entry + 46, entry + 46 + title), bytes.toString('utf8', begin, begin + size));
        entry += 46 + title + extra + comment;
    }
    return files;
}

module.exports = { unzip };
