// Sends requests to the WebAssembly module: the only code that touches its memory.
//
// A request is a name and numbers. The answer has a text, the pixels of a picture,
// and lists of numbers by name.
function bindModule(exports) {
    const send = (part, bytes) => {
        // Reserving may move the memory, so it comes before the view.
        const address = exports.reserve(part, bytes.length);
        new Uint8Array(exports.memory.buffer, address, bytes.length).set(bytes);
    };
    const receive = (part) =>
        new Uint8Array(exports.memory.buffer, exports.part(part), exports.part_length(part)).slice();
    const text = (part) => new TextDecoder().decode(receive(part));

    return (request, numbers) => {
        send(0, new TextEncoder().encode(request));
        send(1, new Uint8Array(Float64Array.from(numbers).buffer));
        if (!exports.answer()) {
            throw new Error(text(0));
        }
        const answer = { text: text(0), pixels: receive(3) };
        const values = new Float64Array(receive(2).buffer);
        let start = 0;
        for (const list of text(1).split('\n').filter(Boolean)) {
            const [name, length] = list.split(' ');
            answer[name] = [...values.subarray(start, (start += Number(length)))];
        }
        return answer;
    };
}
