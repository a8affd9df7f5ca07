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

    onmessage = async ({ data: { id, request, numbers, ...given } }) => {
        try {
            if (given.module) {
                module = given.module;
                await start();
                postMessage({ id });
            } else {
                const answer = ask(request, numbers);
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
