// The worker in which the module runs, so that the page never waits for a picture. Its
// source becomes a Blob: a page opened as a file may start no worker from a file.
function liveWorker() {
    let module;
    let ask;

    const start = async () => {
        const { exports } = await WebAssembly.instantiate(module, {});
        // Only a module of the reader's code has a `main`.
        exports.main?.(0, 0);
        ask = bindModule(exports);
    };

    // The least step of the browser's clock, in milliseconds: the least of some that are seen.
    const tick = () => {
        let least = Infinity;
        for (let steps = 0, last = performance.now(); steps < 5;) {
            const now = performance.now();
            if (now > last) {
                least = Math.min(least, now - last);
                last = now;
                steps += 1;
            }
        }
        return least;
    };

    onmessage = async ({ data: { id, request, numbers, ...given } }) => {
        try {
            if (given.module) {
                module = given.module;
                await start();
                postMessage({ id });
            } else if (given.tick) {
                postMessage({ id, answer: tick() });
            } else {
                const began = performance.now();
                const answer = ask(request, numbers);
                answer.milliseconds = performance.now() - began;
                postMessage({ id, answer }, [answer.pixels.buffer]);
            }
        } catch (error) {
            // After a trap, or too deep a recursion, the module's memory is in no known state.
            if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) {
                await start();
            }
            postMessage({ id, error: error.message });
        }
    };
}
